#include "widgets/map/view/map_edits.h"

#include "core/checks/validate.h"
#include "widgets/document/iceberg_clipboard.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/words/error_text.h"
#include "widgets/words/issue_text.h"

#include <QApplication>
#include <QClipboard>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Approximate offset of a copy if the cursor is not over the map. */
constexpr double kCopyOffset_px = 40;

/** Middle of the bounding box of at least one iceberg. */
Point middleOf(std::span<const Iceberg> icebergs)
{
    std::vector<Point> positions_m;
    for (const Iceberg& iceberg : icebergs)
        positions_m.push_back(iceberg.position_m);
    return boundsOf(positions_m).centre_m();
}

} // namespace

/** Cancels the tool's gesture; returns false if the map is locked. */
bool MapEdits::begin()
{
    m_context.view.tools().cancel();
    return !m_context.view.isLocked();
}

QString MapEdits::removalText(const std::vector<std::string>& ids) const
{
    const Scenario& scenario = m_context.document.scenario();
    const auto icebergs = static_cast<int>(icebergsOf(scenario, ids).size());
    const bool hasAsset = scenario.asset && m_context.selection.contains(kAssetKey);
    const bool hasArea = !scenario.area_m.empty() && m_context.selection.contains(kAreaKey);
    const auto uavs = static_cast<int>(removableUavs(scenario, ids));
    const auto noFly = static_cast<int>(std::count_if(
        ids.begin(), ids.end(), [](const std::string& id) { return noFlyPlace(id); }));
    const int count = icebergs + uavs + int(hasAsset) + int(hasArea) + noFly;
    if (count == 0)
        return {};
    if (count > icebergs && count > 1)
        return tr("Delete %n objects", nullptr, count);
    if (uavs == 1)
        return tr("Delete UAV");
    if (hasAsset)
        return tr("Remove asset");
    if (hasArea)
        return tr("Remove area");
    if (noFly == 1)
        return tr("Remove no-fly area");
    return tr("Delete %n icebergs", nullptr, icebergs);
}

void MapEdits::deleteSelected()
{
    const std::vector<std::string> ids = m_context.selection.ids();
    if (m_context.view.isLocked())
        emit m_context.view.removalRequested(ids);
    if (!begin() || m_context.view.tools().removePart())
        return;
    if (const QString text = removalText(ids); !text.isEmpty())
        m_context.document.edit(text, [&](Scenario& scenario) { removeObjects(scenario, ids); });
    else if (!uavsOf(m_context.document.scenario(), ids).empty())
        emit m_context.view.refused(
            tr("The last UAV cannot be deleted: a scenario needs at least one."));
}

void MapEdits::selectAll()
{
    std::vector<std::string> ids;
    for (const MapIceberg& iceberg : m_context.scene.picture().icebergs)
        ids.push_back(keyOf(iceberg));
    m_context.selection.set(std::move(ids));
}

void MapEdits::nudge(double east_m, double north_m)
{
    if (!begin() || m_context.selection.isEmpty())
        return;
    const std::vector<std::string> ids = m_context.selection.ids();
    m_context.document.edit(
        moveText(m_context.document.scenario(), ids),
        [&](Scenario& scenario) {
            moveObjects(scenario, ids, {east_m, north_m});
        },
        u"nudge"_s);
}

bool MapEdits::copySelected() const
{
    const std::vector<Iceberg> icebergs =
        icebergsOf(m_context.document.scenario(), m_context.selection.ids());
    if (icebergs.empty())
        return false;
    QApplication::clipboard()->setMimeData(icebergMimeData(icebergs).release());
    return true;
}

void MapEdits::cutSelected()
{
    if (!begin() || !copySelected())
        return;
    const std::vector<std::string> ids = m_context.selection.ids();
    const auto count = static_cast<int>(icebergsOf(m_context.document.scenario(), ids).size());
    m_context.document.edit(tr("Cut %n icebergs", nullptr, count),
                            [&](Scenario& scenario) { removeIcebergs(scenario, ids); });
}

void MapEdits::paste()
{
    pasteAt(m_context.view.cursor_m());
}

void MapEdits::pasteAt(const std::optional<Point>& place_m)
{
    if (!begin())
        return;
    std::vector<Iceberg> icebergs;
    try {
        icebergs = icebergsOf(QApplication::clipboard()->mimeData());
    } catch (const Error& error) {
        const bool isOther =
            error.code() == ErrorCode::SyntaxError || error.code() == ErrorCode::WrongFormat;
        emit m_context.view.refused(
            isOther
                ? tr("There are no icebergs on the clipboard.")
                : tr("The clipboard content cannot be pasted. %1").arg(errorText(error.code())));
        return;
    }
    const auto count = static_cast<int>(icebergs.size());
    addCopiesOf(icebergs, place_m, tr("Paste %n icebergs", nullptr, count));
}

void MapEdits::duplicateSelected()
{
    if (!begin())
        return;
    const std::vector<Iceberg> icebergs =
        icebergsOf(m_context.document.scenario(), m_context.selection.ids());
    const auto count = static_cast<int>(icebergs.size());
    if (icebergs.empty())
        duplicateUavs(uavsOf(m_context.document.scenario(), m_context.selection.ids()));
    addCopiesOf(icebergs, std::nullopt, tr("Duplicate %n icebergs", nullptr, count));
}

/** Offset of a copy from its original. */
Point MapEdits::copyStep_m() const
{
    const double step_m = roundDown125(kCopyOffset_px / m_context.scene.view().scale_pxpm());
    return {step_m, -step_m};
}

void MapEdits::duplicateUavs(const std::vector<Uav>& uavs)
{
    if (uavs.empty() || !hasRoomForUavs(uavs.size()))
        return;
    const Point step_m = copyStep_m();
    std::vector<std::string> ids;
    const auto count = static_cast<int>(uavs.size());
    m_context.document.edit(tr("Duplicate %n UAVs", nullptr, count), [&](Scenario& scenario) {
        for (const Uav& uav : uavs) {
            scenario.uavs.push_back(anotherUav(
                scenario, uav, freeUavPlace_m(scenario, uav.position_m + step_m, step_m)));
            ids.push_back(scenario.uavs.back().id);
        }
    });
    m_context.selection.set(std::move(ids));
}

/** Returns whether `count` more UAVs are allowed; reports it if not. */
bool MapEdits::hasRoomForUavs(std::size_t count)
{
    const std::size_t uavs = m_context.document.scenario().uavs.size() + count;
    if (uavs <= kMostUavs)
        return true;
    emit m_context.view.refused(
        issueSentence(IssueId::UavCount, {countOf(kMostUavs), countOf(uavs)}));
    return false;
}

void MapEdits::addUavAt(const Point& place_m)
{
    if (!begin() || !hasRoomForUavs(1))
        return;
    const Scenario& scenario = m_context.document.scenario();
    const Point free_m = freeUavPlace_m(scenario, place_m, copyStep_m());
    const Uav uav = anotherUav(scenario, roundedTo(free_m, kPositionStep_m));
    m_context.document.edit(tr("Add UAV"),
                            [&](Scenario& scenario) { scenario.uavs.push_back(uav); });
    m_context.selection.set({uav.id});
}

void MapEdits::addUav()
{
    addUavAt(m_context.view.cursor_m().value_or(
        m_context.scene.view().toWorld(m_context.scene.rect().center())));
}

/** Adds copies around `place_m`, or beside the originals where they hide no other iceberg. */
bool MapEdits::hasRoomForIcebergs(std::size_t count)
{
    const std::size_t icebergs = m_context.document.scenario().icebergs.size() + count;
    if (icebergs <= kMostIcebergs)
        return true;
    emit m_context.view.refused(
        issueSentence(IssueId::IcebergCount, {countOf(kMostIcebergs), countOf(icebergs)}));
    return false;
}

void MapEdits::addCopiesOf(const std::vector<Iceberg>& icebergs,
                           const std::optional<Point>& place_m, const QString& undoText)
{
    if (icebergs.empty())
        return;
    const Scenario& scenario = m_context.document.scenario();
    if (!hasRoomForIcebergs(icebergs.size()))
        return;
    const Point step_m = copyStep_m();
    const Point offset_m = place_m ? roundedTo(*place_m - middleOf(icebergs), kPositionStep_m)
                                   : freeOffset(scenario, icebergs, step_m);
    std::vector<std::string> ids;
    m_context.document.edit(undoText,
                            [&](Scenario& after) { ids = addCopies(after, icebergs, offset_m); });
    m_context.selection.set(std::move(ids));
}

void MapEdits::addIcebergAt(const Point& place_m)
{
    const bool isLocked = !begin();
    Iceberg iceberg = m_context.document.newIceberg();
    iceberg.position_m = clampedPosition(roundedTo(place_m, kPositionStep_m));
    if (isLocked) {
        emit m_context.view.icebergPlaced(iceberg);
        return;
    }
    if (!hasRoomForIcebergs(1))
        return;
    iceberg.id = freshIcebergId(m_context.document.scenario());
    m_context.document.edit(tr("Add iceberg"),
                            [&](Scenario& scenario) { scenario.icebergs.push_back(iceberg); });
    m_context.selection.set({iceberg.id});
}

} // namespace berg
