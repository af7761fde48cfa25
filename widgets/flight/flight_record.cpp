#include "widgets/flight/flight_record.h"

#include "core/plan/policy/fleet_task.h"
#include "widgets/flight/compared_run.h"
#include "widgets/words/plan_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** Returns the UAV's position on its drawn track, which is straight between samples. */
Point placeAt(const FlightRecord& record, std::size_t uav, double time_s)
{
    const std::vector<Sample>& samples = record.history.samples;
    const auto after = std::lower_bound(samples.begin(), samples.end(), time_s,
                                        [](const Sample& s, double t) { return s.time_s < t; });
    const bool isLast = after == samples.end();
    Point to_m = isLast ? record.now.world.uavs.at(uav).pose.position_m
                        : after->uavs.at(uav).pose.position_m;
    if (after == samples.begin())
        return to_m;
    const Sample& before = *std::prev(after);
    const double length_s = (isLast ? record.now.time_s : after->time_s) - before.time_s;
    const double share = length_s > 0 ? (time_s - before.time_s) / length_s : 1;
    const Point& from_m = before.uavs.at(uav).pose.position_m;
    return from_m + share * (to_m - from_m);
}

/** Returns the plans of the UAV made by the time shown, last one first. */
std::vector<const PlanEvent*> plansBackwards(const FlightRecord& record, int uav)
{
    const std::vector<PlanEvent>& plans = record.history.plans;
    std::vector<const PlanEvent*> own;
    for (std::size_t k = std::min(record.shown().planCount, plans.size()); k-- > 0;)
        if (plans[k].uav == uav)
            own.push_back(&plans[k]);
    return own;
}

/**
 * Returns the index of the latest plan that changed the order; only interventions that kept it may
 * follow. Returns the size if there is none.
 */
std::size_t lastChange(const std::vector<const PlanEvent*>& backwards)
{
    for (std::size_t k = 0; k < backwards.size(); ++k) {
        if (backwards[k]->change)
            return k;
        if (backwards[k]->reason != PlanReason::Intervention)
            break;
    }
    return backwards.size();
}

/** Returns the part of the paths after that time. */
std::vector<AimedPath> after(std::vector<AimedPath> paths, double time_s)
{
    std::erase_if(paths,
                  [time_s](const AimedPath& path) { return path.points.back().time_s <= time_s; });
    if (paths.empty())
        return paths;
    std::vector<PathPoint>& points = paths.front().points;
    const auto later = std::find_if(points.begin(), points.end(), [time_s](const PathPoint& point) {
        return point.time_s > time_s;
    });
    if (later == points.begin())
        return paths;
    PathPoint& from = *std::prev(later);
    const double share = (time_s - from.time_s) / (later->time_s - from.time_s);
    from = {.position_m = from.position_m + share * (later->position_m - from.position_m),
            .time_s = time_s};
    points.erase(points.begin(), std::prev(later));
    return paths;
}

/** Returns how a plan would have continued from that time. */
std::vector<AimedPath> pathsAfter(const FlightRecord& record, const PlanEvent& plan, double time_s)
{
    const auto k = static_cast<std::size_t>(plan.uav);
    const DubinsState uav{.position_m = placeAt(record, k, plan.time_s)};
    return after(pathsOf(plan, uav, plan.time_s, record.shown().motions.at(k)), time_s);
}

} // namespace

void FlightRecord::begin(const Scenario& flown)
{
    const std::uint64_t rewrites = history.rewrites;
    *this = FlightRecord{.scenario = flown, .bound = std::move(bound)};
    history.rewrites = rewrites + 1;
}

void FlightRecord::accept(MissionSnapshot snapshot)
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

/** Before take-off each plan belongs to a new mission, so only the record can compare them. */
void FlightRecord::noteStartPlan()
{
    if (startPlan && !isSameWorld(startPlan->scenario, scenario))
        startPlan.reset();
    if (now.phase != RunPhase::Ready || now.plans.empty())
        return;
    const auto orders = [](const std::vector<PlanEvent>& plans) {
        OrdersByUav own;
        for (const PlanEvent& plan : plans)
            own.push_back(plan.order);
        return own;
    };
    StartPlan next{.scenario = scenario, .plans = now.plans};
    next.changes.resize(now.plans.size());
    const bool isComparable = startPlan && startPlan->plans.size() == now.plans.size();
    if (isComparable && orders(startPlan->plans) == orders(now.plans)) {
        next.changes = startPlan->changes;
        next.former = startPlan->former;
    } else if (isComparable) {
        next.changes = planChanges(
            forecastStart(now), orders(startPlan->plans), orders(now.plans), scenario.duration_s,
            {.before = startPlan->plans.front().clusters, .after = now.plans.front().clusters});
        next.former = startPlan->plans;
    }
    startPlan = std::move(next);
}

std::optional<ShownChange> FlightRecord::changeShown(int uav) const
{
    if (isOver())
        return {};
    const auto u = static_cast<std::size_t>(uav);
    if (!inFlight() && startPlan && u < startPlan->changes.size() && startPlan->changes[u] &&
        now.plan)
        return ShownChange{.change = *startPlan->changes[u],
                           .paths = pathsAfter(*this, startPlan->former[u], 0)};
    const std::vector<const PlanEvent*> backwards = plansBackwards(*this, uav);
    const std::size_t k = lastChange(backwards);
    if (k == backwards.size())
        return std::nullopt;
    const PlanEvent& plan = *backwards[k];
    const std::vector<int>& before = plan.change->before;
    const bool isLeft = std::any_of(before.begin(), before.end(), [&](int iceberg) {
        const Track& track = shown().world.tracks[static_cast<std::size_t>(iceberg)];
        return !track.inView && track.seen_s <= plan.time_s;
    });
    if (!isLeft)
        return std::nullopt;
    ShownChange shownChange{
        .change = *plan.change, .time_s = plan.time_s, .from_m = placeAt(*this, u, plan.time_s)};
    if (k + 1 < backwards.size())
        shownChange.paths = pathsAfter(*this, *backwards[k + 1], plan.time_s);
    return shownChange;
}

KnownBound FlightRecord::boundOfFlight() const
{
    const bool isBroken =
        std::any_of(history.events.begin(), history.events.end(), [](const MissionEvent& event) {
            return (event.kind == EventKind::Sighted && event.reported) ||
                   event.kind == EventKind::LateHome || // the bound relies on the turn-around
                   (event.kind == EventKind::Intervention &&
                    (event.changed == ChangedPart::Wind || event.changed == ChangedPart::Removal));
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

bool FlightRecord::isOver() const
{
    return inFlight() && shown().time_s > scenario.duration_s - scenario.dt_s / 2;
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
    IcebergReader rows = mission.recorder().reader();
    for (std::size_t row = 0; row < history.samples.size(); ++row)
        history.rows.push_back(rows.at(row));
    history.plans = mission.plans();
    history.events = mission.events();
    return record;
}

namespace {

/**
 * Returns the length of an order of the request, m. A leg counts as the mean of both directions, as
 * in `visitationTask`.
 */
double weighedLength_m(const PlanRequest& request, const UavRequest& uav,
                       const std::vector<int>& order, Route route)
{
    const auto leg_m = [&uav](int from, int to) {
        return (uav.distance_m(from, to) + uav.distance_m(to, from)) / 2;
    };
    double length_m = 0;
    int at = 0;
    for (const int iceberg : order)
        // Only one iceberg of each cluster is a node.
        if (std::ranges::find(request.ids, iceberg) != request.ids.end()) {
            const int next = nodeOfId(request, iceberg);
            length_m += leg_m(std::exchange(at, next), next);
        }
    return route == Route::Closed ? length_m + leg_m(at, 0) : length_m;
}

/** Returns the weighed length of the plan in force and of those of the same solve, m. */
double weighedDistance_m(const MissionSnapshot& shown, Route route)
{
    double length_m = 0;
    for (const UavRequest& uav : shown.request->uavs)
        if (const PlanEvent* plan = planOf(shown, uav.uav);
            plan != nullptr && plan->time_s == shown.plan->time_s)
            length_m += weighedLength_m(*shown.request, uav, plan->order, route);
    return length_m;
}

} // namespace

TimesAhead timesOf(const FlightRecord& record)
{
    return {.clock = clockOf(record.scenario), .now_s = record.shown().time_s};
}

PlanReadout readoutOf(const FlightRecord& record, const QString& fault)
{
    const MissionSnapshot& shown = record.shown();
    PlanReadout readout{.plan = shown.plan,
                        .solving = record.now.phase == RunPhase::Planning,
                        .isOver = record.isOver(),
                        .fault = fault,
                        .others = {}};
    for (const PlanEvent& plan : shown.plans)
        if (shown.plan && plan.uav != shown.plan->uav && plan.sameSolve &&
            plan.time_s == shown.plan->time_s)
            readout.others.push_back(plan.order);
    if (shown.plan && shown.request && traitsOf(shown.planner.policy).weighsSigma)
        readout.weighed_m = weighedDistance_m(shown, record.scenario.planner.route);
    return readout;
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
