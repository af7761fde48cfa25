#include "core/coverage/patrol_tails.h"

#include <algorithm>
#include <limits>

namespace berg {

namespace {

PatrolStop stopAt(const PatrolUav& uav, const Pose& from, double time_s)
{
    PatrolStop stop = patrolStart(uav);
    stop.place_m = from.position_m;
    stop.ahead = from.ahead;
    stop.time_s = time_s;
    return stop;
}

} // namespace

double PatrolTail::late_s(const Pose& from, double time_s) const
{
    if (!uav.sorties)
        return 0;
    const PatrolStop stop = stopAt(uav, from, time_s);
    return time_s + patrolTimeHome_s(uav, stop) - stop.sortieEnd_s;
}

double PatrolTail::shift_s(const Pose& from, double time_s) const
{
    if (!first[0])
        return 0;
    const auto next = [this](std::size_t k) {
        return k < first.size() && first[k] ? &*first[k] : nullptr;
    };
    PatrolStop stop = patrolLeg(uav, stopAt(uav, from, time_s), *first[0], next(1));
    if (first[1])
        stop = patrolLeg(uav, stop, *first[1], next(2));
    return stop.time_s - planned_s;
}

PatrolTails::PatrolTails(const PatrolSearch& patrol, std::span<const std::size_t> cuts)
    : m_icebergs(patrol.problem().icebergs)
    , m_uavs(patrol.problem().uavs)
    , m_visits(m_uavs.size())
    , m_before(m_icebergs.size(), 0)
    , m_length_s(patrol.problem().length_s)
{
    for (std::size_t u = 0; u < m_uavs.size(); ++u)
        for (std::size_t k = 0; k < patrol.visits(u).size(); ++k) {
            const PatrolStop& stop = patrol.stops(u)[k];
            if (k < cuts[u])
                ++m_before[static_cast<std::size_t>(patrol.visits(u)[k])];
            else
                m_visits[u].push_back({.iceberg = ModelPlace::of(patrol.visits(u)[k]),
                                       .time_s = stop.time_s,
                                       .place_m = stop.place_m});
        }
}

PatrolTail PatrolTails::tailOf(std::size_t uav, std::span<const double> shifts_s) const
{
    constexpr double kNever_s = std::numeric_limits<double>::infinity();
    PatrolTail tail{.uav = m_uavs[uav],
                    .nextOwn_s = std::vector<double>(m_icebergs.size(), kNever_s),
                    .nextOther_s = std::vector<double>(m_icebergs.size(), kNever_s)};
    const std::vector<PatrolVisit>& own = m_visits[uav];
    for (std::size_t k = 0; k < std::min(own.size(), tail.first.size()); ++k)
        tail.first[k] = m_icebergs[toIndex(own[k].iceberg)].place;
    if (!own.empty())
        tail.planned_s = own[std::min<std::size_t>(1, own.size() - 1)].time_s;
    struct Seen
    {
        double time_s;
        bool isOwn;
    };
    std::vector<std::vector<Seen>> seen(m_icebergs.size());
    for (std::size_t u = 0; u < m_visits.size(); ++u)
        for (const PatrolVisit& visit : m_visits[u]) {
            const std::size_t i = toIndex(visit.iceberg);
            const double time_s = visit.time_s + (u == uav ? 0 : shifts_s[u]);
            double& next_s = (u == uav ? tail.nextOwn_s : tail.nextOther_s)[i];
            next_s = std::min(next_s, time_s);
            seen[i].push_back({time_s, u == uav});
        }
    for (std::size_t i = 0; i < m_icebergs.size(); ++i) {
        std::ranges::stable_sort(seen[i], {}, &Seen::time_s);
        for (std::size_t m = 1; m <= seen[i].size(); ++m) {
            const bool isEnd = m == seen[i].size();
            const PatrolGrowth& growth = m_icebergs[i].after(m_before[i] + m);
            const double gap_s =
                std::max(0.0, (isEnd ? m_length_s : seen[i][m].time_s) - seen[i][m - 1].time_s);
            tail.rest_m2s += growth.cost_m2s(gap_s);
            const bool endsOwn = !isEnd && seen[i][m].isOwn;
            if (endsOwn == seen[i][m - 1].isOwn)
                continue; // The gap is shifted as a whole or not at all.
            tail.slope_m2 += (endsOwn ? 1 : -1) * growth.sigma_m2(gap_s);
            tail.bend_m2ps += growth.slope_m2ps(gap_s) / 2;
        }
    }
    return tail;
}

} // namespace berg
