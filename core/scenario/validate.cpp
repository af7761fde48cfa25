#include "core/scenario/validate.h"

#include "core/plan/solve/names.h"
#include "core/scenario/advice.h"
#include "core/scenario/airspace.h"
#include "core/scenario/checks.h"
#include "core/scenario/fence.h"
#include "core/scenario/findings.h"
#include "core/scenario/operation.h"
#include "core/vehicle/safety_guard.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

namespace berg {

namespace {

void checkRun(const Scenario& s, Findings& findings)
{
    findings.utf8(s.name, "name");
    findings.utf8(s.notes, "notes");
    findings.inRange(s.origin.latitude_deg, limits::kLatitude_deg, "origin.latitude_deg");
    findings.inRange(s.origin.longitude_deg, limits::kLongitude_deg, "origin.longitude_deg");
    if (!s.startUtc.empty() && !isUtcTime(s.startUtc))
        findings.error("start_utc", IssueId::NotUtcTime);
    const bool duration = findings.inRange(s.duration_s, limits::kDuration_s, "duration_s");
    const bool dt = findings.inRange(s.dt_s, limits::kTimeStep_s, "dt_s");
    if (duration && dt && s.dt_s > s.duration_s)
        findings.conflict("dt_s", IssueId::StepTooLong);
    if (s.seed < 0 || s.seed > kLargestSeed)
        findings.error("seed", IssueId::OutOfRange, {std::int64_t{0}, kLargestSeed, s.seed});
}

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

void checkHeights(double floor_m, const std::optional<double>& ceiling_m, const std::string& field,
                  Findings& findings)
{
    if (findings.inRange(ceiling_m, limits::kCeiling_m, field) && ceiling_m &&
        *ceiling_m <= floor_m)
        findings.conflict(field, IssueId::CeilingTooLow, {floor_m, *ceiling_m});
}

void checkAreas(const Scenario& s, Findings& findings)
{
    if (!s.area_m.empty())
        checkPolygon(s.area_m, "area_m", findings);
    if (s.noFly.size() > kMostNoFlyAreas) {
        findings.error("no_fly", IssueId::NoFlyCount,
                       {countOf(kMostNoFlyAreas), countOf(s.noFly.size())});
        return;
    }
    for (std::size_t i = 0; i < s.noFly.size(); ++i) {
        const NoFlyArea& area = s.noFly[i];
        const std::string path = entryPath("no_fly", i);
        findings.utf8(area.name, path + ".name");
        checkPolygon(area.corners_m, path + ".area_m", findings);
        if (findings.inRange(area.floor_m, limits::kLength_m, path + ".floor_m"))
            checkHeights(area.floor_m, area.ceiling_m, path + ".ceiling_m", findings);
    }
}

void checkOperation(const std::optional<Operation>& operation, Findings& findings)
{
    if (!operation)
        return;
    for (const OperationNumber& number : kOperationNumbers)
        findings.inRange((*operation).*number.member, number.limits,
                         "operation." + std::string(number.name));
    for (const OperationText& text : kOperationTexts)
        findings.utf8((*operation).*text.member, "operation." + std::string(text.name));
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
        findings.utf8(area.name, path + ".name");
        findings.utf8(area.kind, path + ".kind");
        checkPolygon(area.corners_m, path + ".area_m", findings);
        if (findings.inRange(area.floor_m, limits::kLength_m, path + ".floor_m"))
            checkHeights(area.floor_m, area.ceiling_m, path + ".ceiling_m", findings);
        if (!area.fromUtc.empty() && !isUtcTime(area.fromUtc))
            findings.error(path + ".from_utc", IssueId::NotUtcTime);
        if (!area.untilUtc.empty() && !isUtcTime(area.untilUtc))
            findings.error(path + ".until_utc", IssueId::NotUtcTime);
        if (endsTooEarly(area))
            findings.conflict(
                path + ".until_utc", IssueId::AirspaceTimes,
                {path + ".from_utc", titleOf(area).empty() ? path : printable(titleOf(area))});
    }
}

void checkWeather(const Weather& weather, Findings& findings)
{
    findings.inRange(weather.gust_mps, limits::kWindSpeed_mps, "weather.gust_mps");
    findings.inRange(weather.temperature_degC, limits::kTemperature_degC,
                     "weather.temperature_degc");
    findings.inRange(weather.dewPoint_degC, limits::kTemperature_degC, "weather.dew_point_degc");
}

void checkGroundStation(const std::optional<GroundStation>& station, Findings& findings)
{
    if (!station)
        return;
    findings.inRange(station->position_m, limits::kCoordinate_m, "ground_station.position_m");
    findings.inRange(station->antenna_m, limits::kLength_m, "ground_station.antenna_m");
    findings.inRange(station->range_m, limits::kExtent_m, "ground_station.range_m");
}

/** An id must be there, readable and unique over UAVs and icebergs together. */
void checkId(const std::string& id, const std::string& owner,
             std::map<std::string, std::string>& ownerOfId, Findings& findings)
{
    findings.utf8(id, owner + ".id");
    if (id.empty())
        findings.error(owner + ".id", IssueId::IdEmpty);
    if (id.empty() || !isUtf8(id))
        return;
    const auto [it, isNew] = ownerOfId.try_emplace(id, owner);
    if (!isNew)
        findings.error(owner + ".id", IssueId::IdTaken, {printable(id), it->second});
}

/** What is left to fly with after reserve, climb and landing. */
void checkReserve(const UavSpec& spec, const std::string& path, Findings& findings)
{
    bool inRange =
        findings.inRange(spec.reservePercent, limits::kReservePercent, path + ".reserve_percent");
    inRange = findings.inRange(spec.reserve_s, limits::kTime_s, path + ".reserve_s") && inRange;
    inRange = findings.inRange(spec.climb_s, limits::kTime_s, path + ".climb_s") && inRange;
    inRange = findings.inRange(spec.landing_s, limits::kTime_s, path + ".landing_s") && inRange;
    if (inRange && spec.endurance_s > 0 && usableEndurance_s(spec) <= 0)
        findings.conflict(path + ".endurance_s", IssueId::NothingToFly,
                          {spec.endurance_s, spec.endurance_s - usableEndurance_s(spec)});
}

void checkUav(const Uav& uav, const std::string& path, Findings& findings)
{
    findings.utf8(uav.name, path + ".name");
    findings.inRange(uav.position_m, limits::kCoordinate_m, path + ".position_m");
    if (!std::isfinite(uav.heading_deg))
        findings.error(path + ".heading_deg", IssueId::NotFinite);
    findings.inRange(uav.spec.airspeed_mps, limits::kAirspeed_mps, path + ".airspeed_mps");
    findings.inRange(uav.spec.maxBank_deg, limits::kBank_deg, path + ".max_bank_deg");
    findings.inRange(uav.fov_m, limits::kExtent_m, path + ".fov_m");
    findings.inRange(uav.spec.altitude_m, limits::kExtent_m, path + ".altitude_m");
    // In memory 0 stands for "none"; a file leaves the member out instead.
    findings.inRange(uav.spec.endurance_s,
                     uav.spec.endurance_s > 0 ? limits::kEndurance_s : limits::kTime_s,
                     path + ".endurance_s");
    if (uav.home_m)
        findings.inRange(*uav.home_m, limits::kCoordinate_m, path + ".home_m");
    findings.inRange(uav.turnaround_s, limits::kTime_s, path + ".turnaround_s");
    checkReserve(uav.spec, path, findings);
    findings.inRange(uav.weather.wind_mps, limits::kWindSpeed_mps, path + ".max_wind_mps");
    findings.inRange(uav.weather.gust_mps, limits::kWindSpeed_mps, path + ".max_gust_mps");
    if (findings.inRange(uav.spec.autopilot_s, limits::kAutopilot_s, path + ".autopilot_s") &&
        uav.spec.endurance_s > 0 && uav.spec.autopilot_s > kSlowestHoming_s)
        findings.conflict(path + ".autopilot_s", IssueId::AutopilotTooSlow,
                          {kSlowestHoming_s, uav.spec.autopilot_s});
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
        checkUav(s.uavs[i], path, findings);
    }
}

/** The UAVs start and land inside a polygon that can be kept inside of. */
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

/** The UAVs start and land outside what they cannot fly into, which can be flown round. */
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

/** Times that rise, each with a place; an empty track is none. */
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

void checkIceberg(const Iceberg& iceberg, const std::string& path, Findings& findings)
{
    findings.utf8(iceberg.name, path + ".name");
    findings.inRange(iceberg.position_m, limits::kCoordinate_m, path + ".position_m");
    findings.inRange(iceberg.velocity_mps, limits::kVelocity_mps, path + ".velocity_mps");
    findings.inRange(iceberg.velocitySd_mps, limits::kSpeed_mps, path + ".velocity_sd_mps");
    findings.inRange(iceberg.velocitySpread_mps, limits::kSpeed_mps, path + ".velocity_spread_mps");
    findings.inRange(iceberg.velocityTime_s, limits::kTime_s, path + ".velocity_time_s");
    findings.inRange(iceberg.q_m2ps, limits::kGrowth_m2ps, path + ".q_m2ps");
    findings.inRange(iceberg.sigma0_m2, limits::kSigma_m2, path + ".sigma0_m2");
    findings.inRange(iceberg.observed_s, limits::kTime_s, path + ".observed_s");
    findings.inRange(iceberg.appears_s, limits::kTime_s, path + ".appears_s");
    findings.inRange(iceberg.radius_m, limits::kLength_m, path + ".radius_m");
    checkTrack(iceberg.track, path + ".track", findings);
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
        checkIceberg(iceberg, path, findings);
        if (iceberg.appears_s > s.duration_s && std::isfinite(iceberg.appears_s))
            findings.hint(path + ".appears_s", IssueId::AppearsTooLate);
    }
}

/** Whom icebergs are kept for, and how far apart those fly. */
void checkFleet(const Scenario& s, Findings& findings)
{
    findings.inRange(s.separation_m, limits::kLength_m, "separation_m");
    if (s.icebergs.size() > kMostIcebergs)
        return;
    std::set<std::string_view> known;
    for (const Uav& uav : s.uavs)
        known.insert(uav.id);
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        const std::string& uav = s.icebergs[i].uav;
        const std::string path = entryPath("icebergs", i) + ".uav";
        findings.utf8(uav, path);
        if (isUtf8(uav) && !uav.empty() && !known.contains(uav))
            findings.conflict(path, IssueId::UnknownUav, {printable(uav)});
    }
}

/** The slowest UAV whose airspeed is valid; null when there is none. */
const Uav* slowestUav(const Scenario& s)
{
    const Uav* slowest = nullptr;
    for (const Uav& uav : s.uavs)
        if (uav.spec.airspeed_mps > 0 &&
            (slowest == nullptr || uav.spec.airspeed_mps < slowest->spec.airspeed_mps))
            slowest = &uav;
    return slowest;
}

/** Wind and current: what the UAV can still make way against, and follow. */
void checkDrift(const Scenario& s, Findings& findings)
{
    const bool current = findings.inRange(s.current_mps, limits::kVelocity_mps, "current_mps");
    if (!s.wind_mps.allFinite()) {
        findings.error("wind_mps", IssueId::NotFinitePair);
        return;
    }
    const Uav* slowest = slowestUav(s);
    if (slowest == nullptr)
        return;
    const double airspeed_mps = slowest->spec.airspeed_mps;
    const double wind_mps = s.wind_mps.norm();
    const std::vector<IssueArgument> speeds{wind_mps, printable(slowest->id), airspeed_mps};
    if (!(wind_mps < airspeed_mps)) {
        findings.conflict("wind_mps", IssueId::WindTooFast, speeds);
        return;
    }
    if (wind_mps >= kStrongWindShare * airspeed_mps)
        findings.warn("wind_mps", IssueId::StrongWind, speeds);
    if (!current || s.icebergs.size() > kMostIcebergs)
        return;
    for (std::size_t i = 0; i < s.icebergs.size(); ++i) {
        const Point drift_mps = s.icebergs[i].velocity_mps + s.current_mps;
        if ((s.wind_mps - drift_mps).norm() >= airspeed_mps)
            findings.warn(entryPath("icebergs", i) + ".velocity_mps", IssueId::DriftTooFast);
    }
}

void checkAsset(const Scenario& s, Findings& findings)
{
    if (!s.asset)
        return;
    findings.utf8(s.asset->name, "asset.name");
    findings.inRange(s.asset->position_m, limits::kCoordinate_m, "asset.position_m");
    findings.inRange(s.asset->velocity_mps, limits::kAssetVelocity_mps, "asset.velocity_mps");
    findings.inRange(s.asset->range_m, limits::kExtent_m, "asset.range_m");
    findings.inRange(s.asset->gain, limits::kGain, "asset.gain");
    findings.inRange(s.asset->alarm_m, limits::kLength_m, "asset.alarm_m");
    findings.inRange(s.asset->standoff_m, limits::kLength_m, "asset.standoff_m");
    checkHeights(0, s.asset->standoffCeiling_m, "asset.standoff_ceiling_m", findings);
}

void checkObserver(const Scenario& s, Findings& findings)
{
    const ObserverSpec& observer = s.observer;
    findings.inRange(observer.positionSd_m, limits::kLength_m, "observer.position_sd_m");
    if (findings.inRange(observer.interval_s, limits::kSensorInterval_s, "observer.interval_s") &&
        observer.model == ObserverModel::Kalman && observer.interval_s < s.dt_s)
        findings.conflict("observer.interval_s", IssueId::SensorIntervalTooShort);
    findings.inRange(observer.detection, limits::kDetection, "observer.detection");
}

void checkPlanner(const Scenario& s, Findings& findings)
{
    findings.inRange(s.planner.tau, limits::kTau, "planner.tau");
    findings.inRange(s.planningTime_s, limits::kPlanningDelay_s, "planner.planning_delay_s");
    findings.inRange(s.reachRadius_m, limits::kExtent_m, "planner.reach_radius_m");
}

std::vector<Issue> found(const Scenario& scenario, Findings::Kind kind)
{
    Findings findings(kind);
    std::map<std::string, std::string> ownerOfId;
    checkRun(scenario, findings);
    checkAreas(scenario, findings);
    checkOperation(scenario.operation, findings);
    checkAirspace(scenario.airspace, findings);
    checkUavs(scenario, ownerOfId, findings);
    checkGeofence(scenario, findings);
    checkClosedAreas(scenario, findings);
    checkIcebergs(scenario, ownerOfId, findings);
    checkFleet(scenario, findings);
    checkDrift(scenario, findings);
    checkAsset(scenario, findings);
    checkWeather(scenario.weather, findings);
    checkGroundStation(scenario.groundStation, findings);
    checkObserver(scenario, findings);
    checkPlanner(scenario, findings);
    return findings.take();
}

} // namespace

std::vector<Issue> validate(const Scenario& scenario)
{
    std::vector<Issue> issues = found(scenario, Findings::Kind::All);
    if (!hasErrors(issues)) // advice reckons with the numbers
        for (Issue& issue : advice(scenario))
            issues.push_back(std::move(issue));
    return issues;
}

std::vector<Issue> unreadable(const Scenario& scenario)
{
    return found(scenario, Findings::Kind::Unreadable);
}

} // namespace berg
