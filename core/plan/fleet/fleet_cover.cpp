#include "core/plan/fleet/fleet_cover.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace berg {

namespace {

using Order = FleetOrders::Order;
using Candidates = std::vector<const Order*>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/** Orders between two checks for a stop. */
constexpr std::size_t kOrdersPerCheck = 16'384;

/** A partial plan: orders of some UAVs. */
struct Choice
{
    NodeSet visited;
    double excess = 0;
    Candidates orders;
};

template <class Visitor>
void forEach(const NodeSet& set, const Visitor& visitor)
{
    for (std::size_t word = 0; word < set.words.size(); ++word)
        for (std::uint64_t left = set.words[word]; left != 0; left &= left - 1)
            visitor(NodeIndex::of(static_cast<int>(64 * word) + std::countr_zero(left)));
}

bool disjoint(const NodeSet& a, const NodeSet& b)
{
    return (a & b) == NodeSet{};
}

/** Depth-first search that branches on the row (iceberg or UAV) with the fewest orders. */
class SetPartitioningSearch
{
public:
    SetPartitioningSearch(const FleetOrders& orders, double slack, std::int64_t workLimit,
                          const StopCheck& isStopped)
        : m_orders(orders)
        , m_slack(slack)
        , m_workLimit(workLimit)
        , m_isStopped(isStopped)
        , m_byUav(static_cast<std::size_t>(orders.uavs()))
    {
        for (const NodeIndex i : icebergNodes(orders.icebergs()))
            m_all.insert(i);
        for (int uav = 0; uav < orders.uavs(); ++uav)
            acceptOrders(uav);
    }

    void run()
    {
        if (!m_stopped)
            branch({}, m_candidates);
    }
    [[nodiscard]] bool complete() const { return !m_stopped; }
    [[nodiscard]] std::int64_t work() const { return m_work; }
    [[nodiscard]] const std::optional<Choice>& best() const { return m_best; }

private:
    /**
     * Adds the orders UAV by UAV, because sorting all at once would visitor too long between two
     * checks for a stop.
     */
    void acceptOrders(int uav)
    {
        Candidates ordersOfUav;
        for (std::size_t k = 0; k < m_orders.all().size(); ++k) {
            const Order& order = m_orders.all()[k];
            if (checkStop(1))
                return;
            if (order.uav != uav)
                continue;
            ordersOfUav.push_back(&order);
            m_byUav[static_cast<std::size_t>(uav)].entry(order.visited.hash(), [&](int other) {
                return m_orders.all()[static_cast<std::size_t>(other)].visited == order.visited;
            }) = static_cast<int>(k);
        }
        if (countWork(ordersOfUav.size()))
            return;
        sortByExcess(ordersOfUav);
        if (countWork(ordersOfUav.size()))
            return;
        m_candidates = merged(m_candidates, ordersOfUav);
    }

    [[nodiscard]] static bool isLess(const Order* a, const Order* b)
    {
        return a->excess < b->excess;
    }
    [[nodiscard]] static Candidates merged(std::span<const Order* const> a,
                                           std::span<const Order* const> b)
    {
        Candidates all;
        all.reserve(a.size() + b.size());
        std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all), isLess);
        return all;
    }
    /** Sorts stably: pieces first, then pairs of them, with checks for a stop in between. */
    void sortByExcess(Candidates& orders)
    {
        constexpr std::size_t kPiece = kOrdersPerCheck / 4;
        const auto part = [&orders](std::size_t begin, std::size_t end) {
            return std::span(orders).subspan(begin, std::min(end, orders.size()) - begin);
        };
        for (std::size_t k = 0; k < orders.size() && !checkStop(kOrdersPerCheck); k += kPiece)
            std::ranges::stable_sort(part(k, k + kPiece), isLess);
        for (std::size_t width = kPiece; width < orders.size(); width *= 2)
            for (std::size_t k = 0; k + width < orders.size() && !checkStop(width); k += 2 * width)
                std::ranges::copy(merged(part(k, k + width), part(k + width, k + 2 * width)),
                                  orders.begin() + static_cast<std::ptrdiff_t>(k));
    }

    bool countWork(std::size_t examined)
    {
        m_work += static_cast<std::int64_t>(examined) + 1;
        return checkStop(examined);
    }
    /** Checks for a stop without counting work. */
    bool checkStop(std::size_t examined)
    {
        m_sinceCheck += examined + 1;
        if (m_sinceCheck > kOrdersPerCheck) {
            m_sinceCheck = 0;
            m_stopped = m_stopped || m_work >= m_workLimit || (m_isStopped && m_isStopped());
        }
        return m_stopped;
    }

    void branch(const Choice& choice, const Candidates& candidates)
    {
        const auto chosen = static_cast<int>(choice.orders.size());
        if (chosen == m_orders.uavs()) {
            if (choice.visited == m_all && choice.excess < m_slack) {
                m_slack = choice.excess;
                m_best = choice;
            }
            return;
        }
        if (chosen + 1 == m_orders.uavs()) {
            finish(choice);
            return;
        }
        if (countWork(candidates.size()))
            return;
        const Row row = fewest(choice, candidates);
        Candidates left;
        for (const Order* order : candidates) {
            if (!row.has(*order))
                continue;
            if (choice.excess + order->excess >= m_slack)
                break; // the candidates are sorted by excess
            const Choice next = with(choice, *order);
            if (countWork(candidates.size()))
                return;
            if (compatible(next, candidates, left))
                branch(next, left);
        }
    }

    /** A UAV or an iceberg that needs an order. */
    struct Row
    {
        std::optional<int> uav = {}; ///< nullopt if the row is of an iceberg
        NodeIndex iceberg;           ///< valid without `uav`
        [[nodiscard]] bool has(const Order& order) const
        {
            return uav ? order.uav == *uav : order.visited.contains(iceberg);
        }
    };

    static Choice with(Choice choice, const Order& order)
    {
        choice.excess += order.excess;
        choice.orders.push_back(&order);
        for (std::size_t word = 0; word < choice.visited.words.size(); ++word)
            choice.visited.words[word] |= order.visited.words[word];
        return choice;
    }
    [[nodiscard]] static bool flies(const Choice& choice, int uav)
    {
        return std::any_of(choice.orders.begin(), choice.orders.end(),
                           [uav](const Order* order) { return order->uav == uav; });
    }

    /** Gives the remaining icebergs to the last UAV if it can visit them. */
    void finish(const Choice& choice)
    {
        int uav = 0;
        while (flies(choice, uav))
            ++uav;
        NodeSet rest = m_all;
        for (std::size_t word = 0; word < rest.words.size(); ++word)
            rest.words[word] &= ~choice.visited.words[word];
        const auto at = [this](int number) -> const Order& {
            return m_orders.all()[static_cast<std::size_t>(number)];
        };
        const std::optional<int> number = m_byUav[static_cast<std::size_t>(uav)].find(
            rest.hash(), [&](int other) { return at(other).visited == rest; });
        if (number)
            branch(with(choice, at(*number)), {});
    }

    /**
     * Collects in `left` the candidates that fit the choice in a plan below the slack. Returns
     * false if no such plan is possible.
     */
    bool compatible(const Choice& choice, const Candidates& candidates, Candidates& left) const
    {
        left.clear();
        std::vector<double> least(static_cast<std::size_t>(m_orders.uavs()), kInfinity);
        for (const Order* chosen : choice.orders)
            least[static_cast<std::size_t>(chosen->uav)] = 0;
        std::vector<bool> taken(least.size(), false);
        for (const Order* chosen : choice.orders)
            taken[static_cast<std::size_t>(chosen->uav)] = true;
        for (const Order* order : candidates) {
            if (choice.excess + order->excess >= m_slack)
                break;
            const auto uav = static_cast<std::size_t>(order->uav);
            if (taken[uav] || !disjoint(order->visited, choice.visited))
                continue;
            least[uav] = std::min(least[uav], order->excess);
            left.push_back(order);
        }
        double sum = choice.excess;
        for (const double excess : least)
            sum += excess;
        if (sum >= m_slack)
            return false;
        std::erase_if(left, [&](const Order* order) {
            return sum - least[static_cast<std::size_t>(order->uav)] + order->excess >= m_slack;
        });
        return true;
    }

    [[nodiscard]] Row fewest(const Choice& choice, const Candidates& candidates) const
    {
        std::vector<std::size_t> byUav(static_cast<std::size_t>(m_orders.uavs()), 0);
        std::vector<std::size_t> byIceberg(static_cast<std::size_t>(m_orders.icebergs()) + 1, 0);
        for (const Order* order : candidates) {
            ++byUav[static_cast<std::size_t>(order->uav)];
            forEach(order->visited, [&](NodeIndex i) { ++byIceberg[toIndex(i)]; });
        }
        Row row;
        std::size_t least = std::numeric_limits<std::size_t>::max();
        for (int uav = 0; uav < m_orders.uavs(); ++uav)
            if (!flies(choice, uav) && byUav[static_cast<std::size_t>(uav)] < least) {
                least = byUav[static_cast<std::size_t>(uav)];
                row = {.uav = uav};
            }
        for (const NodeIndex i : icebergNodes(m_orders.icebergs()))
            if (!choice.visited.contains(i) && byIceberg[toIndex(i)] < least) {
                least = byIceberg[toIndex(i)];
                row = {.iceberg = i};
            }
        return row;
    }

    const FleetOrders& m_orders;
    double m_slack;
    std::int64_t m_workLimit;
    const StopCheck& m_isStopped;
    NodeSet m_all;
    Candidates m_candidates;
    std::vector<NumberTable> m_byUav; ///< numbers of orders by the set they visit
    std::optional<Choice> m_best;
    std::int64_t m_work = 0;
    std::size_t m_sinceCheck = 0;
    bool m_stopped = false;
};

} // namespace

FleetCover bestCover(const FleetOrders& orders, double slack, std::int64_t workLimit,
                     const StopCheck& isStopped)
{
    SetPartitioningSearch search(orders, slack, workLimit, isStopped);
    search.run();
    FleetCover cover{.complete = search.complete(), .plan = {}, .work = search.work()};
    if (search.best()) {
        cover.plan.emplace(static_cast<std::size_t>(orders.uavs()));
        for (const Order* order : search.best()->orders)
            (*cover.plan)[static_cast<std::size_t>(order->uav)] = orders.icebergsOf(*order);
    }
    return cover;
}

} // namespace berg
