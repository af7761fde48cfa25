#include "core/io/import/maps/geojson_scene.h"

#include "core/base/find_by_id.h"
#include "core/io/import/fields/import_fields.h"

#include <algorithm>

namespace berg {

namespace {

std::string nameAt(const Json* properties, const char* name, std::size_t most)
{
    return cleanText(textOf(memberOf(properties, name)), most);
}

std::optional<LatLon> pointOf(const Json& feature)
{
    return placeOf(memberOf(memberOf(&feature, "geometry"), "coordinates"),
                   AxisOrder::LongitudeFirst);
}

void addUav(FileScene& scene, const Json& feature, const Json* properties)
{
    SceneUav* uav = scene.addUav();
    if (uav == nullptr)
        return;
    uav->id = nameAt(properties, "id", kLongestId);
    uav->name = nameAt(properties, "name", kLongestName);
    uav->start = pointOf(feature);
    uav->home = uav->start;
    uav->heading_deg = numberAt(properties, "heading_deg");
    uav->airspeed_mps = numberAt(properties, "airspeed_mps");
    uav->altitude_m = numberAt(properties, "altitude_m");
}

void addHome(FileScene& scene, const Json& feature, const Json* properties)
{
    SceneUav* uav = findById(scene.uavs, nameAt(properties, "uav", kLongestId));
    const std::optional<LatLon> home = pointOf(feature);
    if (uav != nullptr && home)
        uav->home = home;
}

/** Adds the exterior ring of a polygon. Returns false if the value is not a polygon. */
bool addPolygon(FileScene& scene, SceneArea& area, const Json& rings)
{
    if (!rings.is_array() || rings.empty())
        return false;
    std::optional<std::vector<LatLon>> exterior =
        placesOf(&rings.front(), AxisOrder::LongitudeFirst);
    if (!exterior)
        return false;
    area.rings.push_back(std::move(*exterior));
    for (std::size_t i = 1; i < rings.size(); ++i)
        addFinding(scene.findings, SceneNote::AreaHoles);
    return true;
}

void addArea(FileScene& scene, const Json& feature, const Json* properties)
{
    const Json* geometry = memberOf(&feature, "geometry");
    const Json* coordinates = arrayOf(geometry, "coordinates");
    const std::string type = textOf(memberOf(geometry, "type"));
    const Json* geofence = memberOf(properties, "geofence");
    SceneArea area{.rings = {},
                   .geofence = geofence != nullptr && *geofence == true,
                   .isNoFly = kindOf(properties) == "no-fly",
                   .name = nameAt(properties, "name", kLongestName),
                   .floor_m = numberAt(properties, "floor_m"),
                   .ceiling_m = numberAt(properties, "ceiling_m")};
    bool isRead = coordinates != nullptr && !coordinates->empty();
    if (isRead && type == "Polygon")
        isRead = addPolygon(scene, area, *coordinates);
    else if (isRead && type == "MultiPolygon")
        isRead = std::all_of(coordinates->begin(), coordinates->end(),
                             [&](const Json& rings) { return addPolygon(scene, area, rings); });
    else
        isRead = false;
    if (isRead)
        scene.addArea(std::move(area));
    else
        addFinding(scene.findings, SceneNote::AreaUnreadable);
}

void addAsset(FileScene& scene, const Json& feature, const Json* properties)
{
    const std::optional<LatLon> place = pointOf(feature);
    if (!place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    SceneAsset asset{.name = nameAt(properties, "name", kLongestName),
                     .place = *place,
                     .time = parseUtc(textOf(memberOf(properties, "time"))),
                     .range_m = numberAt(properties, "range_m"),
                     .standoff_m = numberAt(properties, "standoff_m"),
                     .standoffCeiling_m = numberAt(properties, "standoff_ceiling_m")};
    const Json* velocity = arrayOf(properties, "velocity_mps");
    if (velocity != nullptr && velocity->size() == 2 && (*velocity)[0].is_number() &&
        (*velocity)[1].is_number())
        asset.velocity_mps = Point((*velocity)[0].get<double>(), (*velocity)[1].get<double>());
    scene.addAsset(std::move(asset));
}

} // namespace

void addSceneFeature(FileScene& scene, const Json& feature)
{
    const Json* properties = memberOf(&feature, "properties");
    const std::string kind = kindOf(properties);
    if (isOwnGeoJson(properties))
        addUav(scene, feature, properties);
    else if (kind == "home")
        addHome(scene, feature, properties);
    else if (kind == "area" || kind == "no-fly")
        addArea(scene, feature, properties);
    else if (kind == "asset")
        addAsset(scene, feature, properties);
}

} // namespace berg
