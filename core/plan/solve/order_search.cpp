#include "core/plan/solve/order_search.h"

#include "core/plan/proof/certified.h"

#include <algorithm>
#include <array>
#include <utility>

namespace berg {

namespace {

/** Work of one partner of an iceberg: seven moves evaluated. Measured. */
template <class Costs>
constexpr std::int64_t kWorkOfNeighbour = Costs::kWeighted ? 20 : 8;

/**
 * Descent by first improvement over icebergs, best move of each iceberg. Icebergs without an
 * improving move are examined again only when their neighbours have changed.
 */
template <class Costs>
class Descent
{
public:
    Descent(const Costs& costs, const VisitOrder& order, SearchEffort& effort)
        : m_moves(costs, order), m_effort(effort), m_active(order.size() + 1, true)
    {
    }

    [[nodiscard]] double cost() const { return m_moves.cost(); }
    [[nodiscard]] VisitOrder order() const { return m_moves.order(); }

    void assign(const VisitOrder& order) { m_moves.assign(order); }
    /** Makes a move, good or bad. */
    void make(const OrderMove& move)
    {
        const int end = m_moves.icebergs() + 1;
        for (const int position : {move.first - 1, move.first, move.first + 1, move.last - 1,
                                   move.last, move.last + 1, move.after, move.after + 1})
            m_active[toIndex(m_moves.at(std::clamp(position, 0, end)))] = true;
        m_moves.apply(move);
    }

    /** Descends to a local optimum, or until the effort is spent. */
    void run()
    {
        const double least = kLeastGain * cost();
        for (bool again = true; again;) {
            again = false;
            for (int position = 1; position <= m_moves.icebergs(); ++position) {
                const std::size_t node = toIndex(m_moves.at(position));
                if (!m_active[node])
                    continue;
                m_effort.work += kWorkOfNeighbour<Costs> * m_moves.icebergs();
                if (m_effort.work >= m_effort.limit)
                    return;
                if (++m_examined % kExaminedPerCheck == 0 && m_effort.isStopped &&
                    m_effort.isStopped())
                    return;
                again = true;
                const OrderMove move = m_moves.bestMoveAt(position);
                if (move.delta < -std::max(least, m_moves.rounding()))
                    make(move);
                else
                    m_active[node] = false;
            }
        }
    }

private:
    static constexpr int kExaminedPerCheck = 16;

    OrderMoves<Costs> m_moves;
    SearchEffort& m_effort;
    std::vector<bool> m_active; ///< by node
    int m_examined = 0;
};

/** Criterion by which the next iceberg of a greedy order is chosen. */
enum class GreedyCriterion
{
    Nearest,  ///< shortest leg
    Ratio,    ///< shortest leg per sigma
    Sigma,    ///< largest sigma
    Earlier,  ///< leg minus the cost of waiting for a fraction of the remaining time, Eq. (1)
    Earliest, ///< that with twice the fraction
};

/** Returns the value of a candidate; smaller is better. */
double greedyValue(GreedyCriterion criterion, double leg, double sigma, int left)
{
    constexpr double kFraction = 0.125;
    switch (criterion) {
    case GreedyCriterion::Nearest:
        return leg;
    case GreedyCriterion::Ratio:
        return leg / (sigma + 1e-9); // sigma 0 comes last
    case GreedyCriterion::Sigma:
        return -sigma;
    case GreedyCriterion::Earlier:
        return leg - kFraction * sigma * left;
    case GreedyCriterion::Earliest:
        return leg - 2 * kFraction * sigma * left;
    }
    return leg;
}

/** Returns a greedy order. Ties go to the shorter leg, then to the smaller number. */
VisitOrder greedyOrder(const LegTable& costs, GreedyCriterion criterion)
{
    VisitOrder order;
    std::vector<bool> used(costs.sigma.size(), false);
    for (int left = costs.icebergs; left > 0; --left) {
        const NodeIndex from = order.empty() ? NodeIndex() : order.back();
        NodeIndex best;
        std::pair<double, double> least;
        for (const NodeIndex j : icebergNodes(costs.icebergs)) {
            if (used[toIndex(j)])
                continue;
            const double leg = costs.leg(from, j);
            const std::pair value{greedyValue(criterion, leg, costs.sigmaOf(j), left), leg};
            if (best == 0 || value < least) {
                best = j;
                least = value;
            }
        }
        used[toIndex(best)] = true;
        order.push_back(best);
    }
    return order;
}

/**
 * Returns a move that exchanges two neighbouring pieces of the order: no single move of the descent
 * undoes it.
 */
OrderMove disturbance(Random& random, int icebergs)
{
    constexpr int kWidest = 50;
    const int width = std::min(icebergs, kWidest);
    const auto draw = [&random](int count) {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
    };
    const int start = draw(icebergs - width + 1);
    std::array<int, 3> ends{};
    do {
        for (int& end : ends)
            end = start + draw(width + 1);
        std::sort(ends.begin(), ends.end());
    } while (ends[0] == ends[1] || ends[1] == ends[2]);
    OrderMove move;
    move.kind = OrderMove::Kind::Relocate;
    move.first = ends[0] + 1;
    move.last = ends[1];
    move.after = ends[2];
    return move;
}

} // namespace

template <class Costs>
OrderSearch<Costs>::OrderSearch(const Costs& costs, SearchEffort& effort)
    : m_costs(costs), m_effort(effort), m_random(2015, static_cast<std::uint64_t>(costs.icebergs))
{
}

template <class Costs>
void OrderSearch<Costs>::startGreedily()
{
    accept(greedyOrder(m_costs, GreedyCriterion::Nearest));
}

template <class Costs>
void OrderSearch<Costs>::descend()
{
    descendFrom(m_best);
}

template <class Costs>
void OrderSearch<Costs>::descendFromGreedyOrders()
{
    for (const GreedyCriterion criterion :
         {GreedyCriterion::Nearest, GreedyCriterion::Ratio, GreedyCriterion::Sigma,
          GreedyCriterion::Earlier, GreedyCriterion::Earliest}) {
        if (m_effort.spent())
            return;
        descendFrom(greedyOrder(m_costs, criterion));
        m_effort.work += std::int64_t{m_costs.icebergs} * m_costs.icebergs;
    }
}

template <class Costs>
void OrderSearch<Costs>::disturb(std::int64_t restarts)
{
    if (m_costs.icebergs < 3)
        return; // a descent tries all orders
    Descent descent(m_costs, m_best, m_effort);
    VisitOrder current = m_best;
    double currentCost = m_bestCost;
    for (std::int64_t done = 0; done < restarts && !m_effort.spent(); ++done) {
        descent.make(disturbance(m_random, m_costs.icebergs));
        descent.run();
        accept(descent.order());
        // Slightly worse orders are accepted, with decreasing tolerance: without that the search
        // stays near one local optimum.
        const double progress = static_cast<double>(done) / static_cast<double>(restarts);
        const double tolerance = 0.4 / m_costs.icebergs * (1 - progress);
        if (descent.cost() <= currentCost * (1 + tolerance)) {
            currentCost = descent.cost();
            current = descent.order();
        } else {
            descent.assign(current);
        }
    }
}

template <class Costs>
void OrderSearch<Costs>::descendFrom(const VisitOrder& order)
{
    Descent descent(m_costs, order, m_effort);
    descent.run();
    accept(descent.order());
}

template <class Costs>
void OrderSearch<Costs>::accept(const VisitOrder& order)
{
    const double cost = m_costs.total(order);
    if (!m_best.empty() && cost >= m_bestCost * (1 - kLeastGain))
        return;
    m_best = order;
    m_bestCost = cost;
    if (onImproved)
        onImproved(m_best);
}

template class OrderSearch<VisitCosts>;
template class OrderSearch<LatencyCosts>;

} // namespace berg
