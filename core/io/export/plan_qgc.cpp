#include "core/io/export/plan_qgc.h"

#include "core/io/export/mission_items.h"
#include "core/io/text/export_numbers.h"
#include "core/io/text/json_writer.h"
#include "core/scenario/fence.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace berg {

namespace {

using Json = nlohmann::ordered_json;

// The readers require more than the documented format: QGroundControl requires all of `mission`,
// `geoFence` and `rallyPoints`, seven params and a boolean `autoContinue`; MAVSDK requires versions
// 2, 2 and 2 and a home of three values; Mission Planner reads speeds and all enumerations into
// integers (22.0 fails) and params into plain doubles (null fails).

/** MAV_AUTOPILOT_ARDUPILOTMEGA, because limits and loiter of the items are those of ArduPlane. */
constexpr int kArduPilot = 3;
/** MAV_TYPE_FIXED_WING. */
constexpr int kFixedWing = 1;
/** Altitudes are above home, for the plan and for each item. */
constexpr int kRelativeAltitude = 1;
/** Speeds are read into 32-bit integers; a cruise speed of 0 would make flights endless. */
constexpr double kLargestSpeed_mps = 1e6;

/**
 * Writes whole numbers without a decimal point: 22 is read as integer and as double, 22.0 is not.
 */
Json number(double value)
{
    if (std::abs(value) < 1e15 && value == std::floor(value))
        return static_cast<std::int64_t>(value);
    return value;
}

Json jsonItem(const MavItem& item, std::size_t id)
{
    Json json;
    json["type"] = "SimpleItem";
    json["command"] = static_cast<int>(item.command);
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
    if (item.frame != MavFrame::Mission) { // readers need all three members or none
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
    const auto speed_mps =
        static_cast<int>(std::clamp(std::round(mission.airspeed_mps), 1.0, kLargestSpeed_mps));
    Json json;
    json["version"] = 2;
    json["firmwareType"] = kArduPilot;
    json["vehicleType"] = kFixedWing;
    json["globalPlanAltitudeMode"] = kRelativeAltitude;
    json["cruiseSpeed"] = speed_mps;
    json["hoverSpeed"] = speed_mps;
    json["plannedHomePosition"] = {number(mission.home.latitude_deg),
                                   number(mission.home.longitude_deg), 0};
    json["items"] = std::move(items);
    return json;
}

Json jsonPolygon(const ExportContent& content, const std::vector<Point>& corners_m,
                 bool isInclusion)
{
    Json corners = Json::array();
    for (const Point& corner_m : corners_m) {
        const LatLon place = roundedPlace(content.frame.toGeographic(corner_m));
        corners.push_back({number(place.latitude_deg), number(place.longitude_deg)});
    }
    Json polygon;
    polygon["version"] = 1;
    polygon["inclusion"] = isInclusion;
    polygon["polygon"] = std::move(corners);
    return polygon;
}

/** Adds the areas that are closed at the altitude of the UAV, as polygons have no heights. */
Json jsonFence(const ExportContent& content)
{
    Json polygons = Json::array();
    if (content.geofence && !content.area_m.empty())
        polygons.push_back(jsonPolygon(content, content.area_m, true));
    for (const NoFlyArea& area : closedAreas(content))
        if (isClosedAt(area, content.uavs.front().uav.spec.altitude_m))
            polygons.push_back(jsonPolygon(content, area.corners_m, false));
    Json json;
    json["version"] = 2;
    json["polygons"] = std::move(polygons);
    json["circles"] = Json::array();
    return json;
}

/** Rally point at home and the altitude of the mission, to which ArduPilot returns on failsafe. */
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
