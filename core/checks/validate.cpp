#include "core/checks/validate.h"

#include "core/checks/findings.h"
#include "core/checks/forecast_findings.h"
#include "core/checks/scenario_warnings.h"
#include "core/permit/airspace.h"
#include "core/scenario/fence.h"
#include "core/scenario/fields.h"
#include "core/scenario/flight_weather.h"
#include "core/scenario/text_checks.h"
#include "core/vehicle/safety_guard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

namespace berg {

namespace {

void checkPolygon(const std::vector<Point>& corners_m, const std::string& path, Findings& findings)
{
    if (corners_m.size() < 3 || corners_m.size() > kMostAreaCorners) {
        findings.error(path, IssueId::AreaCorners,
                       {countOf(kMostAreaCorners), countOf(corners_m.size())});
        return;
    }
    bool finite = true;
    for (std::size_t i = 0; i < corners_m.size(); ++i)
        finite =
            findings.inRange(corners_m[i], limits::kCoordinate_m, entryPath(path, i)) && finite;
    if (finite && !isSimplePolygon(corners_m))
        findings.conflict(path, IssueId::AreaNotSimple);
}

/** Checks the value of a field by itself. */
template <class T, class Value>
void checkValue(const Field<T>& field, const Value& value, const std::string& path,
                Findings& findings)
{
    if constexpr (std::is_same_v<Value, std::string>) {
        if (field.quantity != Quantity::Utc)
            findings.utf8(value, path);
        else if (!value.empty() && !isUtcTime(value))
            findings.error(path, IssueId::NotUtcTime);
    } else if constexpr (std::is_same_v<Value, std::vector<Point>>) {
        if (field.traits.presence == Presence::Needed || !value.empty())
            checkPolygon(value, path, findings);
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
        if (value < 0 || value > kLargestSeed)
            findings.error(path, IssueId::OutOfRange, {std::int64_t{0}, kLargestSeed, value});
    } else if constexpr (!std::is_enum_v<Value> && !std::is_same_v<Value, bool>) {
        if (!field.limits)
            return;
        Limits limits = *field.limits;
        if constexpr (std::is_same_v<Value, double>)
            if (field.traits.zeroIsNone && !(value > 0))
                limits.low = 0;
        findings.inRange(value, limits, path);
    }
}

/** Checks each field by itself; `path` is the path of the object and ends with a dot. */
template <class T>
void checkFields(std::span<const Field<T>> fields, const T& object, const std::string& path,
                 Findings& findings)
{
    for (const Field<T>& field : fields)
        withField(field, object, [&](const auto& value) {
            checkValue(field, value, path + field.name, findings);
        });
}

template <class T>
void checkFields(const T& object, const std::string& path, Findings& findings)
{
    checkFields(fieldsOf<T>(), object, path, findings);
}

template <class T>
void checkFields(const std::optional<T>& object, const std::string& path, Findings& findings)
{
    if (object)
        checkFields(*object, path, findings);
}

void checkRun(const Scenario& s, Findings& findings)
{
    checkFields(s, "", findings);
    checkFields(s.origin, "origin.", findings);
    if (!findings.has("duration_s") && !findings.has("dt_s") && s.dt_s > s.duration_s)
        findings.conflict("dt_s", IssueId::StepTooLong);
}

void checkHeights(double floor_m, const std::optional<double>& ceiling_m, const std::string& field,
                  Findings& findings)
{
    if (ceiling_m && *ceiling_m <= floor_m && !findings.has(field))
        findings.conflict(
            field, IssueId::CeilingTooLow,
            {Amount{floor_m, Quantity::Height}, Amount{*ceiling_m, Quantity::Height}});
}

/** Checks fields and heights of an area. */
template <class Area>
void checkArea(const Area& area, const std::string& path, Findings& findings)
{
    checkFields(area, path + '.', findings);
    if (!findings.has(path + ".floor_m"))
        checkHeights(area.floor_m, area.ceiling_m, path + ".ceiling_m", findings);
}

void checkNoFlyAreas(const std::vector<NoFlyArea>& areas, Findings& findings)
{
    if (areas.size() > kMostNoFlyAreas) {
        findings.error("no_fly", IssueId::NoFlyCount,
                       {countOf(kMostNoFlyAreas), countOf(areas.size())});
        return;
    }
    for (std::size_t i = 0; i < areas.size(); ++i)
        checkArea(areas[i], entryPath("no_fly", i), findings);
}

void checkAirspace(const std::vector<AirspaceArea>& airspace, Findings& findings)
{
    if (airspace.size() > kMostAirspaceAreas) {
        findings.error("airspace", IssueId::AirspaceCount,
                       {countOf(kMostAirspaceAreas), countOf(airspace.size())});
        return;
    }
    for (std::size_t i = 0; i < airspace.size(); ++i) {
        const AirspaceArea& area = airspace[i];
        const std::string path = entryPath("airspace", i);
        checkArea(area, path, findings);
        if (endsTooEarly(area))
            findings.conflict(path + ".until_utc", IssueId::AirspaceTimes,
                              {titleOf(area).empty() ? path : printable(titleOf(area))});
    }
}

/** Checks the fields and outlines of an ice chart; outlines may cross, as only a map shows them. */
void checkIceChart(const IceChart& chart, Findings& findings)
{
    checkFields(chart, "ice_chart.", findings);
    if (chart.areas.size() > kMostIceAreas) {
        findings.error("ice_chart.areas", IssueId::IceAreaCount,
                       {countOf(kMostIceAreas), countOf(chart.areas.size())});
        return;
    }
    std::size_t corners = 0;
    for (std::size_t i = 0; i < chart.areas.size(); ++i) {
        const IceArea& area = chart.areas[i];
        const std::string path = entryPath("ice_chart.areas", i);
        checkFields(area, path + '.', findings);
        if (area.outlines_m.empty())
            findings.error(path + ".outlines_m", IssueId::IceOutlineCorners);
        for (std::size_t ring = 0; ring < area.outlines_m.size(); ++ring) {
            const std::vector<Point>& outline_m = area.outlines_m[ring];
            const std::string ringPath = entryPath(path + ".outlines_m", ring);
            corners += outline_m.size();
            if (outline_m.size() < 3)
                findings.error(ringPath, IssueId::IceOutlineCorners);
            for (std::size_t j = 0; j < outline_m.size(); ++j)
                findings.inRange(outline_m[j], limits::kCoordinate_m, entryPath(ringPath, j));
        }
    }
    if (corners > kMostIceCorners)
        findings.error("ice_chart.areas", IssueId::IceCornerCount,
                       {countOf(kMostIceCorners), countOf(corners)});
}

/** Returns why an id is unusable of which `owner` is the object that has it already, if any. */
std::optional<IssueReason> faultOf(const std::string& id, const std::optional<std::string>& owner)
{
    if (id.empty())
        return IssueReason{IssueId::IdEmpty};
    if (!isUtf8(id))
        return IssueReason{IssueId::NotUtf8};
    return owner ? std::optional(IssueReason{IssueId::IdTaken, {printable(id), FieldPath{*owner}}})
                 : std::nullopt;
}

/** Checks that an id is present, readable and unique among UAVs and icebergs together. */
void checkId(const std::string& id, const std::string& owner,
             std::map<std::string, std::string>& ownerOfId, Findings& findings)
{
    const auto [it, isNew] = ownerOfId.try_emplace(id, owner);
    std::optional<IssueReason> fault =
        faultOf(id, isNew ? std::nullopt : std::optional(it->second));
    if (fault && fault->id != IssueId::NotUtf8) // which is reported with the other texts
        findings.error(owner + ".id", fault->id, std::move(fault->arguments));
}

/**
 * Checks that reserve, climb and landing leave flight time, and that the autopilot is fast enough.
 */
void checkEndurance(const UavSpec& spec, const std::string& path, Findings& findings)
{
    const auto isInRange = [&](const char* field) { return !findings.has(path + field); };
    if (isInRange(".reserve_") && isInRange(".climb_s") && isInRange(".landing_s") &&
        spec.endurance_s > 0 && usableEndurance_s(spec) <= 0)
        findings.conflict(path + ".endurance_s", IssueId::NothingToFly,
                          {Amount{spec.endurance_s, Quantity::Seconds},
                           Amount{spec.endurance_s - usableEndurance_s(spec), Quantity::Seconds}});
    if (isInRange(".autopilot_s") && spec.endurance_s > 0 && spec.autopilot_s > kSlowestHoming_s)
        findings.conflict(path + ".autopilot_s", IssueId::AutopilotTooSlow,
                          {kSlowestHoming_s, spec.autopilot_s});
}

void checkUavs(const Scenario& s, std::map<std::string, std::string>& ownerOfId, Findings& findings)
{
    if (s.uavs.empty() || s.uavs.size() > kMostUavs) {
        findings.error("uavs", IssueId::UavCount, {countOf(kMostUavs), countOf(s.uavs.size())});
        return;
    }
    for (std::size_t i = 0; i < s.uavs.size(); ++i) {
        const std::string path = entryPath("uavs", i);
        checkId(s.uavs[i].id, path, ownerOfId, findings);
        checkFields(s.uavs[i], path + '.', findings);
        checkEndurance(s.uavs[i].spec, path, findings);
    }
}

/** Checks that UAVs start and land inside the geofence and that it is not too complex. */
void checkGeofence(const Scenario& s, Findings& findings)
{
    if (!s.geofence)
        return;
    if (s.area_m.empty()) {
        findings.conflict("geofence", IssueId::FenceNoArea);
        return;
    }
    if (s.area_m.size() > kMostFenceCorners)
        findings.conflict("area_m", IssueId::FenceCorners,
                          {countOf(kMostFenceCorners), countOf(s.area_m.size())});
    const auto inside = [&](const Point& place_m, const std::string& field) {
        if (place_m.allFinite() && !insidePolygon(s.area_m, place_m))
            findings.conflict(field, IssueId::OutsideFence);
    };
    for (std::size_t i = 0; i < s.uavs.size(); ++i) {
        inside(s.uavs[i].position_m, entryPath("uavs", i) + ".position_m");
        if (s.uavs[i].home_m)
            inside(*s.uavs[i].home_m, entryPath("uavs", i) + ".home_m");
    }
}

/** Checks that UAVs start and land outside closed areas and that these are not too complex. */
void checkClosedAreas(const Scenario& s, Findings& findings)
{
    if (s.noFly.size() > kMostNoFlyAreas)
        return;
    const std::vector<NoFlyArea> areas = closedAreas(s);
    std::size_t corners = 0;
    for (std::size_t i = 0; i < s.uavs.size(); ++i) {
        const Uav& uav = s.uavs[i];
        corners = std::max(corners, cornersAt(areas, uav.spec.altitude_m));
        const auto outside = [&](const Point& place_m, const std::string& field) {
            const std::size_t k = closedAt(areas, uav.spec.altitude_m, place_m);
            if (k < s.noFly.size())
                findings.conflict(
                    field, IssueId::InsideNoFly,
                    {areas[k].name.empty() ? entryPath("no_fly", k) : printable(areas[k].name)});
            else if (k < areas.size())
                findings.conflict(field, IssueId::InsideStandoff);
        };
        outside(uav.position_m, entryPath("uavs", i) + ".position_m");
        if (uav.home_m)
            outside(*uav.home_m, entryPath("uavs", i) + ".home_m");
    }
    if (corners > 0 && s.geofence && s.area_m.size() <= kMostFenceCorners)
        corners += s.area_m.size();
    if (corners > kMostFenceCorners)
        findings.conflict(s.noFly.empty() ? "asset.standoff_m" : "no_fly", IssueId::NoFlyCorners,
                          {countOf(kMostFenceCorners), countOf(corners)});
}

/** Checks that times increase and each has a position. An empty track is valid. */
void checkTrack(const RecordedTrack& track, const std::string& path, Findings& findings)
{
    if (track.empty() && track.position_m.empty())
        return;
    const std::size_t points = track.time_s.size();
    if (points < 2 || points > kMostTrackPoints) {
        findings.error(path + ".time_s", IssueId::TrackPoints,
                       {countOf(kMostTrackPoints), countOf(points)});
        return;
    }
    if (track.position_m.size() != points) {
        findings.error(path + ".position_m", IssueId::TrackPlaces,
                       {countOf(points), countOf(track.position_m.size())});
        return;
    }
    for (std::size_t i = 0; i < points; ++i) {
        const std::string time = entryPath(path + ".time_s", i);
        if (findings.inRange(track.time_s[i], limits::kTrackTime_s, time) && i > 0 &&
            !(track.time_s[i] > track.time_s[i - 1]))
            findings.error(time, IssueId::TrackNotRising);
        findings.inRange(track.position_m[i], limits::kCoordinate_m,
                         entryPath(path + ".position_m", i));
    }
}

void checkIcebergs(const Scenario& s, std::map<std::string, std::string>& ownerOfId,
                   Findings& findings)
{
    if (s.icebergs.size() > kMostIcebergs) {
        findings.error("icebergs", IssueId::IcebergCount,
                       {countOf(kMostIcebergs), countOf(s.icebergs.size())});
        return;
    }
    if (s.icebergs.empty())
        findings.hint("icebergs", IssueId::NoIcebergs);
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        const Iceberg& iceberg = s.icebergs[i];
        const std::string path = entryPath("icebergs", i);
        checkId(iceberg.id, path, ownerOfId, findings);
        checkFields(iceberg, path + '.', findings);
        checkTrack(iceberg.track, path + ".track", findings);
        if (iceberg.appears_s > s.duration_s && std::isfinite(iceberg.appears_s))
            findings.hint(path + ".appears_s", IssueId::AppearsTooLate);
    }
}

/** Checks that the UAVs to which icebergs are assigned exist. */
void checkFleet(const Scenario& s, Findings& findings)
{
    if (s.icebergs.size() > kMostIcebergs)
        return;
    std::set<std::string_view> known;
    for (const Uav& uav : s.uavs)
        known.insert(uav.id);
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        const std::string& uav = s.icebergs[i].uav;
        const std::string path = entryPath("icebergs", i) + ".uav";
        if (isUtf8(uav) && !uav.empty() && !known.contains(uav))
            findings.conflict(path, IssueId::UnknownUav, {printable(uav)});
    }
}

/** Returns the slowest UAV with a valid airspeed, or null if there is none. */
const Uav* slowestUav(const Scenario& s)
{
    const Uav* slowest = nullptr;
    for (const Uav& uav : s.uavs)
        if (uav.spec.airspeed_mps > 0 &&
            (slowest == nullptr || uav.spec.airspeed_mps < slowest->spec.airspeed_mps))
            slowest = &uav;
    return slowest;
}

/** Checks that the UAV can fly against the wind of the forecast at any time of the run. */
void checkForecastWind(const Scenario& s, const Uav& slowest, Findings& findings)
{
    const std::shared_ptr<const FlightWeather> weather =
        findings.has("forecast") || findings.has("origin") || findings.has("start_utc") ||
                findings.has("duration_s") || findings.has("uavs")
            ? nullptr
            : weatherOf(s);
    if (!weather)
        return;
    const double wind_mps = weather->strongestWind_mps();
    const std::vector<IssueArgument> speeds{
        Amount{std::round(100 * wind_mps) / 100, Quantity::Speed}, printable(slowest.id),
        Amount{slowest.spec.airspeed_mps, Quantity::Speed}};
    if (!(wind_mps < slowest.spec.airspeed_mps))
        findings.conflict("forecast", IssueId::WindTooFast, speeds);
    else if (wind_mps >= kStrongWindShare * slowest.spec.airspeed_mps)
        findings.warn("forecast", IssueId::StrongWind, speeds);
}

/** Checks that UAVs can fly against wind and current and follow the icebergs. */
void checkDrift(const Scenario& s, Findings& findings)
{
    if (!s.wind_mps.allFinite()) {
        findings.error("wind_mps", IssueId::NotFinitePair);
        return;
    }
    const Uav* slowest = slowestUav(s);
    if (slowest == nullptr)
        return;
    const double airspeed_mps = slowest->spec.airspeed_mps;
    const double wind_mps = s.wind_mps.norm();
    const std::vector<IssueArgument> speeds{
        Amount{std::round(100 * wind_mps) / 100, Quantity::Speed}, printable(slowest->id),
        Amount{airspeed_mps, Quantity::Speed}};
    if (!(wind_mps < airspeed_mps)) {
        findings.conflict("wind_mps", IssueId::WindTooFast, speeds);
        return;
    }
    if (wind_mps >= kStrongWindShare * airspeed_mps)
        findings.warn("wind_mps", IssueId::StrongWind, speeds);
    checkForecastWind(s, *slowest, findings);
    if (findings.has("current_mps") || s.icebergs.size() > kMostIcebergs)
        return;
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        const Point drift_mps =
            s.icebergs[i].velocity_mps + (findings.has(entryPath("icebergs", i) + ".length_m")
                                              ? s.current_mps
                                              : meanDrift_mps(s, s.icebergs[i]));
        if ((s.wind_mps - drift_mps).norm() >= airspeed_mps)
            findings.warn(entryPath("icebergs", i) + ".velocity_mps", IssueId::DriftTooFast);
    }
}

void checkObserver(const Scenario& s, Findings& findings)
{
    checkFields(s.observer, "observer.", findings);
    if (!findings.has("observer.interval_s") && s.observer.model == ObserverModel::Kalman &&
        s.observer.interval_s < s.dt_s)
        findings.conflict("observer.interval_s", IssueId::SensorIntervalTooShort);
}

std::vector<Issue> found(const Scenario& scenario, Findings::Kind kind)
{
    Findings findings(kind);
    std::map<std::string, std::string> ownerOfId;
    checkRun(scenario, findings);
    checkNoFlyAreas(scenario.noFly, findings);
    checkFields(scenario.operation, "operation.", findings);
    checkAirspace(scenario.airspace, findings);
    if (scenario.iceChart)
        checkIceChart(*scenario.iceChart, findings);
    checkUavs(scenario, ownerOfId, findings);
    checkGeofence(scenario, findings);
    checkClosedAreas(scenario, findings);
    checkIcebergs(scenario, ownerOfId, findings);
    checkFleet(scenario, findings);
    checkForecast(scenario, findings);
    checkDrift(scenario, findings);
    checkFields(scenario.asset, "asset.", findings);
    if (scenario.asset)
        checkHeights(0, scenario.asset->standoffCeiling_m, "asset.standoff_ceiling_m", findings);
    checkFields(scenario.weather, "weather.", findings);
    checkFields(scenario.groundStation, "ground_station.", findings);
    checkObserver(scenario, findings);
    checkFields(plannerFields(), scenario, "planner.", findings);
    return findings.take();
}

} // namespace

std::vector<Issue> validate(const Scenario& scenario)
{
    std::vector<Issue> issues = found(scenario, Findings::Kind::All);
    if (!hasErrors(issues)) // the warnings compute with the numbers
        for (Issue& issue : scenarioWarnings(scenario))
            issues.push_back(std::move(issue));
    return issues;
}

std::vector<Issue> unreadable(const Scenario& scenario)
{
    return found(scenario, Findings::Kind::Unreadable);
}

std::optional<IssueReason> idFault(const Scenario& scenario, const std::string& id)
{
    const auto ownerIn = [&id](const auto& objects, const char* list) {
        const auto it = std::ranges::find_if(objects, [&id](const auto& o) { return o.id == id; });
        return it == objects.end()
                   ? std::nullopt
                   : std::optional(entryPath(list, static_cast<std::size_t>(it - objects.begin())));
    };
    const std::optional<std::string> uav = ownerIn(scenario.uavs, "uavs");
    return faultOf(id, uav ? uav : ownerIn(scenario.icebergs, "icebergs"));
}

} // namespace berg
