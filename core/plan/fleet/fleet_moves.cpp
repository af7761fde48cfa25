#include "core/plan/fleet/fleet_moves.h"

#include "core/plan/proof/certified.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr std::int64_t kWorkOfOrder = 20;

/** Stores the best of the moves offered. */
class Chooser
{
public:
    Chooser(const FleetRoutes& routes, SearchEffort& effort) : m_routes(routes), m_effort(effort) {}

    /** Returns whether the effort lasts; called once for each position of an order. */
    [[nodiscard]] bool continues() const { return !m_effort.spent(); }

    void offer(const FleetMove::Part& part)
    {
        m_effort.work += kWorkOfOrder;
        const double before = m_routes.cost(part.uav);
        storeIfBetter(before - m_routes.cost(part.uav, part.pieces), before, {part, {}}, 1);
    }
    void offer(const FleetMove::Part& a, const FleetMove::Part& b)
    {
        m_effort.work += 2 * kWorkOfOrder;
        const double before = m_routes.cost(a.uav) + m_routes.cost(b.uav);
        const double after = m_routes.cost(a.uav, a.pieces) + m_routes.cost(b.uav, b.pieces);
        storeIfBetter(before - after, before, {a, b}, 2);
    }

    FleetMove best;

private:
    void storeIfBetter(double gain, double before, const std::array<FleetMove::Part, 2>& parts,
                       int count)
    {
        if (gain > best.gain && gain > kLeastGain * before)
            best = {.gain = gain, .parts = parts, .partCount = count};
    }

    const FleetRoutes& m_routes;
    SearchEffort& m_effort;
};

void offerTurns(Chooser& chooser, int uav, int size)
{
    for (int begin = 0; begin < size && chooser.continues(); ++begin)
        for (int end = begin + 2; end <= size; ++end)
            chooser.offer({uav, {{{uav, 0, begin}, {uav, begin, end, true}, {uav, end, size}}}});
}

void offerExchanges(Chooser& chooser, int uav, int size)
{
    for (int a = 0; a < size && chooser.continues(); ++a)
        for (int b = a + 2; b < size; ++b)
            chooser.offer({uav,
                           {{{uav, 0, a},
                             {uav, b, b + 1},
                             {uav, a + 1, b},
                             {uav, a, a + 1},
                             {uav, b + 1, size}}}});
}

void offerShifts(Chooser& chooser, int uav, int size)
{
    for (int begin = 0; begin < size && chooser.continues(); ++begin)
        for (int end = begin + 1; end <= std::min(size, begin + kLongestPiece); ++end)
            for (int place = 0; place <= size; ++place) {
                if (place >= begin && place <= end)
                    continue;
                for (const bool backwards : {false, true}) {
                    const RoutePiece piece{uav, begin, end, backwards};
                    if (place < begin)
                        chooser.offer(
                            {uav,
                             {{{uav, 0, place}, piece, {uav, place, begin}, {uav, end, size}}}});
                    else
                        chooser.offer(
                            {uav,
                             {{{uav, 0, begin}, {uav, end, place}, piece, {uav, place, size}}}});
                }
            }
}

} // namespace

FleetMove bestMoveWithin(const FleetRoutes& routes, int uav, SearchEffort& effort)
{
    Chooser chooser(routes, effort);
    const int size = routes.length(uav);
    offerTurns(chooser, uav, size);
    offerExchanges(chooser, uav, size);
    offerShifts(chooser, uav, size);
    return chooser.best;
}

FleetMove bestMoveBetween(const FleetRoutes& routes, int from, int to, SearchEffort& effort)
{
    Chooser chooser(routes, effort);
    const int sizeFrom = routes.length(from);
    const int sizeTo = routes.length(to);
    for (int a = 0; a <= sizeFrom && chooser.continues(); ++a)
        for (int b = 0; b <= sizeTo; ++b)
            chooser.offer({from, {{{from, 0, a}, {to, b, sizeTo}}}},
                          {to, {{{to, 0, b}, {from, a, sizeFrom}}}});
    for (int begin = 0; begin < sizeFrom && chooser.continues(); ++begin)
        for (int end = begin + 1; end <= std::min(sizeFrom, begin + kLongestPiece); ++end)
            for (const bool backwards : {false, true}) {
                if (backwards && end == begin + 1)
                    continue;
                const RoutePiece piece{from, begin, end, backwards};
                for (int b = 0; b <= sizeTo; ++b)
                    for (int given = 0; given <= 1 && b + given <= sizeTo; ++given)
                        chooser.offer(
                            {from, {{{from, 0, begin}, {to, b, b + given}, {from, end, sizeFrom}}}},
                            {to, {{{to, 0, b}, piece, {to, b + given, sizeTo}}}});
            }
    return chooser.best;
}

bool apply(FleetRoutes& routes, const FleetMove& move)
{
    std::array<VisitOrder, 2> orders;
    const auto count = static_cast<std::size_t>(move.partCount);
    for (std::size_t k = 0; k < count; ++k)
        orders[k] = routes.joined(move.parts[k].pieces);
    const auto exchangeOrders = [&] {
        double cost = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const int uav = move.parts[k].uav;
            VisitOrder before = routes.plan()[static_cast<std::size_t>(uav)];
            routes.setOrder(uav, std::exchange(orders[k], std::move(before)));
            cost += routes.cost(uav);
        }
        return cost;
    };
    double before = 0;
    for (std::size_t k = 0; k < count; ++k)
        before += routes.cost(move.parts[k].uav);
    // The sums from which moves are evaluated may be far larger than the cost.
    const bool gains = exchangeOrders() < before;
    if (!gains)
        exchangeOrders();
    return gains;
}

} // namespace berg
