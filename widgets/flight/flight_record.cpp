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
std::vector<const Plan*> plansBackwards(const FlightRecord& record, int uav)
{
    const std::vector<PlanPointer>& plans = record.history.plans;
    std::vector<const Plan*> own;
    for (std::size_t k = std::min(record.shown().planCount, plans.size()); k-- > 0;)
        if (plans[k]->of(uav) != nullptr)
            own.push_back(plans[k].get());
    return own;
}

/**
 * Returns the index of the latest plan that changed the order; only interventions that kept it may
 * follow. Returns the size if there is none.
 */
std::size_t lastChange(const std::vector<const Plan*>& backwards, int uav)
{
    for (std::size_t k = 0; k < backwards.size(); ++k) {
        const UavPlan& own = *backwards[k]->of(uav);
        if (own.change)
            return k;
        if (own.reason != PlanReason::Intervention)
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
std::vector<AimedPath> pathsAfter(const FlightRecord& record, const Plan& plan, int uav,
                                  double time_s)
{
    const auto k = static_cast<std::size_t>(uav);
    const DubinsState pose{.position_m = placeAt(record, k, plan.time_s)};
    return after(pathsOf(*plan.of(uav), pose, plan.time_s, record.shown().motions.at(k)), time_s);
}

std::ptrdiff_t windReports(const MissionSnapshot& snapshot)
{
    return std::ranges::count_if(snapshot.worldChanges, [](const Intervention& change) {
        return change.wind_mps.has_value();
    });
}

} // namespace

void FlightRecord::noteWeather()
{
    weather = std::make_shared<const WeatherCourse>(courseOf(scenario, now.worldChanges));
}

std::shared_ptr<const WeatherCourse> weatherOfRun(const FlightRecord& record)
{
    return record.weather ? record.weather
                          : std::make_shared<const WeatherCourse>(
                                courseOf(record.scenario, record.now.worldChanges));
}

void FlightRecord::begin(const Scenario& flown)
{
    const std::uint64_t rewrites = history.rewrites;
    *this = FlightRecord{.scenario = flown, .bound = std::move(bound)};
    history.rewrites = rewrites + 1;
    noteWeather();
}

void FlightRecord::accept(MissionSnapshot snapshot)
{
    if (snapshot.generation != now.generation) {
        history = {.rewrites = history.rewrites + 1};
        instant.reset();
    }
    append(history, std::exchange(snapshot.news, {}));
    const bool hasOtherWeather = snapshot.generation != now.generation || !weather ||
                                 windReports(snapshot) != windReports(now);
    now = std::move(snapshot);
    if (hasOtherWeather)
        noteWeather();
    if (!inFlight())
        noteStartPlan();
}

/** Before take-off each plan belongs to a new mission, so only the record can compare them. */
void FlightRecord::noteStartPlan()
{
    if (startPlan && !isSameWorld(startPlan->scenario, scenario))
        startPlan.reset();
    if (now.phase != RunPhase::Ready || !now.plan)
        return;
    const auto orders = [](const Plan& plan) {
        OrdersByUav own;
        for (const UavPlan& uav : plan.uavs)
            own.push_back(uav.order);
        return own;
    };
    Plan next = *now.plan;
    PlanPointer former;
    if (startPlan && startPlan->plan->uavs.size() == next.uavs.size()) {
        const Plan& last = *startPlan->plan;
        const bool isSame = orders(last) == orders(next);
        std::vector<std::optional<PlanChange>> changes;
        if (!isSame)
            changes = planChanges(
                forecastStart(now), orders(last), orders(next), scenario.duration_s,
                {.before = last.uavs.front().clusters, .after = next.uavs.front().clusters});
        for (std::size_t uav = 0; uav < next.uavs.size(); ++uav)
            next.uavs[uav].change = isSame ? last.uavs[uav].change : changes[uav];
        former = isSame ? startPlan->former : startPlan->plan;
    }
    startPlan = {.scenario = scenario,
                 .plan = std::make_shared<const Plan>(std::move(next)),
                 .former = std::move(former)};
}

std::optional<ShownChange> FlightRecord::changeShown(int uav) const
{
    if (isOver())
        return {};
    const auto u = static_cast<std::size_t>(uav);
    const UavPlan* atStart =
        !inFlight() && startPlan && now.plan ? startPlan->plan->of(uav) : nullptr;
    if (atStart != nullptr && atStart->change)
        return ShownChange{.change = *atStart->change,
                           .paths = pathsAfter(*this, *startPlan->former, uav, 0)};
    const std::vector<const Plan*> backwards = plansBackwards(*this, uav);
    const std::size_t k = lastChange(backwards, uav);
    if (k == backwards.size())
        return std::nullopt;
    const Plan& plan = *backwards[k];
    const PlanChange& change = *plan.of(uav)->change;
    const bool isLeft = std::ranges::any_of(change.before, [&](IcebergIndex iceberg) {
        const Track& track = shown().world.tracks[toIndex(iceberg)];
        return !track.inView && track.seen_s <= plan.time_s;
    });
    if (!isLeft)
        return std::nullopt;
    ShownChange shownChange{
        .change = change, .time_s = plan.time_s, .from_m = placeAt(*this, u, plan.time_s)};
    if (k + 1 < backwards.size())
        shownChange.paths = pathsAfter(*this, *backwards[k + 1], uav, plan.time_s);
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

Point FlightRecord::estimate_m(IcebergIndex iceberg) const
{
    return shown().world.tracks[toIndex(iceberg)].estimate_m(shown().time_s);
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
    record.noteWeather();
    return record;
}

namespace {

/**
 * Returns the length of an order of the request, m. A leg counts as the mean of both directions, as
 * in `visitationTask`.
 */
double weighedLength_m(const PlanRequest& request, const UavRequest& uav, const IcebergList& order,
                       Route route)
{
    const auto leg_m = [&uav](NodeIndex from, NodeIndex to) {
        return (legBetween(uav.distance_m, from, to) + legBetween(uav.distance_m, to, from)) / 2;
    };
    double length_m = 0;
    NodeIndex at;
    for (const IcebergIndex iceberg : order)
        // Only one iceberg of each cluster is a node.
        if (std::ranges::find(request.ids, iceberg) != request.ids.end()) {
            const NodeIndex next = nodeOf(request.ids, iceberg);
            length_m += leg_m(std::exchange(at, next), next);
        }
    return route == Route::Closed ? length_m + leg_m(at, 0) : length_m;
}

/** Returns the weighed length of the plan in force and of those of the same solve, m. */
double weighedDistance_m(const MissionSnapshot& shown, Route route)
{
    double length_m = 0;
    for (const UavRequest& uav : shown.request->uavs)
        if (const PlanPointer& plan = shown.plans.at(static_cast<std::size_t>(uav.uav));
            plan && plan->time_s == shown.plan->time_s)
            length_m += weighedLength_m(*shown.request, uav, plan->of(uav.uav)->order, route);
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
                        .fault = fault};
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
