#include "core/plan/proof/layered_paths.h"

#include "core/base/error.h"

#include <limits>

namespace berg {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Levels between two checks for a stop. */
constexpr int kLevelsPerCheck = 16;

/** Returns for each element the least of all others. */
Eigen::ArrayXd leastOfOthers(const Eigen::ArrayXd& values)
{
    Eigen::Index first = 0;
    Eigen::ArrayXd least = Eigen::ArrayXd::Constant(values.size(), values.minCoeff(&first));
    Eigen::ArrayXd others = values;
    others(first) = kInfinity;
    least(first) = others.minCoeff();
    return least;
}

} // namespace

LayeredPaths<VisitCosts>::LayeredPaths(const VisitCosts& costs)
    : m_costs(&costs)
    , m_legs(costs.legs.bottomRightCorner(costs.icebergs, costs.icebergs).array())
    , m_lengths(costs.icebergs, costs.icebergs)
{
    m_legs.matrix().diagonal().setConstant(kInfinity);
}

double LayeredPaths<VisitCosts>::sweep(const Multipliers& multipliers, const StopCheck& isStopped)
{
    const Eigen::Index n = m_costs->icebergs;
    const Eigen::ArrayXd sigma = Eigen::Map<const Eigen::ArrayXd>(m_costs->sigma.data() + 1, n);
    const Eigen::ArrayXd lambda = multipliers.lambda.tail(n).array();
    m_lengths.col(0) = m_costs->legs.col(0).tail(n).array() + 2 * sigma - lambda;
    Eigen::ArrayXd least(n);
    for (Eigen::Index p = 1; p < n; ++p) {
        if (isStopped && isStopped())
            return -kInfinity;
        least.setConstant(kInfinity);
        Eigen::Index i = 0;
        for (; i + 3 < n; i += 4) // four at once, so that `least` is read and written once
            least = least
                        .min((m_legs.col(i) + m_lengths(i, p - 1))
                                 .min(m_legs.col(i + 1) + m_lengths(i + 1, p - 1)))
                        .min((m_legs.col(i + 2) + m_lengths(i + 2, p - 1))
                                 .min(m_legs.col(i + 3) + m_lengths(i + 3, p - 1)));
        for (; i < n; ++i)
            least = least.min(m_legs.col(i) + m_lengths(i, p - 1));
        m_lengths.col(p) = least + static_cast<double>(p + 2) * sigma - lambda;
    }
    Eigen::Index last = 0;
    const Eigen::ArrayXd pathBack = m_costs->legs.row(0).tail(n).transpose().array();
    const double length = (m_lengths.col(n - 1) + pathBack).minCoeff(&last);
    m_last = NodeIndex::of(last + 1);
    return multipliers.sum + length;
}

VisitOrder LayeredPaths<VisitCosts>::shortestPath() const
{
    VisitOrder path(static_cast<std::size_t>(m_costs->icebergs));
    path.back() = m_last;
    for (int p = m_costs->icebergs - 1; p >= 1; --p) {
        Eigen::Index before = 0;
        const NodeIndex to = path[static_cast<std::size_t>(p)];
        // Only the least one matters: the cost of the visit is the same for all.
        (m_lengths.col(p - 1) + m_legs.row(to.number() - 1).transpose()).minCoeff(&before);
        path[static_cast<std::size_t>(p) - 1] = NodeIndex::of(before + 1);
    }
    return path;
}

LayeredPaths<LatencyCosts>::LayeredPaths(const LatencyCosts& costs)
    : m_costs(&costs)
    , m_legs(costs.legs.bottomRightCorner(costs.icebergs, costs.icebergs).transpose().array())
    , m_completion(costs.icebergs, costs.lastLevel() + 1)
{
    m_legs.matrix().diagonal().setConstant(kInfinity);
}

Eigen::ArrayXd LayeredPaths<LatencyCosts>::onwards(int level) const
{
    const int n = m_costs->icebergs;
    Eigen::ArrayXd result(n);
    for (const NodeIndex j : icebergNodes(n)) {
        const int next = level + m_costs->step(j);
        result(j.number() - 1) =
            next <= m_costs->lastLevel() ? completion(j, next) - m_lambda(j.number()) : kInfinity;
    }
    return result;
}

Eigen::ArrayXd LayeredPaths<LatencyCosts>::leastOnwards(const Eigen::ArrayXd& after,
                                                        double weight) const
{
    if (weight == 0) // the infinite diagonal must not be multiplied with 0
        return leastOfOthers(after);
    Eigen::ArrayXd least = Eigen::ArrayXd::Constant(after.size(), kInfinity);
    const auto through = [&](Eigen::Index j) { return weight * m_legs.col(j) + after(j); };
    Eigen::Index waiting = -1; // two at once, so that `least` is read and written once
    for (Eigen::Index j = 0; j < after.size(); ++j) {
        if (after(j) == kInfinity)
            continue;
        if (waiting < 0) {
            waiting = j;
        } else {
            least = least.min(through(waiting).min(through(j)));
            waiting = -1;
        }
    }
    if (waiting >= 0)
        least = least.min(through(waiting));
    return least;
}

double LayeredPaths<LatencyCosts>::sweep(const Multipliers& multipliers, const StopCheck& isStopped)
{
    const Eigen::Index n = m_costs->icebergs;
    m_lambda = multipliers.lambda;
    m_completion.col(m_costs->lastLevel()).setZero();
    for (int level = m_costs->lastLevel() - 1; level >= 1; --level) {
        if (level % kLevelsPerCheck == 0 && isStopped && isStopped())
            return -kInfinity;
        const double weight = m_costs->leastUnseen(level);
        if (weight < kInfinity)
            m_completion.col(level) = leastOnwards(onwards(level), weight);
        else
            m_completion.col(level).setConstant(kInfinity);
    }
    const Eigen::ArrayXd legs = m_costs->legs.col(0).tail(n).array();
    return multipliers.sum + (m_costs->leastUnseen(0) * legs + onwards(0)).minCoeff();
}

VisitOrder LayeredPaths<LatencyCosts>::shortestPath() const
{
    VisitOrder path;
    int level = 0;
    NodeIndex from;
    while (level < m_costs->lastLevel()) {
        const Eigen::ArrayXd after = onwards(level);
        double least = kInfinity;
        NodeIndex next;
        for (const NodeIndex j : icebergNodes(m_costs->icebergs)) {
            const double length =
                m_costs->leastUnseen(level) * m_costs->leg(from, j) + after(j.number() - 1);
            if (j != from && length < least) {
                least = length;
                next = j;
            }
        }
        require(next > 0, "LayeredPaths: no path although all costs are finite");
        path.push_back(next);
        level += m_costs->step(next);
        from = next;
    }
    return path;
}

} // namespace berg
