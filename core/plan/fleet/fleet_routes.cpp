#include "core/plan/fleet/fleet_routes.h"

#include <limits>
#include <utility>

namespace berg {

FleetRoutes::FleetRoutes(const FleetCosts& costs, FleetPlan plan)
    : m_costs(&costs), m_plan(plan.size()), m_tables(plan.size())
{
    for (int uav = 0; uav < costs.uavs(); ++uav)
        setOrder(uav, std::move(plan[at(uav)]));
}

std::vector<std::vector<double>> FleetRoutes::waits(const Table& table,
                                                    const std::vector<std::vector<double>>& legs)
{
    std::vector<std::vector<double>> waits = legs;
    for (std::size_t uav = 0; uav < legs.size(); ++uav) {
        waits[uav][0] = 0;
        for (std::size_t k = 1; k < table.sigma.size(); ++k)
            waits[uav][k] =
                waits[uav][k - 1] + (table.sigma[k] - table.sigma[k - 1]) * legs[uav][k - 1];
    }
    return waits;
}

void FleetRoutes::setOrder(int uav, VisitOrder order)
{
    Table& table = m_tables[at(uav)];
    const auto uavs = at(m_costs->uavs());
    const std::size_t size = order.size();
    table.cost = m_costs->total(uav, order);
    table.sigma.assign(size + 1, 0.0);
    table.wait.assign(size + 1, 0.0);
    table.forward.assign(uavs, std::vector<double>(size + 1, 0.0));
    table.back = table.forward;
    table.barred.assign(uavs, std::vector<int>(size + 1, 0));
    for (std::size_t k = 0; k < size; ++k) {
        const double sigma = m_costs->of(uav).sigmaOf(order[k]);
        table.sigma[k + 1] = table.sigma[k] + sigma;
        table.wait[k + 1] = table.wait[k] + sigma * static_cast<double>(k + 1);
    }
    for (std::size_t other = 0; other < uavs; ++other) {
        const UavCosts& costs = m_costs->of(static_cast<int>(other));
        for (std::size_t k = 0; k < size; ++k)
            table.barred[other][k + 1] =
                table.barred[other][k] +
                (m_costs->allows(static_cast<int>(other), order[k]) ? 0 : 1);
        for (std::size_t k = 1; k < size; ++k) {
            table.forward[other][k] =
                table.forward[other][k - 1] + costs.leg(order[k - 1], order[k]);
            table.back[other][k] = table.back[other][k - 1] + costs.leg(order[k], order[k - 1]);
        }
    }
    if (m_costs->weighted()) {
        table.forwardWait = waits(table, table.forward);
        table.backWait = waits(table, table.back);
    }
    m_plan[at(uav)] = std::move(order);
}

double FleetRoutes::cost(int uav, std::span<const RoutePiece> pieces) const
{
    if (m_costs->weighted())
        return latency(uav, pieces);
    const UavCosts& costs = m_costs->of(uav);
    double sum = 0;
    int place = 0; // position of the last iceberg so far
    NodeIndex last;
    for (const RoutePiece& piece : pieces) {
        if (piece.begin == piece.end)
            continue;
        const Table& table = m_tables[at(piece.uav)];
        const VisitOrder& from = order(piece.uav);
        const std::size_t begin = at(piece.begin);
        const std::size_t end = at(piece.end);
        if (table.barred[at(uav)][end] != table.barred[at(uav)][begin])
            return std::numeric_limits<double>::infinity();
        const std::vector<double>& legs =
            piece.backwards ? table.back[at(uav)] : table.forward[at(uav)];
        const double sigma = table.sigma[end] - table.sigma[begin];
        const double wait = table.wait[end] - table.wait[begin];
        sum += costs.leg(last, piece.backwards ? from[end - 1] : from[begin]) + legs[end - 1] -
               legs[begin];
        // t is the position plus 1.
        sum += piece.backwards ? (piece.end + place + 2) * sigma - wait
                               : (place - piece.begin + 1) * sigma + wait;
        place += piece.end - piece.begin;
        last = piece.backwards ? from[begin] : from[end - 1];
    }
    return sum + costs.leg(last, 0);
}

double FleetRoutes::latency(int uav, std::span<const RoutePiece> pieces) const
{
    const UavCosts& costs = m_costs->of(uav);
    double sum = 0;
    double length = 0; // length flown so far
    NodeIndex last;
    for (const RoutePiece& piece : pieces) {
        if (piece.begin == piece.end)
            continue;
        const Table& table = m_tables[at(piece.uav)];
        const VisitOrder& from = order(piece.uav);
        const std::size_t begin = at(piece.begin);
        const std::size_t end = at(piece.end);
        if (table.barred[at(uav)][end] != table.barred[at(uav)][begin])
            return std::numeric_limits<double>::infinity();
        const double sigma = table.sigma[end] - table.sigma[begin];
        const std::vector<double>& legs =
            piece.backwards ? table.back[at(uav)] : table.forward[at(uav)];
        const std::vector<double>& waits =
            piece.backwards ? table.backWait[at(uav)] : table.forwardWait[at(uav)];
        const double wait = waits[end] - waits[begin];
        length += costs.leg(last, piece.backwards ? from[end - 1] : from[begin]);
        sum += length * sigma +
               (piece.backwards ? legs[end - 1] * sigma - wait : wait - legs[begin] * sigma);
        length += legs[end - 1] - legs[begin];
        last = piece.backwards ? from[begin] : from[end - 1];
    }
    return sum;
}

VisitOrder FleetRoutes::joined(std::span<const RoutePiece> pieces) const
{
    VisitOrder result;
    for (const RoutePiece& piece : pieces) {
        const VisitOrder& from = order(piece.uav);
        const auto begin = from.begin() + piece.begin;
        const auto end = from.begin() + piece.end;
        if (piece.backwards)
            result.insert(result.end(), std::make_reverse_iterator(end),
                          std::make_reverse_iterator(begin));
        else
            result.insert(result.end(), begin, end);
    }
    return result;
}

} // namespace berg
