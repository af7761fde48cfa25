#include "core/io/export/missions/mission_ends.h"

#include "core/base/angles.h"
#include "core/io/text/export_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr double kLeastClimb_m = 50; ///< nearer, a fixed wing would circle its take-off item
constexpr double kLeastPitch_deg = 5;

MavItem itemAt(const ExportContent& content, const Point& position_m, std::uint16_t command,
               double altitude_m)
{
    return {.command = command,
            .place = roundedPlace(content.frame.toGeographic(position_m)),
            .altitude_m = altitude_m};
}

MavItem plainItem(std::uint16_t command)
{
    return {.command = command, .frame = ItemFrame::NoPosition};
}

Point unitCourse(double course_deg)
{
    const double course_rad = radFromDeg(course_deg);
    return {std::sin(course_rad), std::cos(course_rad)};
}

bool isPlane(const ExportUav& uav)
{
    return uav.uav.aircraft.airframe == Airframe::FixedWing;
}

/** Returns the direction of the approach: as chosen, against the wind, or from the last place. */
Point approachDirection(const ExportContent& content, const ExportUav& uav)
{
    constexpr double kCalm_mps = 0.1;
    if (uav.uav.aircraft.approachCourse_deg)
        return unitCourse(*uav.uav.aircraft.approachCourse_deg);
    if (content.wind_mps.norm() > kCalm_mps)
        return -content.wind_mps.normalized();
    const Point leg_m = uav.home_m - lastPlace_m(content, uav);
    return leg_m.norm() > 1 ? leg_m.normalized() : unitCourse(uav.uav.heading_deg);
}

std::vector<MavItem> landingItems(const ExportContent& content, const ExportUav& uav,
                                  const LandingPattern& pattern)
{
    const AircraftProfile& aircraft = uav.uav.aircraft;
    std::vector<MavItem> items;
    if (aircraft.airframe != Airframe::Multirotor)
        items.push_back(plainItem(LinkCommandId::kLandStart));
    MavItem before =
        itemAt(content, pattern.from_m,
               isPlane(uav) ? LinkCommandId::kLoiterToAltitude : LinkCommandId::kWaypoint,
               aircraft.approachAltitude_m);
    if (isPlane(uav)) // p1 and p4: leave the circle towards the landing, on its tangent
        before.params = {1, loiterRadius_m(uav), 0, 1};
    items.push_back(before);
    items.push_back(itemAt(
        content, pattern.home_m,
        aircraft.airframe == Airframe::Vtol ? LinkCommandId::kVtolLand : LinkCommandId::kLand, 0));
    return items;
}

MavItem lastLoiter(const ExportContent& content, const ExportUav& uav)
{
    MavItem item = itemAt(content, lastPlace_m(content, uav), LinkCommandId::kLoiterUnlimited,
                          uav.uav.spec.altitude_m);
    if (uav.uav.aircraft.airframe != Airframe::Multirotor)
        item.params[2] = loiterRadius_m(uav);
    return item;
}

} // namespace

double climbDistance_m(const AircraftProfile& aircraft, double altitude_m)
{
    const double pitch_deg = std::max(aircraft.takeOffPitch_deg, kLeastPitch_deg);
    return altitude_m / std::tan(radFromDeg(pitch_deg));
}

std::optional<Point> takeOffPlace_m(const ExportUav& uav)
{
    const AircraftProfile& aircraft = uav.uav.aircraft;
    if (uav.isAloft || aircraft.takeOff == TakeOffMethod::Hand)
        return std::nullopt;
    if (!isPlane(uav))
        return uav.uav.position_m;
    const double climb_m =
        std::max(kLeastClimb_m, climbDistance_m(aircraft, aircraft.takeOffAltitude_m));
    return Point(uav.uav.position_m + climb_m * unitCourse(uav.uav.heading_deg));
}

Point lastPlace_m(const ExportContent& content, const ExportUav& uav)
{
    if (content.what == ExportScope::Path)
        return endOf(uav).position_m;
    return uav.visits.empty() ? uav.home_m : uav.visits.back().position_m;
}

std::optional<LandingPattern> landingPattern(const ExportContent& content, const ExportUav& uav)
{
    const AircraftProfile& aircraft = uav.uav.aircraft;
    if (aircraft.end != MissionEnd::Landing || !endsAtHome(content))
        return std::nullopt;
    if (aircraft.airframe == Airframe::Multirotor)
        return LandingPattern{.from_m = uav.home_m, .home_m = uav.home_m};
    // The landing place is outside the circle, from which the approach leads along a tangent.
    const double radius_m = isPlane(uav) ? loiterRadius_m(uav) : 0;
    const double length_m = std::max(aircraft.approach_m, 2 * radius_m);
    const double tangent_m = std::sqrt(length_m * length_m - radius_m * radius_m);
    return LandingPattern{.from_m = uav.home_m - length_m * approachDirection(content, uav),
                          .home_m = uav.home_m,
                          .slope_deg =
                              degFromRad(std::atan2(aircraft.approachAltitude_m, tangent_m))};
}

std::vector<MavItem> takeOffItems(const ExportContent& content, const ExportUav& uav)
{
    const std::optional<Point> place_m = takeOffPlace_m(uav);
    if (!place_m)
        return {};
    const AircraftProfile& aircraft = uav.uav.aircraft;
    MavItem item = itemAt(content, *place_m,
                          aircraft.airframe == Airframe::Vtol ? LinkCommandId::kVtolTakeOff
                                                              : LinkCommandId::kTakeOff,
                          aircraft.takeOffAltitude_m);
    if (isPlane(uav))
        item.params[0] = aircraft.takeOffPitch_deg;
    return {item};
}

std::vector<MavItem> endItems(const ExportContent& content, const ExportUav& uav)
{
    if (const std::optional<LandingPattern> pattern = landingPattern(content, uav))
        return landingItems(content, uav, *pattern);
    if (uav.uav.aircraft.end == MissionEnd::Return && endsAtHome(content))
        return {plainItem(LinkCommandId::kReturnToLaunch)};
    return {lastLoiter(content, uav)};
}

} // namespace berg
