#include "core/io/import/import_scene.h"

#include "core/scenario/checks.h"
#include "core/scenario/validate.h"
#include "core/vehicle/geofence.h"

#include <algorithm>

namespace berg {

namespace {

/** Of an outline with all its vertices: more take long to thin out. */
constexpr std::size_t kMostVertices = 20'000;

std::string counted(std::size_t count, const std::string& one)
{
    return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

} // namespace

std::string sceneFindingText(const SceneFinding& finding)
{
    switch (finding.note) {
    case SceneNote::UavsTaken:
        return counted(finding.count, "UAV") + " taken over";
    case SceneNote::AreaTaken:
        return "area taken over";
    case SceneNote::FenceTaken:
        return "area taken over as geofence";
    case SceneNote::AssetTaken:
        return "asset taken over";
    case SceneNote::NoFlyTaken:
        return counted(finding.count, "no-fly area") + " taken over";
    case SceneNote::InUse:
        return "UAVs, area and asset of the file not taken over: the scenario is in use";
    case SceneNote::UavsTooMany:
        return counted(finding.count, "UAV") + " left out: more than " + std::to_string(kMostUavs);
    case SceneNote::UavsTooFar:
        return counted(finding.count, "UAV") +
               " left out: more than 1000 km east, west, north or south of the origin";
    case SceneNote::AreaUnreadable:
        return counted(finding.count, "area") + " left out: unreadable";
    case SceneNote::AreaCorners:
        return "area left out: it has not from 3 to " + std::to_string(kMostAreaCorners) +
               " corners";
    case SceneNote::AreaTooFar:
        return "area left out: more than 1000 km east, west, north or south of the origin";
    case SceneNote::AreaCrossing:
        return "area left out: it touches or crosses itself";
    case SceneNote::AreaInParts:
        return "area left out: it is in several parts";
    case SceneNote::AreasMore:
        return counted(finding.count, "further area") + " left out";
    case SceneNote::AreaHoles:
        return counted(finding.count, "hole") + " of the area left out";
    case SceneNote::FenceCircles:
        return counted(finding.count, "circle") + " of the geofence left out";
    case SceneNote::FenceCorners:
        return "area is no geofence: it has more than " + std::to_string(kMostFenceCorners) +
               " corners";
    case SceneNote::FenceOutside:
        return "area is no geofence: a UAV starts or lands outside";
    case SceneNote::NoFlyUnfit:
        return counted(finding.count, "no-fly area") +
               " left out: a UAV starts or lands inside, or the heights are wrong";
    case SceneNote::RallyPoints:
        return counted(finding.count, "rally point") + " left out";
    case SceneNote::AssetsMore:
        return counted(finding.count, "further asset") + " left out";
    case SceneNote::AssetTooFar:
        return "asset left out: more than 1000 km east, west, north or south of the origin";
    case SceneNote::NumberWrong:
        return counted(finding.count, "number") + " out of range left out: " + finding.detail;
    }
    return {};
}

void addFinding(std::vector<SceneFinding>& findings, SceneNote note, std::string detail)
{
    const auto it = std::find_if(findings.begin(), findings.end(),
                                 [&](const SceneFinding& known) { return known.note == note; });
    if (it == findings.end())
        findings.push_back({.note = note, .count = 1, .detail = std::move(detail)});
    else
        ++it->count;
}

SceneUav* FileScene::addUav()
{
    if (uavs.size() < kMostUavs)
        return &uavs.emplace_back();
    addFinding(findings, SceneNote::UavsTooMany);
    return nullptr;
}

void FileScene::addArea(SceneArea added)
{
    std::size_t vertices = 0;
    for (const std::vector<LatLon>& ring : added.rings)
        vertices += ring.size();
    if (added.isNoFly ? noFly.size() >= kMostNoFlyAreas : area.has_value())
        addFinding(findings, SceneNote::AreasMore);
    else if (vertices > kMostVertices)
        addFinding(findings, SceneNote::AreaCorners);
    else if (added.isNoFly)
        noFly.push_back(std::move(added));
    else
        area = std::move(added);
}

void FileScene::addAsset(SceneAsset added)
{
    if (asset)
        addFinding(findings, SceneNote::AssetsMore);
    else
        asset = std::move(added);
}

std::optional<LatLon> scenePlace(double latitude_deg, double longitude_deg)
{
    if (outOfLimits(latitude_deg, limits::kLatitude_deg) ||
        outOfLimits(longitude_deg, {.low = -180, .high = 360}))
        return std::nullopt;
    return LatLon{.latitude_deg = latitude_deg,
                  .longitude_deg = longitude_deg > 180 ? longitude_deg - 360 : longitude_deg};
}

} // namespace berg
