#include "widgets/model/flight_record.h"

#include "widgets/model/compared_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** On the track as it is drawn, straight between its samples. */
Point placeAt(const FlightRecord& record, double time_s)
{
    const std::vector<Sample>& samples = record.history.samples;
    const auto after = std::lower_bound(samples.begin(), samples.end(), time_s,
                                        [](const Sample& s, double t) { return s.time_s < t; });
    const bool isLast = after == samples.end();
    const Point to_m = isLast ? record.now.world.uav.position_m : after->uav.position_m;
    if (after == samples.begin())
        return to_m;
    const Sample& before = *std::prev(after);
    const double length_s = (isLast ? record.now.time_s : after->time_s) - before.time_s;
    const double share = length_s > 0 ? (time_s - before.time_s) / length_s : 1;
    return before.uav.position_m + share * (to_m - before.uav.position_m);
}

/** The plan that changed the order last, the plans after it being the same again; null: none. */
const PlanEvent* lastChange(const FlightRecord& record)
{
    const std::vector<PlanEvent>& plans = record.history.plans;
    for (std::size_t k = std::min(record.shown().planCount, plans.size()); k-- > 0;) {
        if (plans[k].change)
            return &plans[k];
        if (plans[k].reason != PlanReason::Intervention)
            break;
    }
    return nullptr;
}

/** The part of ways that comes after that time. */
std::vector<AimedWay> after(std::vector<AimedWay> ways, double time_s)
{
    std::erase_if(ways,
                  [time_s](const AimedWay& way) { return way.points.back().time_s <= time_s; });
    if (ways.empty())
        return ways;
    std::vector<WayPoint>& points = ways.front().points;
    const auto later = std::find_if(points.begin(), points.end(), [time_s](const WayPoint& point) {
        return point.time_s > time_s;
    });
    if (later == points.begin())
        return ways;
    WayPoint& from = *std::prev(later);
    const double share = (time_s - from.time_s) / (later->time_s - from.time_s);
    from = {.position_m = from.position_m + share * (later->position_m - from.position_m),
            .time_s = time_s};
    points.erase(points.begin(), std::prev(later));
    return ways;
}

/** How a plan would have gone on from that time. */
std::vector<AimedWay> waysAfter(const FlightRecord& record, const PlanEvent& plan, double time_s)
{
    const DubinsState uav{.position_m = placeAt(record, plan.time_s)};
    return after(waysOf(plan, uav, plan.time_s, record.shown().motion), time_s);
}

} // namespace

void FlightRecord::begin(const Scenario& flown)
{
    const std::uint64_t rewrites = history.rewrites;
    *this = FlightRecord{.scenario = flown, .bound = std::move(bound)};
    history.rewrites = rewrites + 1;
}

void FlightRecord::take(MissionSnapshot snapshot)
{
    if (snapshot.generation != now.generation) {
        history = {.rewrites = history.rewrites + 1};
        instant.reset();
    }
    append(history, std::exchange(snapshot.news, {}));
    now = std::move(snapshot);
    if (!inFlight())
        noteStartPlan();
}

/** Before take-off each plan is a mission of its own: what one changes is known only here. */
void FlightRecord::noteStartPlan()
{
    if (startPlan && !isSameWorld(startPlan->scenario, scenario))
        startPlan.reset();
    if (now.phase != RunPhase::Ready || !now.plan)
        return;
    const std::vector<int>& order = now.plan->order;
    StartPlan next{.scenario = scenario, .plan = *now.plan};
    if (startPlan && startPlan->plan.order == order) {
        next.change = startPlan->change;
        next.former = startPlan->former;
    } else if (startPlan) {
        next.change =
            planChange(forecastStart(now), startPlan->plan.order, order, scenario.duration_s,
                       {.before = startPlan->plan.clusters, .after = now.plan->clusters});
        next.former = startPlan->plan;
    }
    startPlan = std::move(next);
}

std::optional<ShownChange> FlightRecord::changeShown() const
{
    if (!inFlight() && startPlan && startPlan->change && now.plan)
        return ShownChange{.change = *startPlan->change,
                           .ways = waysAfter(*this, startPlan->former, 0)};
    const PlanEvent* plan = lastChange(*this);
    if (plan == nullptr)
        return std::nullopt;
    const std::vector<int>& before = plan->change->before;
    const bool isLeft = std::any_of(before.begin(), before.end(), [&](int iceberg) {
        const Track& track = shown().world.tracks[static_cast<std::size_t>(iceberg)];
        return !track.inView && track.anchor_s <= plan->time_s;
    });
    if (!isLeft)
        return std::nullopt;
    ShownChange shownChange{
        .change = *plan->change, .time_s = plan->time_s, .from_m = placeAt(*this, plan->time_s)};
    if (plan != history.plans.data())
        shownChange.ways = waysAfter(*this, *std::prev(plan), plan->time_s);
    return shownChange;
}

KnownBound FlightRecord::boundOfFlight() const
{
    const bool isBroken =
        std::any_of(history.events.begin(), history.events.end(), [](const MissionEvent& event) {
            return (event.kind == EventKind::Sighted && event.detail == kReported) ||
                   (event.kind == EventKind::Intervention && event.detail == kWindChanged);
        });
    return isBroken ? KnownBound() : bound;
}

bool FlightRecord::inFlight() const
{
    switch (now.phase) {
    case RunPhase::Planning:
    case RunPhase::Ready:
    case RunPhase::Failed:
        return false;
    case RunPhase::Flying:
    case RunPhase::Paused:
    case RunPhase::Finished:
        return true;
    }
    return false;
}

Point FlightRecord::estimate_m(std::size_t iceberg) const
{
    return shown().world.tracks[iceberg].estimate_m(shown().time_s);
}

std::size_t FlightRecord::eventsShown() const
{
    constexpr double kRounding_s = 1e-6; // times are whole steps
    const double until_s = shown().time_s + kRounding_s;
    const auto end =
        std::upper_bound(history.events.begin(), history.events.end(), until_s,
                         [](double t, const MissionEvent& event) { return t < event.time_s; });
    return static_cast<std::size_t>(end - history.events.begin());
}

FlightRecord recordOf(const Mission& mission)
{
    FlightRecord record{.scenario = mission.scenario(), .now = snapshotOf(mission)};
    MissionHistory& history = record.history;
    history.samples = mission.recorder().samples();
    for (std::size_t row = 0; row < history.samples.size(); ++row) {
        const auto icebergs = mission.recorder().icebergs(row);
        history.rows.emplace_back(icebergs.begin(), icebergs.end());
    }
    history.plans = mission.plans();
    history.events = mission.events();
    return record;
}

MissionOptions recordingOf(const Scenario& scenario)
{
    constexpr double kSamples = 18000;
    constexpr double kIcebergSamples = 2e6; // 64 MB
    constexpr double kLongest_s = 5;
    constexpr double kKeyframe_samples = 60;
    const double icebergs = static_cast<double>(scenario.icebergs.size());
    const double share = std::max(1 / kSamples, icebergs / kIcebergSamples);
    const double interval_s = std::clamp(std::ceil(scenario.duration_s * share), 1.0, kLongest_s);
    return {.sampleInterval_s = interval_s, .keyframeInterval_s = kKeyframe_samples * interval_s};
}

} // namespace berg
