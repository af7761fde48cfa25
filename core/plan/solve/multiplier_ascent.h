#pragma once

#include "core/plan/solve/certified.h"
#include "core/plan/solve/order_costs.h"

#include <limits>
#include <vector>

namespace berg {

/**
 * Subgradient ascent of the multipliers of "each iceberg once": step length by the distance to
 * the incumbent (Polyak 1969), direction deflected by the one before (Camerini, Fratta and
 * Maffioli 1975).
 */
class MultiplierAscent
{
public:
    /** `lambda`: one per node, [0] is taken as 0. */
    explicit MultiplierAscent(Eigen::VectorXd lambda);

    /** Best certified bound since the last restart; -infinity before the first step. */
    [[nodiscard]] double bound() const { return m_bound; }
    [[nodiscard]] const Eigen::VectorXd& here() const { return m_lambda; }
    [[nodiscard]] const Eigen::VectorXd& best() const { return m_best; }

    /** For another graph: goes on from the best multipliers. */
    void restart();

    /** What the multipliers `here` gave. */
    struct Relaxed
    {
        std::vector<int> visits; ///< of the shortest path, or of all routes' paths
        double bound = 0;        ///< sum lambda + its length
        double margin = 0;       ///< of the bound
    };
    /**
     * `target` is the incumbent's cost. False, and no step, where every iceberg is visited once: no
     * multipliers give a better bound. A step along what is left of earlier directions, which
     * fades while the distance to the incumbent does not, would go beyond all measure.
     */
    [[nodiscard]] bool step(const Relaxed& relaxed, double target);

private:
    static constexpr double kFirstStep = 0.4;
    static constexpr int kPatience = 8;

    Eigen::VectorXd m_lambda;
    Eigen::VectorXd m_best;
    Eigen::VectorXd m_direction;
    double m_bound = -std::numeric_limits<double>::infinity();
    double m_step = kFirstStep;
    int m_idle = 0;
};

/**
 * First multipliers: about what an iceberg must cost. The shortest leg to it, and for waiting the
 * integral over sigma of t(sigma), a line fitted to the order: at that price an iceberg of any
 * sigma is indifferent to a small change of its position.
 */
[[nodiscard]] Eigen::VectorXd firstMultipliers(const VisitCosts& costs, const VisitOrder& order);

/** For latency: the shortest leg to it, at the mean weight of the legs of the order. */
[[nodiscard]] Eigen::VectorXd firstMultipliers(const LatencyCosts& costs, const VisitOrder& order);

} // namespace berg
