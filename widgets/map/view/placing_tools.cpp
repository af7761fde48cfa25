#include "widgets/map/view/placing_tools.h"

#include "core/base/angles.h"
#include "core/scenario/limits.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/asset_size.h"
#include "widgets/map/view/map_view.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/source_text.h"

#include <QCoreApplication>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct PlacingTools
{
    Q_DECLARE_TR_FUNCTIONS(PlacingTools)
};

} // namespace

bool PlacingTool::key(const QKeyEvent& event)
{
    if (!isEnter(event))
        return false;
    MapPointer middle = middleOf(context().scene);
    middle.modifiers = event.modifiers();
    press(middle);
    release(middle);
    return true;
}

QCursor PlacingTool::cursor(const std::string&) const
{
    return Qt::CrossCursor;
}

void PlacingTool::end(bool takeBack)
{
    if (m_gesture && takeBack)
        m_gesture->cancel();
    else if (m_gesture)
        m_gesture->finish();
    drop();
}

void IcebergTool::press(const MapPointer& pointer)
{
    MapScene& scene = context().scene;
    const Scenario& scenario = context().document.scenario();
    if (scene.isOverlay(pointer.at_px))
        return;
    const std::string object = scene.objectAt(pointer.at_px);
    if (context().view.isLocked()) {
        pressInFlight(pointer, object);
        return;
    }
    const Iceberg* present = findById(scenario.icebergs, object);
    if (present == nullptr && scenario.icebergs.size() >= kMostIcebergs)
        return;
    m_press = pointer;
    m_now = pointer;
    m_isPressed = true;
    if (present != nullptr) {
        m_iceberg = *present;
        return;
    }
    m_iceberg = context().document.newIceberg();
    m_iceberg.id = freshIcebergId(scenario);
    m_iceberg.position_m = placeOf(pointer);
    m_gesture = makeGesture(context(), PlacingTools::tr("Add iceberg"));
    apply();
}

/** Selects an iceberg at the pointer; elsewhere draws a new one, which release adds to the flight.
 */
void IcebergTool::pressInFlight(const MapPointer& pointer, const std::string& object)
{
    const std::vector<MapIceberg>& icebergs = context().scene.picture().icebergs;
    if (std::ranges::find(icebergs, object, keyOf) != icebergs.end()) {
        context().selection.set({object});
        return;
    }
    m_press = pointer;
    m_now = pointer;
    m_isPressed = true;
    m_iceberg = context().document.newIceberg();
    m_iceberg.position_m = placeOf(pointer);
    apply();
}

void IcebergTool::beginDrift()
{
    m_arrow = std::make_unique<DriftArrow>(context().scene);
    if (!m_gesture && !context().view.isLocked())
        m_gesture = makeGesture(context(), PlacingTools::tr("Change drift"));
}

void IcebergTool::move(const MapPointer& pointer)
{
    if (!m_isPressed)
        return;
    m_now = pointer;
    if (!m_arrow && isDragDistance(m_press.at_px, pointer.at_px))
        beginDrift();
    if (m_arrow)
        apply();
}

void IcebergTool::apply()
{
    if (m_arrow)
        m_iceberg.velocity_mps =
            m_arrow->velocity_mps(m_iceberg, m_now, context().document.scenario().current_mps);
    if (!m_gesture) {
        context().view.setDraft([drawn = mapIceberg(m_iceberg, context().document.scenario())](
                                    MapPicture& picture) { picture.icebergs.push_back(drawn); });
        return;
    }
    m_gesture->apply([this](Scenario& scenario) {
        if (Iceberg* present = findById(scenario.icebergs, m_iceberg.id))
            present->velocity_mps = m_iceberg.velocity_mps;
        else
            scenario.icebergs.push_back(m_iceberg);
    });
}

void IcebergTool::release(const MapPointer& pointer)
{
    if (!m_isPressed)
        return;
    move(pointer);
    if (!pointer.isInside) {
        cancel();
        return;
    }
    if (context().view.isLocked()) {
        const Iceberg placed = m_iceberg;
        drop();
        emit context().view.icebergPlaced(placed);
        return;
    }
    if (m_gesture)
        m_gesture->finish();
    context().selection.set({m_iceberg.id});
    drop();
}

void IcebergTool::drop()
{
    m_isPressed = false;
    m_arrow.reset();
    PlacingTool::drop();
    context().view.setDraft(nullptr);
}

void IcebergTool::paint(QPainter& painter) const
{
    if (!m_arrow)
        return;
    MapScene& scene = context().scene;
    const Point overGround_mps = m_iceberg.velocity_mps + context().document.scenario().current_mps;
    paintBubble(painter, m_now.at_px, driftText(overGround_mps, scene.locale()), scene.rect(),
                scene.theme());
}

QString IcebergTool::status() const
{
    if (m_arrow)
        return m_arrow->status();
    const QString source = u' ' + PlacingTools::tr("Seen by %1.", "source and its error")
                                      .arg(sourceText(context().document.newIcebergSource(),
                                                      context().scene.locale()));
    if (context().view.isLocked())
        return PlacingTools::tr("Click to add an iceberg that appears here now; drag to set its "
                                "drift. In flight this cannot be undone.") +
               source;
    if (context().document.scenario().icebergs.size() >= kMostIcebergs)
        return PlacingTools::tr("The scenario has %1 icebergs, the most that are possible.")
            .arg(context().scene.locale().toString(kMostIcebergs));
    return PlacingTools::tr(
               "Click to add an iceberg; drag to set its drift. Esc leaves the tool.") +
           source;
}

void UavTool::press(const MapPointer& pointer)
{
    MapScene& scene = context().scene;
    if (scene.isOverlay(pointer.at_px))
        return;
    m_press = pointer;
    m_now = pointer;
    const Scenario& scenario = context().document.scenario();
    const Uav* grabbed = findById(scenario.uavs, scene.objectAt(pointer.at_px));
    const Uav* meant = targetUav();
    const bool adds =
        meant == nullptr || (grabbed == nullptr && pointer.modifiers.testFlag(Qt::ControlModifier));
    if (adds && scenario.uavs.size() >= kMostUavs)
        return;
    if (adds)
        m_uav = anotherUav(scenario, placeOf(pointer));
    else
        m_uav = grabbed != nullptr ? *grabbed : *meant;
    if (grabbed == nullptr)
        m_uav.position_m = placeOf(pointer);
    m_gesture =
        makeGesture(context(), adds ? PlacingTools::tr("Add UAV") : PlacingTools::tr("Place UAV"));
    apply();
}

/** UAV that a click moves: the first selected, otherwise the first of all; null without UAVs. */
const Uav* UavTool::targetUav() const
{
    const Scenario& scenario = context().document.scenario();
    for (const std::string& id : context().selection.ids())
        if (const Uav* uav = findById(scenario.uavs, id))
            return uav;
    return scenario.uavs.empty() ? nullptr : &scenario.uavs.front();
}

void UavTool::apply()
{
    m_gesture->apply([this](Scenario& scenario) {
        if (Uav* present = findById(scenario.uavs, m_uav.id))
            *present = m_uav;
        else
            scenario.uavs.push_back(m_uav);
    });
}

void UavTool::move(const MapPointer& pointer)
{
    if (!m_gesture)
        return;
    m_now = pointer;
    m_isTurning = m_isTurning || isDragDistance(m_press.at_px, pointer.at_px);
    if (!m_isTurning)
        return;
    if (const std::optional<double> heading_deg = headingTowards_deg(m_uav.position_m, pointer)) {
        m_uav.heading_deg = *heading_deg;
        apply();
    }
}

void UavTool::release(const MapPointer& pointer)
{
    if (!m_gesture)
        return;
    move(pointer);
    end(!pointer.isInside);
    if (pointer.isInside)
        context().selection.set({m_uav.id});
}

void UavTool::drop()
{
    m_isTurning = false;
    PlacingTool::drop();
}

void UavTool::paint(QPainter& painter) const
{
    if (!m_isTurning)
        return;
    MapScene& scene = context().scene;
    const QPointF from = scene.view().toPixel(m_uav.position_m);
    paintDragTrail(painter, {from, m_now.at_px}, scene.theme());
    paintBubble(painter, m_now.at_px, headingText(m_uav.heading_deg), scene.rect(), scene.theme());
}

QString UavTool::status() const
{
    if (m_isTurning)
        return PlacingTools::tr("Release to keep this heading. Esc cancels.");
    const Uav* uav = targetUav();
    if (uav == nullptr)
        return PlacingTools::tr("Click to place the UAV; drag to set its heading. Ctrl+click adds "
                                "another one. Esc leaves the tool.");
    return PlacingTools::tr("Click to place %1; drag to set its heading. Ctrl+click adds another "
                            "UAV. Esc leaves the tool.")
        .arg(QString::fromStdString(uav->name.empty() ? uav->id : uav->name));
}

void AssetTool::press(const MapPointer& pointer)
{
    MapScene& scene = context().scene;
    if (scene.isOverlay(pointer.at_px))
        return;
    m_now = pointer;
    const std::optional<Asset>& asset = context().document.scenario().asset;
    m_asset = asset.value_or(assetFor(scene.view(), scene.rect().size()));
    const bool isGrabbed = asset && scene.objectAt(pointer.at_px) == kAssetKey;
    m_grip_m = isGrabbed ? Point(pointer.at_m - m_asset.position_m) : Point(Point::Zero());
    m_press = pointer;
    m_isMoving = !isGrabbed;
    m_gesture = makeGesture(context(), asset ? PlacingTools::tr("Move asset")
                                             : PlacingTools::tr("Place asset"));
    move(pointer);
}

void AssetTool::move(const MapPointer& pointer)
{
    if (!m_gesture)
        return;
    m_now = pointer;
    m_isMoving = m_isMoving || isDragDistance(m_press.at_px, pointer.at_px);
    if (!m_isMoving)
        return;
    MapPointer centre = pointer;
    centre.at_m -= m_grip_m;
    m_asset.position_m = placeOf(centre);
    m_gesture->apply([this](Scenario& scenario) { scenario.asset = m_asset; });
}

void AssetTool::release(const MapPointer& pointer)
{
    if (!m_gesture)
        return;
    move(pointer);
    end(!pointer.isInside);
    if (pointer.isInside)
        context().selection.set({kAssetKey});
}

void AssetTool::paint(QPainter& painter) const
{
    if (!m_gesture || !m_isMoving || !m_gesture->start().asset)
        return;
    MapScene& scene = context().scene;
    const Point from_m = m_gesture->start().asset->position_m;
    const Point path_m = m_asset.position_m - from_m;
    paintDragTrail(painter,
                   {scene.view().toPixel(from_m), scene.view().toPixel(m_asset.position_m)},
                   scene.theme());
    paintBubble(painter, m_now.at_px, pathText(path_m, scene.locale()), scene.rect(),
                scene.theme());
}

QCursor AssetTool::cursor(const std::string& over) const
{
    return over == kAssetKey ? Qt::SizeAllCursor : Qt::CrossCursor;
}

QString AssetTool::status() const
{
    if (m_gesture)
        return PlacingTools::tr("Release to place it here. Esc cancels.");
    if (context().document.scenario().asset)
        return PlacingTools::tr("Click to move the asset here. Esc leaves the tool.");
    return PlacingTools::tr("Click to place the protected asset. Esc leaves the tool.");
}

} // namespace berg
