#include "core/plan/proof/multiplier_ascent.h"

#include <algorithm>

namespace berg {

namespace {

/** Returns the shortest leg to each iceberg from any node. */
Eigen::VectorXd shortestLegs(const LegTable& costs)
{
    Eigen::VectorXd shortest = Eigen::VectorXd::Zero(costs.icebergs + 1);
    for (const NodeIndex j : icebergNodes(costs.icebergs)) {
        double& least = shortest(j.number());
        least = costs.leg(0, j);
        for (const NodeIndex i : icebergNodes(costs.icebergs))
            if (i != j)
                least = std::min(least, costs.leg(i, j));
    }
    return shortest;
}

} // namespace

MultiplierAscent::MultiplierAscent(Eigen::VectorXd lambda) : m_lambda(std::move(lambda))
{
    m_lambda(0) = 0;
    m_best = m_lambda;
    m_direction = Eigen::VectorXd::Zero(m_lambda.size());
}

void MultiplierAscent::restart()
{
    m_lambda = m_best;
    m_direction.setZero();
    m_bound = -std::numeric_limits<double>::infinity();
    m_step = kFirstStep;
    m_idle = 0;
}

bool MultiplierAscent::step(const Relaxed& relaxed, double target)
{
    const double bound = relaxed.bound - relaxed.margin;
    m_idle = bound > m_bound + 1e-7 * target ? 0 : m_idle + 1;
    if (m_idle >= kPatience) {
        m_step *= 0.7;
        m_idle = 0;
    }
    if (bound > m_bound) {
        m_bound = bound;
        m_best = m_lambda;
    }
    Eigen::VectorXd gradient = Eigen::VectorXd::Ones(m_lambda.size());
    gradient(0) = 0;
    for (const VisitOrder& path : relaxed.paths)
        for (const NodeIndex i : path)
            gradient(i.number()) -= 1;
    if (gradient.isZero(0)) {
        m_direction.setZero();
        return false;
    }
    m_direction = gradient + 0.7 * m_direction;
    const double norm = m_direction.squaredNorm();
    if (norm > 0)
        m_lambda += m_step * std::max(target - relaxed.bound, 0.0) / norm * m_direction;
    return true;
}

Eigen::VectorXd firstMultipliers(const VisitCosts& costs, const VisitOrder& order)
{
    const int n = costs.icebergs;
    const Eigen::VectorXd sigma = Eigen::Map<const Eigen::VectorXd>(costs.sigma.data(), n + 1);
    Eigen::VectorXd t = Eigen::VectorXd::Zero(n + 1);
    for (int k = 0; k < n; ++k)
        t(order[static_cast<std::size_t>(k)].number()) = k + 2;
    const double meanSigma = sigma.tail(n).mean();
    const double meanT = t.tail(n).mean();
    const Eigen::ArrayXd deviation = sigma.tail(n).array() - meanSigma;
    const double square = deviation.square().sum();
    const double slope =
        square > 0 ? (deviation * (t.tail(n).array() - meanT)).sum() / square : 0.0;

    // The fit is about the mean: between nearly equal sigmas the slope can be arbitrarily large,
    // and the factor it is multiplied with is as small.
    Eigen::VectorXd multipliers = shortestLegs(costs);
    multipliers.tail(n).array() += meanT * sigma.tail(n).array() + slope * deviation.square() / 2;
    return multipliers;
}

Eigen::VectorXd firstMultipliers(const LatencyCosts& costs, const VisitOrder& order)
{
    double length = 0;
    NodeIndex from;
    for (const NodeIndex to : order) {
        length += costs.leg(from, to);
        from = to;
    }
    const double meanWeight = length > 0 ? costs.total(order) / length : 0.0;
    return meanWeight * shortestLegs(costs);
}

} // namespace berg
