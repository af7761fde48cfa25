#include "core/io/import/fields/feature_scene.h"

#include "core/base/find_by_id.h"
#include "core/io/import/fields/import_fields.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

/** Geometries of a feature; areas are all read or none. */
struct SceneGeometry
{
    explicit SceneGeometry(const FileFeature& feature)
    {
        bool isWhole = true;
        for (const FileShape& shape : feature.geometry().shapes) {
            const bool isArea = shape.kind == ShapeKind::Area;
            if (!isArea && (shape.kind != ShapeKind::Places || place || shape.parts == 0))
                continue;
            std::optional<std::vector<LatLon>> places = placesOf(shape, 0);
            if (isArea)
                holes += shape.parts > 1 ? shape.parts - 1 : 0;
            isWhole = isWhole && (!isArea || places);
            if (isArea && places)
                rings.push_back(std::move(*places));
            else if (places && !places->empty())
                place = places->front();
        }
        if (!isWhole)
            rings.clear();
    }

    std::optional<LatLon> place;
    std::vector<std::vector<LatLon>> rings; ///< exterior; empty if they cannot be read
    std::size_t holes = 0;
};

void addUav(FileScene& scene, const FeatureData& data, const std::optional<LatLon>& place)
{
    const std::string id = cleanText(valueOf(data, "uav"), kLongestId);
    if (SceneUav* known = data.contains("uav") ? findById(scene.uavs, id) : nullptr) {
        if (place)
            known->home = place;
        return;
    }
    SceneUav* uav = data.contains("airspeed_mps") ? scene.addUav() : nullptr;
    if (uav == nullptr)
        return;
    const std::optional<double> latitude_deg = numberOf(data, "start_latitude_deg");
    const std::optional<double> longitude_deg = numberOf(data, "start_longitude_deg");
    if (latitude_deg && longitude_deg)
        uav->start = scenePlace(*latitude_deg, *longitude_deg);
    if (!uav->start)
        uav->start = place;
    uav->id = cleanText(valueOf(data, "id"), kLongestId);
    uav->name = cleanText(valueOf(data, "name"), kLongestName);
    uav->home = place;
    uav->heading_deg = numberOf(data, "heading_deg");
    uav->airspeed_mps = numberOf(data, "airspeed_mps");
    uav->altitude_m = numberOf(data, "altitude_m");
}

void addArea(FileScene& scene, const FeatureData& data, SceneGeometry geometry, bool isNoFly)
{
    for (std::size_t i = 0; i < geometry.holes; ++i)
        addFinding(scene.findings, SceneNote::AreaHoles);
    if (geometry.rings.empty()) {
        addFinding(scene.findings, SceneNote::AreaUnreadable);
        return;
    }
    scene.addArea({.rings = std::move(geometry.rings),
                   .geofence = trimmed(valueOf(data, "geofence")) == "true",
                   .isNoFly = isNoFly,
                   .name = cleanText(valueOf(data, "name"), kLongestName),
                   .floor_m = numberOf(data, "floor_m"),
                   .ceiling_m = numberOf(data, "ceiling_m")});
}

void addAsset(FileScene& scene, const SceneFeature& added, const std::optional<LatLon>& place)
{
    const FeatureData& data = added.data;
    if (!place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    // An asset that a user has drawn has a title only; one of Bergwatch may have a title and no
    // name.
    const std::string& name = data.contains("name") ? valueOf(data, "name") : added.feature.name;
    SceneAsset asset{.name = cleanText(name, kLongestName),
                     .place = *place,
                     .time = added.time,
                     .range_m = numberOf(data, "range_m"),
                     .standoff_m = numberOf(data, "standoff_m"),
                     .standoffCeiling_m = numberOf(data, "standoff_ceiling_m")};
    const std::optional<double> east_mps = numberOf(data, "velocity_east_mps");
    const std::optional<double> north_mps = numberOf(data, "velocity_north_mps");
    if (east_mps && north_mps)
        asset.velocity_mps = Point(*east_mps, *north_mps);
    scene.addAsset(std::move(asset));
}

} // namespace

const std::string& valueOf(const FeatureData& data, std::string_view name)
{
    static const std::string kNone;
    const auto it = data.find(name);
    return it == data.end() ? kNone : it->second;
}

std::optional<double> numberOf(const FeatureData& data, std::string_view name)
{
    return decimalOf(trimmed(valueOf(data, name)));
}

bool isVectorPart(std::string_view name)
{
    return name.ends_with("_east_mps") || name.ends_with("_north_mps");
}

bool isOwnExport(std::string_view text)
{
    // Every export describes its UAVs; a Shapefile cuts names to ten letters.
    constexpr std::array<std::string_view, 3> kNames{"heading_de", "airspeed_m", "altitude_m"};
    return std::ranges::all_of(kNames, [text](std::string_view name) {
        return text.find(name) != std::string_view::npos;
    });
}

void addSceneFeature(FileScene& scene, const SceneFeature& added)
{
    const std::string& kind = added.feature.kind;
    if (kind == "uav" || kind == "home")
        addUav(scene, added.data, SceneGeometry(added.feature).place);
    else if (kind == "area" || kind == "no-fly")
        addArea(scene, added.data, SceneGeometry(added.feature), kind == "no-fly");
    else if (kind == "asset")
        addAsset(scene, added, SceneGeometry(added.feature).place);
}

} // namespace berg
