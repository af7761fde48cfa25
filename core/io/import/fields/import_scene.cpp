#include "core/io/import/fields/import_scene.h"

#include "core/base/translate_noop.h"
#include "core/checks/validate.h"
#include "core/io/import/fields/import_fields.h"
#include "core/plan/solve/names.h"
#include "core/scenario/text_checks.h"
#include "core/vehicle/geofence.h"

#include <algorithm>

namespace berg {

namespace {

/** Largest number of vertices of an outline; more take long to thin out. */
constexpr std::size_t kMostVertices = 20'000;

/** `%n` is the count, and "(s)" makes the plural of what is counted. */
constexpr Named<SceneNote> kSceneTexts[]{
    {SceneNote::UavsTaken, QT_TRANSLATE_N_NOOP("IssueText", "%n UAV(s) taken over")},
    {SceneNote::AreaTaken, QT_TRANSLATE_NOOP("IssueText", "area taken over")},
    {SceneNote::FenceTaken, QT_TRANSLATE_NOOP("IssueText", "area taken over as geofence")},
    {SceneNote::AssetTaken, QT_TRANSLATE_NOOP("IssueText", "asset taken over")},
    {SceneNote::NoFlyTaken, QT_TRANSLATE_N_NOOP("IssueText", "%n no-fly area(s) taken over")},
    {SceneNote::InUse,
     QT_TRANSLATE_NOOP("IssueText",
                       "UAVs, area and asset of the file not taken over: the scenario is in use")},
    {SceneNote::UavsTooMany, QT_TRANSLATE_N_NOOP("IssueText", "%n UAV(s) left out: too many")},
    {SceneNote::UavsTooFar,
     QT_TRANSLATE_N_NOOP(
         "IssueText",
         "%n UAV(s) left out: more than 1000 km east, west, north or south of the origin")},
    {SceneNote::AreaUnreadable,
     QT_TRANSLATE_N_NOOP("IssueText", "%n area(s) left out: unreadable")},
    {SceneNote::AreaCorners,
     QT_TRANSLATE_NOOP("IssueText", "area left out: too few or too many corners")},
    {SceneNote::AreaTooFar,
     QT_TRANSLATE_NOOP(
         "IssueText", "area left out: more than 1000 km east, west, north or south of the origin")},
    {SceneNote::AreaCrossing,
     QT_TRANSLATE_NOOP("IssueText", "area left out: it touches or crosses itself")},
    {SceneNote::AreaInParts,
     QT_TRANSLATE_NOOP("IssueText", "area left out: it is in several parts")},
    {SceneNote::AreasMore, QT_TRANSLATE_N_NOOP("IssueText", "%n further area(s) left out")},
    {SceneNote::AreaHoles, QT_TRANSLATE_N_NOOP("IssueText", "%n hole(s) of the area left out")},
    {SceneNote::FenceCorners,
     QT_TRANSLATE_NOOP("IssueText", "area is no geofence: too many corners")},
    {SceneNote::FenceOutside,
     QT_TRANSLATE_NOOP("IssueText", "area is no geofence: a UAV starts or lands outside")},
    {SceneNote::NoFlyUnfit,
     QT_TRANSLATE_N_NOOP(
         "IssueText",
         "%n no-fly area(s) left out: a UAV starts or lands inside, or the heights are wrong")},
    {SceneNote::RallyPoints, QT_TRANSLATE_N_NOOP("IssueText", "%n rally point(s) left out")},
    {SceneNote::AssetsMore, QT_TRANSLATE_N_NOOP("IssueText", "%n further asset(s) left out")},
    {SceneNote::AssetTooFar,
     QT_TRANSLATE_NOOP(
         "IssueText",
         "asset left out: more than 1000 km east, west, north or south of the origin")},
    {SceneNote::NumberWrong,
     QT_TRANSLATE_N_NOOP("IssueText", "%n number(s) out of range left out")},
};
static_assert(std::size(kSceneTexts) == std::size_t(SceneNote::NumberWrong) + 1);

} // namespace

std::string sceneNotePattern(SceneNote note)
{
    return nameOf(kSceneTexts, note);
}

std::string sceneFindingText(const SceneFinding& finding)
{
    std::string text = sceneNotePattern(finding.note);
    if (text.starts_with("%n"))
        text.replace(0, 2, std::to_string(finding.count));
    constexpr std::string_view kPlural = "(s)";
    if (const std::size_t at = text.find(kPlural); at != text.npos)
        text.replace(at, kPlural.size(), finding.count == 1 ? "" : "s");
    return finding.detail.empty() ? text : text + ": " + finding.detail;
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

std::optional<LatLon> scenePlaceOf(std::string_view latitude, std::string_view longitude)
{
    const std::optional<double> latitude_deg = decimalOf(latitude);
    const std::optional<double> longitude_deg = decimalOf(longitude);
    return latitude_deg && longitude_deg ? scenePlace(*latitude_deg, *longitude_deg) : std::nullopt;
}

} // namespace berg
