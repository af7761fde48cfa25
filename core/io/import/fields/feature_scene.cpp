#include "core/io/import/fields/feature_scene.h"

#include "core/base/find_by_id.h"
#include "core/io/import/fields/import_fields.h"
#include "core/permit/operation.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

void addUav(FileScene& scene, const SceneFeature& feature)
{
    const FeatureData& data = feature.data;
    const std::optional<LatLon>& place = feature.geometry.place;
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

void addArea(FileScene& scene, const SceneFeature& feature)
{
    for (std::size_t i = 0; i < feature.geometry.holes; ++i)
        addFinding(scene.findings, SceneNote::AreaHoles);
    if (feature.geometry.rings.empty()) {
        addFinding(scene.findings, SceneNote::AreaUnreadable);
        return;
    }
    scene.addArea({.rings = feature.geometry.rings,
                   .geofence = trimmed(valueOf(feature.data, "geofence")) == "true",
                   .isNoFly = feature.kind == "no-fly",
                   .name = cleanText(valueOf(feature.data, "name"), kLongestName),
                   .floor_m = numberOf(feature.data, "floor_m"),
                   .ceiling_m = numberOf(feature.data, "ceiling_m")});
}

void addAsset(FileScene& scene, const SceneFeature& feature)
{
    const FeatureData& data = feature.data;
    if (!feature.geometry.place) {
        addFinding(scene.findings, SceneNote::NumberWrong, "asset");
        return;
    }
    // An asset that a user has drawn has a title only; one of Bergwatch may have a title and no
    // name.
    const std::string& name = data.contains("name") ? valueOf(data, "name") : feature.title;
    SceneAsset asset{.name = cleanText(name, kLongestName),
                     .place = *feature.geometry.place,
                     .time = feature.time,
                     .range_m = numberOf(data, "range_m"),
                     .standoff_m = numberOf(data, "standoff_m"),
                     .standoffCeiling_m = numberOf(data, "standoff_ceiling_m")};
    const std::optional<double> east_mps = numberOf(data, "velocity_east_mps");
    const std::optional<double> north_mps = numberOf(data, "velocity_north_mps");
    if (east_mps && north_mps)
        asset.velocity_mps = Point(*east_mps, *north_mps);
    scene.addAsset(std::move(asset));
}

bool isVolumePart(std::string_view kind)
{
    return std::ranges::find(kVolumePartIds, kind) != kVolumePartIds.end();
}

/** Returns true for the kinds that `mapFeatures` writes. */
bool isExportedKind(std::string_view kind)
{
    constexpr std::array<std::string_view, 12> kKinds{"iceberg",   "uav",      "home",  "visit",
                                                      "plan",      "path",     "track", "no-fly",
                                                      "stand-off", "airspace", "area",  "asset"};
    return std::ranges::find(kKinds, kind) != kKinds.end() || isVolumePart(kind);
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

std::string featureKind(const FeatureData& data, std::string_view mark)
{
    if (const std::string& kind = valueOf(data, "kind"); !kind.empty())
        return isExportedKind(kind) ? kind : std::string();
    if (mark.starts_with('#'))
        mark.remove_prefix(1);
    if (mark.starts_with("uav-")) // style of a home, of visits and of paths
        return data.contains("airspeed_mps") ? "home" : "path";
    const std::string_view word = mark.substr(0, mark.find('/'));
    constexpr std::array<std::string_view, 5> kKinds{"area", "no-fly", "stand-off", "asset",
                                                     "home"};
    if (std::ranges::find(kKinds, word) != kKinds.end())
        return std::string(word);
    const bool isOther = word == "uav" || word == "airspace" || isVolumePart(word);
    return isOther ? "path" : "";
}

void addSceneFeature(FileScene& scene, const SceneFeature& feature)
{
    if (feature.kind == "uav" || feature.kind == "home")
        addUav(scene, feature);
    else if (feature.kind == "area" || feature.kind == "no-fly")
        addArea(scene, feature);
    else if (feature.kind == "asset")
        addAsset(scene, feature);
}

} // namespace berg
