#include "core/io/export/missions/plan_qgc.h"

#include "core/io/export/missions/mission_upload.h"
#include "core/io/text/json_writer.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

// The readers require more than the documented format: QGroundControl requires all of `mission`,
// `geoFence` and `rallyPoints`, seven params and a boolean `autoContinue`; MAVSDK requires versions
// 2, 2 and 2 and a home of three values; Mission Planner reads speeds and all enumerations into
// integers (22.0 fails) and params into plain doubles (null fails).

/** MAV_AUTOPILOT of firmware that flies other missions than a generic one. */
constexpr int kMavArduPilot = 3;
constexpr int kMavPx4 = 12;
/** Altitudes are above home, for the plan and for each item. */
constexpr int kRelativeAltitude = 1;
/** Speeds are read into 32-bit integers; a cruise speed of 0 would make flights endless. */
constexpr double kLargestSpeed_mps = 1e6;

/** Returns the MAV_TYPE of an airframe. */
int mavType(Airframe airframe)
{
    switch (airframe) {
    case Airframe::FixedWing:
        return 1;
    case Airframe::Vtol:
        return 22; // lifted by rotors of its own
    case Airframe::Multirotor:
        return 2;
    }
    throw std::logic_error("mavType: unknown airframe");
}

/** Returns the speed as a whole number. */
int wholeSpeed(double speed_mps)
{
    return static_cast<int>(std::clamp(std::round(speed_mps), 1.0, kLargestSpeed_mps));
}

/**
 * Writes whole numbers without a decimal point: 22 is read as integer and as double, 22.0 is not.
 * NaN becomes null.
 */
Json number(double value)
{
    if (std::isnan(value))
        return nullptr;
    if (std::abs(value) < 1e15 && value == std::floor(value))
        return static_cast<std::int64_t>(value);
    return value;
}

Json jsonItem(const MavItem& item, std::size_t id)
{
    Json json;
    json["type"] = "SimpleItem";
    json["command"] = item.command;
    json["doJumpId"] = id;
    json["frame"] = static_cast<int>(item.frame);
    Json params = Json::array();
    for (const double param : item.params)
        params.push_back(number(param));
    params.push_back(number(item.place.latitude_deg));
    params.push_back(number(item.place.longitude_deg));
    params.push_back(number(item.altitude_m));
    json["params"] = std::move(params);
    json["autoContinue"] = true;
    if (hasPlace(item)) { // readers need all three members or none
        json["AltitudeMode"] = kRelativeAltitude;
        json["Altitude"] = number(item.altitude_m);
        json["AMSLAltAboveTerrain"] = number(item.altitude_m); // home is at sea level
    }
    return json;
}

Json jsonMission(const MavMission& mission)
{
    Json items = Json::array();
    for (const MavItem& item : mission.items)
        items.push_back(jsonItem(item, items.size() + 1));
    const AircraftProfile& aircraft = mission.aircraft;
    const bool hovers = aircraft.airframe == Airframe::Vtol;
    Json json;
    json["version"] = 2;
    json["firmwareType"] =
        aircraft.firmware == AutopilotFirmware::ArduPilot ? kMavArduPilot : kMavPx4;
    json["vehicleType"] = mavType(aircraft.airframe);
    json["globalPlanAltitudeMode"] = kRelativeAltitude;
    json["cruiseSpeed"] = wholeSpeed(mission.airspeed_mps);
    json["hoverSpeed"] = wholeSpeed(hovers ? aircraft.hoverSpeed_mps : mission.airspeed_mps);
    json["plannedHomePosition"] = {number(mission.home.latitude_deg),
                                   number(mission.home.longitude_deg), 0};
    json["items"] = std::move(items);
    return json;
}

Json jsonPolygon(const MissionFence& fence)
{
    Json corners = Json::array();
    for (const LatLon& corner : fence.corners)
        corners.push_back({number(corner.latitude_deg), number(corner.longitude_deg)});
    Json polygon;
    polygon["version"] = 1;
    polygon["inclusion"] = fence.isInclusion;
    polygon["polygon"] = std::move(corners);
    return polygon;
}

Json jsonFence(const ExportContent& content)
{
    Json polygons = Json::array();
    for (const MissionFence& fence : missionFences(content, content.uavs.front()))
        polygons.push_back(jsonPolygon(fence));
    Json json;
    json["version"] = 2;
    json["polygons"] = std::move(polygons);
    json["circles"] = Json::array();
    return json;
}

/** Rally point at home and the altitude of the mission, to which autopilots return on failsafe. */
Json jsonRally(const MavMission& mission)
{
    Json json;
    json["version"] = 2;
    json["points"] = Json::array(
        {Json::array({number(mission.home.latitude_deg), number(mission.home.longitude_deg),
                      number(mission.altitude_m)})});
    return json;
}

} // namespace

std::string qgcPlan(const ExportContent& content)
{
    const MavMission mission = mavMission(content);
    Json plan;
    plan["fileType"] = "Plan";
    plan["version"] = 1;
    plan["groundStation"] = "Bergwatch";
    plan["mission"] = jsonMission(mission);
    plan["geoFence"] = jsonFence(content);
    plan["rallyPoints"] = jsonRally(mission);
    return jsonText(plan, 4) + '\n';
}

} // namespace berg
