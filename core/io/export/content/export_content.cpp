#include "core/io/export/content/export_content.h"

#include "core/base/angles.h"
#include "core/checks/drift_advice.h"
#include "core/checks/validate.h"
#include "core/io/export/content/export_flight.h"
#include "core/mission/flyable_path.h"
#include "core/scenario/fence.h"
#include "core/scenario/recovery.h"
#include "core/scenario/text_checks.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace berg {

namespace {

/** A quarter of the Earth's circumference; beyond it the plane distorts maps too much. */
constexpr double kEndOfPlane_m = 1e7;

[[noreturn]] void refuse(const std::string& option, IssueReason reason)
{
    throw Error(ErrorCode::InvalidInput, option, std::move(reason));
}

void checkRange(const std::string& option, const std::optional<double>& value, const Limits& limits)
{
    if (value)
        if (const std::optional<IssueReason> fault = outOfLimits(*value, limits))
            refuse(option, *fault);
}

IcebergState stateOf(const Simulation& simulation, IcebergIndex index)
{
    const Track& track = simulation.track(index);
    if (track.left)
        return IcebergState::Left;
    if (!simulation.active(index))
        return IcebergState::Expected;
    switch (track.status) {
    case TrackStatus::Tracked:
        return IcebergState::Tracked;
    case TrackStatus::Lost:
        return IcebergState::Lost;
    case TrackStatus::GivenUp:
        return IcebergState::GivenUp;
    }
    throw std::logic_error("stateOf: unknown status");
}

ExportIceberg enteredIceberg(const Scenario& scenario, const Iceberg& iceberg)
{
    const Track track = initialTrack(iceberg, scenario.observer.model);
    return {.iceberg = iceberg,
            .position_m = iceberg.position_m,
            .drift_mps = iceberg.velocity_mps + scenario.current_mps,
            .sigma_m2 = track.sigma_m2,
            .track = track,
            .state = iceberg.appears_s > 0 ? IcebergState::Expected : IcebergState::Tracked};
}

ExportIceberg presentIceberg(const Mission& mission, IcebergIndex index, ExportScope what)
{
    const Simulation& simulation = mission.simulation();
    const Iceberg& iceberg = mission.icebergs()[toIndex(index)];
    ExportIceberg now = enteredIceberg(mission.scenario(), iceberg);
    now.state = stateOf(simulation, index);
    now.isListed = now.state != IcebergState::Expected && now.state != IcebergState::Left;
    if (now.state == IcebergState::Expected)
        return now;
    now.position_m = what == ExportScope::Track ? simulation.truth_m(index)
                                                : simulation.observer().estimate_m(index);
    if (what != ExportScope::Track)
        now.drift_mps = simulation.track(index).velocity_mps;
    now.track = simulation.track(index);
    now.sigma_m2 = now.track.sigma_m2;
    return now;
}

/** Adds or removes the leg home, as the user chose. */
void endAtHome(ExportUav& uav, const std::optional<bool>& wanted, const WindAhead& wind,
               double now_s)
{
    const bool ends = !uav.visits.empty() && !uav.visits.back().iceberg;
    if (!wanted || *wanted == ends)
        return;
    if (ends) {
        uav.visits.pop_back();
        return;
    }
    const TimedPoint last = endOf(uav);
    const double flight_s = flightTime_s(uav.home_m - last.position_m, uav.uav.spec.airspeed_mps,
                                         Point::Zero(), wind, last.time_s - now_s);
    uav.visits.push_back({.time_s = last.time_s + flight_s, .position_m = uav.home_m});
}

/** Returns how many icebergs of the order have no visit. */
std::size_t leftOf(const IcebergList& order, const std::vector<Visit>& visits)
{
    std::set<IcebergIndex> left(order.begin(), order.end());
    for (const Visit& visit : visits)
        for (const IcebergIndex iceberg : icebergsOf(visit))
            left.erase(iceberg);
    return left.size();
}

/** Removes the leg home, which a limited endurance adds at the end of a path. */
void endOverTheLastIceberg(FlyablePath& path)
{
    if (path.visits.empty() || path.visits.back().iceberg)
        return;
    path.visits.pop_back();
    const double end_s =
        path.visits.empty() ? path.track.front().time_s : path.visits.back().time_s;
    std::erase_if(path.track, [end_s](const TrackPoint& point) { return point.time_s > end_s; });
}

/** Inserts the first search place of each lost iceberg among the visits, by time. */
void addSearches(ExportUav& uav, double now_s)
{
    for (const PlannedSearch& search : uav.searches) {
        const double time_s = search.time_s - now_s;
        const bool isKnown = std::ranges::any_of(
            uav.visits, [&search](const Visit& visit) { return visit.iceberg == search.iceberg; });
        if (isKnown || time_s <= 0 || uav.track.empty() || search.time_s > uav.track.back().time_s)
            continue;
        const auto after = std::ranges::upper_bound(uav.visits, time_s, {}, &Visit::time_s);
        uav.visits.insert(
            after, {.iceberg = search.iceberg, .time_s = time_s, .position_m = search.place_m});
    }
}

void addPath(ExportUav& uav, const ExportSource& source, const ExportContent& content,
             const Scenario& scene)
{
    if (content.what == ExportScope::Track) {
        uav.track = source.flown.empty() ? flownTrack(*source.mission, uav.row)
                                         : std::move(source.flown[uav.row]);
        uav.visits = flownVisits(*source.mission, static_cast<int>(uav.row));
        endAtHome(uav, content.options.returnHome, windFromStart(scene), content.now_s);
        return;
    }
    UavPlan plan = presentPlan(source, uav.row);
    if (content.options.airspeed_mps)
        plan.legs.clear(); // the legs were planned for another speed
    uav.visits = plannedVisits(scene, plan.order, plan.clusters);
    if (content.what == ExportScope::FirstLeg && uav.visits.size() > 1)
        uav.visits.resize(1);
    endAtHome(uav, content.options.returnHome, windFromStart(scene), 0);
    if (content.what == ExportScope::Path) {
        const bool home = !uav.visits.empty() && !uav.visits.back().iceberg;
        FlyablePath path = flyOrder(scene, plan, home);
        uav.isAimed = !plan.legs.empty();
        if (uav.isAimed && plan.outlook)
            uav.searches = std::move(plan.outlook->searches);
        if (!home)
            endOverTheLastIceberg(path);
        for (TrackPoint& point : path.track)
            point.time_s += content.now_s;
        uav.track = path.track;
        uav.visits = std::move(path.visits);
    }
    if (uav.uav.spec.endurance_s > 0 && content.what != ExportScope::FirstLeg)
        uav.laterSorties = leftOf(plan.order, uav.visits);
    addSearches(uav, content.now_s);
    for (Visit& visit : uav.visits)
        visit.time_s += content.now_s;
}

ExportUav exportUav(const ExportSource& source, const ExportContent& content, std::size_t row)
{
    const ExportOptions& options = content.options;
    Scenario scene = presentScene(source, row);
    UavSpec& spec = scene.uavs.front().spec;
    spec.altitude_m = options.altitude_m.value_or(spec.altitude_m);
    spec.airspeed_mps = options.airspeed_mps.value_or(spec.airspeed_mps);
    const Uav& uav = scene.uavs.front();
    const double seen_m = surelySeen_m({.fov_m = uav.fov_m, .shape = scene.fovShape});
    const double faster = 1 + windAtStart_mps(scene).norm() / spec.airspeed_mps;
    ExportUav result{.row = row,
                     .uav = uav,
                     .start_s = content.what == ExportScope::Track ? 0 : content.now_s,
                     .home_m = uav.home_m.value_or(uav.position_m),
                     .reach_m = options.acceptance_m.value_or(scene.reachRadius_m.value_or(seen_m)),
                     .reachChosen = options.acceptance_m.has_value(),
                     .circle_m = turnRadius_m(spec) * faster * faster};
    if (content.what == ExportScope::Track) {
        result.uav.position_m = source.scenario.uavs[row].position_m;
        result.uav.heading_deg = source.scenario.uavs[row].heading_deg;
    }
    if (source.mission)
        result.flown_m = source.mission->simulation().uav(static_cast<int>(row)).flown_m;
    const UavState state =
        source.mission ? source.mission->simulation().uav(static_cast<int>(row)) : UavState();
    const double withheld_s =
        source.mission ? state.withheld_s : withheldAtStart_s(source.scenario)[row];
    if (result.slot_s = slotOfSortie_s(source.scenario, row, withheld_s); result.slot_s) {
        *result.slot_s += content.now_s - state.aloft_s;
        spec.reserve_s = reserve_s(spec) + withheld_s; // so that the sortie is over by the slot
    }
    result.isAloft =
        content.what != ExportScope::Track && content.now_s > 0 && state.mode != FlightMode::Ground;
    addPath(result, source, content, scene);
    return result;
}

/**
 * Checks that writers can handle the place and time: on one side of the Earth, within the calendar.
 */
void checkPlace(const std::string& whose, const char* field, const Point& place_m, double time_s)
{
    const auto fail = [&](IssueReason reason) {
        throw Error(ErrorCode::Unsupported, whose, {{Severity::Error, field, std::move(reason)}});
    };
    if (!std::isfinite(time_s) || std::abs(time_s) > kLargestTime_s)
        fail({IssueId::ExportTooLate, {time_s}});
    if (!(place_m.norm() <= kEndOfPlane_m))
        fail({IssueId::ExportOffMap, {time_s, place_m.norm(), kEndOfPlane_m}});
}

/**
 * Throws for content that no file can hold: numbers that are not finite, places outside the plane.
 */
void checkContent(const ExportContent& content)
{
    for (const ExportUav& uav : content.uavs) {
        checkPlace(uav.uav.id, "home_m", uav.home_m, uav.start_s);
        for (const Visit& visit : uav.visits)
            checkPlace(uav.uav.id, "visit", visit.position_m, visit.time_s);
        eachPoint(uav, [&uav](const TimedPoint& point) {
            checkPlace(uav.uav.id, "", point.position_m, point.time_s);
        });
        if (!std::isfinite(uav.reach_m) || !std::isfinite(uav.circle_m))
            throw Error(ErrorCode::Unsupported, uav.uav.id, {IssueId::ExportEndless});
    }
    for (const ExportIceberg& iceberg : content.icebergs)
        checkPlace(iceberg.iceberg.id, "", iceberg.position_m, content.now_s);
    if (content.operation)
        for (const std::vector<Point>& outline_m : content.operation->outlines_m)
            for (const Point& corner_m : outline_m)
                checkPlace("operation", "", corner_m, content.now_s);
    if (content.asset)
        checkPlace("asset", "", assetPlace_m(content), content.now_s);
}

/** Returns the operation volume for the altitude and the airspeed of the options. */
OperationVolume operationAsChosen(Scenario scenario, const ExportOptions& options)
{
    for (Uav& uav : scenario.uavs) {
        uav.spec.altitude_m = options.altitude_m.value_or(uav.spec.altitude_m);
        uav.spec.airspeed_mps = options.airspeed_mps.value_or(uav.spec.airspeed_mps);
    }
    return operationVolume(scenario, *scenario.operation);
}

/**
 * Probability to find a lost iceberg; the iceberg is at no more than one of the places, so they add
 * up.
 */
std::optional<double> chanceToFind(const std::vector<PlannedSearch>& searches, IcebergIndex iceberg,
                                   double now_s)
{
    std::optional<double> chance;
    for (const PlannedSearch& search : searches)
        if (search.iceberg == iceberg && search.time_s > now_s)
            chance = chance.value_or(0) + search.chance;
    return chance;
}

} // namespace

void checkExportOptions(const ExportSource& source, const ExportOptions& options)
{
    checkRange("altitude", options.altitude_m, limits::kExtent_m);
    checkRange("speed", options.airspeed_mps, limits::kAirspeed_mps);
    checkRange("acceptance", options.acceptance_m, limits::kExtent_m);
    if (options.loiterTurns < 0 || options.loiterTurns > kMostLoiterTurns)
        refuse("loiter", {IssueId::OutOfRange, {0, kMostLoiterTurns, options.loiterTurns}});
    if (options.what == ExportScope::Track && source.mission == nullptr)
        refuse("what", {IssueId::NothingFlown});
    const Point wind_mps = source.mission ? source.mission->simulation().motion(0).wind_mps
                                          : windAtStart_mps(source.scenario);
    if (options.airspeed_mps && *options.airspeed_mps <= wind_mps.norm())
        refuse("speed", {IssueId::SlowerThanWind});
    const auto& uavs = source.scenario.uavs;
    if (options.uav && std::ranges::find(uavs, *options.uav, &Uav::id) == uavs.end())
        refuse("uav", {IssueId::NoSuchUav, {*options.uav}});
}

ExportContent exportContent(const ExportSource& source, const ExportOptions& options)
{
    checkExportOptions(source, options);
    const Scenario& scenario = source.scenario;
    ExportContent content{
        .what = options.what.value_or(source.mission ? ExportScope::Track : ExportScope::Order),
        .options = options,
        .name = scenario.name,
        .scenario = std::make_shared<const Scenario>(scenario),
        .frame = LocalFrame(scenario.origin),
        .start = parseUtc(scenario.startUtc),
        .now_s = source.mission ? source.mission->simulation().time_s() : 0,
        .uavs = {},
        .icebergs = {},
        .area_m = scenario.area_m,
        .geofence = scenario.geofence,
        .noFly = scenario.noFly,
        .asset = source.mission ? source.mission->simulation().world().asset() : scenario.asset,
        .planner = source.mission ? source.mission->plannerSettings() : scenario.planner,
        .plan = source.mission && !source.mission->plans().empty() ? *source.mission->plans().back()
                                                                   : source.plan,
        .wind_mps = source.mission ? source.mission->simulation().motion(0).wind_mps
                                   : windAtStart_mps(scenario),
        .zeta_m2s = {},
        .predicted = source.predicted,
        .mission = source.mission,
        .words = source.words};
    if (content.asset)
        content.standoff = standoffArea(*content.asset, scenario.duration_s);
    if (scenario.operation)
        content.operation = operationAsChosen(scenario, options);
    if (source.mission)
        content.zeta_m2s = source.mission->metrics().zeta_m2s;
    if (source.mission)
        for (const IcebergIndex index : source.mission->simulation().icebergs())
            content.icebergs.push_back(presentIceberg(*source.mission, index, content.what));
    else
        for (const Iceberg& iceberg : scenario.icebergs)
            content.icebergs.push_back(enteredIceberg(scenario, iceberg));
    for (std::size_t row = 0; row < scenario.uavs.size(); ++row)
        if (!options.uav || options.uav == scenario.uavs[row].id)
            content.uavs.push_back(exportUav(source, content, row));
    checkContent(content);
    return content;
}

std::vector<NoFlyArea> closedAreas(const ExportContent& content)
{
    std::vector<NoFlyArea> areas = content.noFly;
    if (content.standoff)
        areas.push_back(*content.standoff);
    return areas;
}

bool hasHeights(const NoFlyArea& area)
{
    return area.floor_m > 0 || area.ceiling_m;
}

std::optional<double> chanceInView(const ExportContent& content, const ExportUav& uav,
                                   const Visit& visit, IcebergIndex iceberg)
{
    if (content.what == ExportScope::Track)
        return std::nullopt;
    if (uav.isAimed)
        return chanceToFind(uav.searches, iceberg, content.now_s);
    const ExportIceberg& now = content.icebergs.at(toIndex(iceberg));
    const SensorSpec sensor{.fov_m = uav.uav.fov_m, .shape = content.scenario->fovShape};
    return chanceInView(sensor, std::sqrt(now.sigmaAfter_m2(visit.time_s - content.now_s)),
                        visit.spread_m);
}

std::vector<std::string> idsOf(const ExportContent& content, const Visit& visit)
{
    std::vector<std::string> ids;
    for (const IcebergIndex index : icebergsOf(visit))
        ids.push_back(content.icebergs.at(toIndex(index)).iceberg.id);
    return ids;
}

std::vector<std::pair<std::string_view, double>> driftData(const ExportContent& content,
                                                           const ExportIceberg& iceberg)
{
    std::vector<std::pair<std::string_view, double>> data;
    const bool isFiltered = content.mission != nullptr &&
                            content.scenario->observer.model == ObserverModel::Kalman &&
                            iceberg.state != IcebergState::Expected;
    const double sd_mps =
        isFiltered ? std::sqrt(iceberg.track.velocity_m2ps2) : iceberg.iceberg.velocitySd_mps;
    if (sd_mps > 0)
        data.emplace_back("velocity_sd_mps", sd_mps);
    if (iceberg.iceberg.velocityTime_s > 0) {
        data.emplace_back("velocity_spread_mps", iceberg.iceberg.velocitySpread_mps);
        data.emplace_back("velocity_time_s", iceberg.iceberg.velocityTime_s);
    }
    return data;
}

std::string titleOf(const ExportContent& content, const Visit& visit)
{
    if (!visit.iceberg)
        return "Home";
    if (visit.members.empty())
        return titleOf(content.icebergs.at(toIndex(*visit.iceberg)).iceberg);
    return joined(idsOf(content, visit), ", ");
}

const std::string& titleOf(const Iceberg& iceberg)
{
    return iceberg.name.empty() ? iceberg.id : iceberg.name;
}

const std::string& titleOf(const Uav& uav)
{
    return uav.name.empty() ? uav.id : uav.name;
}

Point eastNorth_mps(const ExportContent& content, const Point& velocity_mps, const Point& at_m)
{
    const double north_rad = content.frame.trueNorth_rad(content.frame.toGeographic(at_m));
    return (turned(velocity_mps, -north_rad) * 1e9).array().round().matrix() / 1e9;
}

double trueHeading_deg(const ExportContent& content, double heading_deg, const Point& at_m)
{
    const double north_rad = content.frame.trueNorth_rad(content.frame.toGeographic(at_m));
    const double heading = heading_deg + degFromRad(north_rad);
    const double whole = std::round((heading - 360 * std::floor(heading / 360)) * 1e6) / 1e6;
    return whole >= 360 ? 0 : whole;
}

Point assetPlace_m(const ExportContent& content)
{
    return content.asset->position_m + content.asset->velocity_mps * content.now_s;
}

void eachPoint(const ExportUav& uav, const PointSink& take)
{
    for (const TrackPoint& point : uav.track)
        take({.position_m = point.state.position_m, .time_s = point.time_s});
    if (!uav.track.empty())
        return;
    take({.position_m = uav.uav.position_m, .time_s = uav.start_s});
    for (const Visit& visit : uav.visits)
        take({.position_m = visit.position_m, .time_s = visit.time_s});
}

void eachPlace(const ExportContent& content, const ExportUav& uav, const PlaceSink& take)
{
    eachPlace(
        content.frame, [&uav](const PointSink& point) { eachPoint(uav, point); }, take);
}

std::size_t partsOf(const ExportContent& content, const ExportUav& uav)
{
    std::size_t parts = 0;
    eachPlace(content, uav,
              [&parts](const TimedPlace& /*place*/, bool isFirst) { parts += isFirst ? 1U : 0U; });
    return parts;
}

std::vector<TimedPoint> pathOf(const ExportUav& uav)
{
    std::vector<TimedPoint> path;
    eachPoint(uav, [&path](const TimedPoint& point) { path.push_back(point); });
    return path;
}

TimedPoint endOf(const ExportUav& uav)
{
    if (!uav.track.empty())
        return {.position_m = uav.track.back().state.position_m, .time_s = uav.track.back().time_s};
    if (uav.visits.empty())
        return {.position_m = uav.uav.position_m, .time_s = uav.start_s};
    return {.position_m = uav.visits.back().position_m, .time_s = uav.visits.back().time_s};
}

} // namespace berg
