#pragma once

#include "core/plan/problem/order_costs.h"
#include "core/plan/proof/certified.h"

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
    /** Starts from `lambda`, one per node; [0] is set to 0. */
    explicit MultiplierAscent(Eigen::VectorXd lambda);

    /** Returns the best certified bound since the last restart; -infinity before the first step. */
    [[nodiscard]] double bound() const { return m_bound; }
    /** Returns the present multipliers. */
    [[nodiscard]] const Eigen::VectorXd& here() const { return m_lambda; }
    /** Returns the multipliers of the best bound. */
    [[nodiscard]] const Eigen::VectorXd& best() const { return m_best; }

    /** Restarts from the best multipliers, for another graph. */
    void restart();

    /** Result of the relaxation at the multipliers `here`. */
    struct Relaxed
    {
        FleetPlan paths;   ///< shortest path of each UAV; may visit an iceberg twice or never
        double bound = 0;  ///< sum lambda + lengths
        double margin = 0; ///< rounding margin of the bound
    };
    /**
     * Makes a step; `target` is the incumbent's cost. Returns false, and makes no step, if every
     * iceberg is visited once: no multipliers give a better bound. A step along the remainder of
     * earlier directions, which fades while the distance to the incumbent does not, would become
     * arbitrarily large.
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
 * Returns first multipliers, about the cost of each iceberg: the shortest leg to it, and for
 * waiting the integral over sigma of t(sigma), a line fitted to the order. At that multiplier an
 * iceberg of any sigma is indifferent to a small change of its position.
 */
[[nodiscard]] Eigen::VectorXd firstMultipliers(const VisitCosts& costs, const VisitOrder& order);

/**
 * Returns first multipliers for latency: the shortest leg to each iceberg, at the mean weight of
 * the legs of the order.
 */
[[nodiscard]] Eigen::VectorXd firstMultipliers(const LatencyCosts& costs, const VisitOrder& order);

} // namespace berg
