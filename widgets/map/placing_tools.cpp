#include "widgets/map/placing_tools.h"

#include "core/base/angles.h"
#include "core/scenario/validate.h"
#include "widgets/map/map_marks.h"
#include "widgets/map/map_view.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/theme/quantity_text.h"

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

// What is placed by hand is rounded far below what a screen shows, so that numbers stay short.
constexpr double kPositionStep_m = 0.1;
constexpr double kDriftStep_mps = 0.001;
constexpr double kMetresPerNauticalMile = 1852;

/** An arrow of the usual length may stand for this much drift at least. */
constexpr double kUsualDrift_mps = 0.4;

Point rounded(const Point& value, double step)
{
    return (value / step).array().round().matrix() * step;
}

Point placeOf(const MapPointer& pointer)
{
    return clampedPosition(rounded(pointer.at_m, kPositionStep_m));
}

bool isEnter(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/** The pointer of somebody who places things by keyboard. */
MapPointer middleOf(const MapScene& scene)
{
    const QPointF at_px = scene.rect().center();
    return {.at_px = at_px, .at_m = scene.view().toWorld(at_px)};
}

/** "0.31 m/s (0.60 kn)  045°". */
QString driftText(const Point& drift_mps, const QLocale& locale)
{
    const double speed_mps = drift_mps.norm();
    const double speed_kn = speed_mps * 3600 / kMetresPerNauticalMile;
    const QString speed = PlacingTools::tr("%1 m/s (%2 kn)")
                              .arg(fixedText(speed_mps, 2, locale), fixedText(speed_kn, 2, locale));
    return speed_mps > 0 ? speed + u"  "_s + bearingText(drift_mps) : speed;
}

} // namespace

void IcebergTool::press(const MapPointer& pointer)
{
    MapScene& scene = context().scene;
    const Scenario& scenario = context().document.scenario();
    if (scene.isOverlay(pointer.at_px))
        return;
    const Iceberg* present = findIceberg(scenario, scene.objectAt(pointer.at_px));
    if (present == nullptr && scenario.icebergs.size() >= kMostIcebergs)
        return;
    m_press = pointer;
    m_now = pointer;
    m_isPressed = true;
    if (present != nullptr) {
        m_iceberg = *present;
        return;
    }
    m_iceberg = {};
    m_iceberg.id = freshIcebergId(scenario);
    m_iceberg.position_m = placeOf(pointer);
    m_gesture = newGesture(PlacingTools::tr("Add iceberg"));
    apply();
}

void IcebergTool::beginDrift()
{
    m_isDrawing = true;
    MapScene& scene = context().scene;
    const double usual_s = driftTimeFor_s(kUsualDrift_mps, scene.view().scale_pxpm());
    const double shown_s = scene.layout().symbols.driftTime_s;
    m_driftTime_s = shown_s > 0 ? std::min(shown_s, usual_s) : usual_s;
    m_driftTime_s = std::max(m_driftTime_s, 60.0);
    scene.setDriftTime(m_driftTime_s);
    if (!m_gesture)
        m_gesture = newGesture(PlacingTools::tr("Change drift"));
}

void IcebergTool::move(const MapPointer& pointer)
{
    if (!m_isPressed)
        return;
    m_now = pointer;
    if (!m_isDrawing && isDragDistance(m_press.at_px, pointer.at_px))
        beginDrift();
    if (m_isDrawing)
        apply();
}

Point IcebergTool::drawnDrift_mps() const
{
    MapScene& scene = context().scene;
    const QPointF centre = scene.view().toPixel(m_iceberg.position_m);
    const std::optional<LabelDisk> symbol = scene.symbolOf(m_iceberg.id);
    // The arrows of the map begin at the edge of the symbol; inside it there is no drift.
    const double edge_px = symbol ? symbol->radius_px : 0;
    const Point way_px(m_now.at_px.x() - centre.x(), centre.y() - m_now.at_px.y());
    const double length_px = way_px.norm();
    if (length_px <= edge_px)
        return Point::Zero();
    const double metres = (length_px - edge_px) / scene.view().scale_pxpm();
    const Point overGround_mps = way_px / length_px * (metres / m_driftTime_s);
    const Point own_mps = overGround_mps - context().document.scenario().current_mps;
    return rounded(own_mps, kDriftStep_mps)
        .cwiseMax(-kLargestVelocity_mps)
        .cwiseMin(kLargestVelocity_mps);
}

void IcebergTool::apply()
{
    if (m_isDrawing)
        m_iceberg.velocity_mps = drawnDrift_mps();
    m_gesture->apply([this](Scenario& scenario) {
        if (Iceberg* present = findIceberg(scenario, m_iceberg.id))
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
    if (m_gesture)
        m_gesture->finish();
    context().selection.set({m_iceberg.id});
    end();
}

bool IcebergTool::key(const QKeyEvent& event)
{
    if (!isEnter(event))
        return false;
    const MapPointer middle = middleOf(context().scene);
    press(middle);
    release(middle);
    return true;
}

void IcebergTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    end();
}

void IcebergTool::documentChanged()
{
    if (m_isPressed && (!m_gesture || !m_gesture->isApplying()))
        end();
}

void IcebergTool::end()
{
    if (m_isDrawing)
        context().scene.setDriftTime({});
    m_isPressed = false;
    m_isDrawing = false;
    m_gesture.reset();
}

void IcebergTool::paint(QPainter& painter) const
{
    if (!m_isDrawing)
        return;
    MapScene& scene = context().scene;
    const Point overGround_mps = m_iceberg.velocity_mps + context().document.scenario().current_mps;
    paintBubble(painter, m_now.at_px, driftText(overGround_mps, scene.locale()), scene.rect(),
                scene.theme());
}

QCursor IcebergTool::cursor(const std::string&) const
{
    return Qt::CrossCursor;
}

QString IcebergTool::status() const
{
    if (m_isDrawing)
        return PlacingTools::tr("The arrow is the way drifted in %1. Esc takes it back.")
            .arg(durationText(m_driftTime_s, context().scene.locale()));
    if (context().document.scenario().icebergs.size() >= kMostIcebergs)
        return PlacingTools::tr("A scenario holds at most %n icebergs.", nullptr,
                                static_cast<int>(kMostIcebergs));
    return PlacingTools::tr(
        "Click adds an iceberg, drag on to set its drift. Esc leaves the tool.");
}

void UavTool::press(const MapPointer& pointer)
{
    MapScene& scene = context().scene;
    if (scene.isOverlay(pointer.at_px))
        return;
    m_press = pointer;
    m_now = pointer;
    const Scenario& scenario = context().document.scenario();
    if (scenario.uavs.empty()) {
        m_uav = {};
        m_uav.id = freshUavId(scenario);
        m_uav.position_m = placeOf(pointer);
    } else {
        m_uav = scenario.uavs.front();
        if (scene.objectAt(pointer.at_px) != m_uav.id)
            m_uav.position_m = placeOf(pointer);
    }
    m_gesture = newGesture(PlacingTools::tr("Place UAV"));
    apply();
}

void UavTool::apply()
{
    m_gesture->apply([this](Scenario& scenario) {
        if (scenario.uavs.empty())
            scenario.uavs.push_back(m_uav);
        else
            scenario.uavs.front() = m_uav;
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
    const Point way_m = pointer.at_m - m_uav.position_m;
    if (way_m.norm() <= 0)
        return;
    const double heading_deg = headingFromPsi(std::atan2(way_m.y(), way_m.x()));
    m_uav.heading_deg = std::fmod(std::round(heading_deg), 360.0);
    apply();
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

bool UavTool::key(const QKeyEvent& event)
{
    if (!isEnter(event))
        return false;
    const MapPointer middle = middleOf(context().scene);
    press(middle);
    release(middle);
    return true;
}

void UavTool::documentChanged()
{
    if (m_gesture && !m_gesture->isApplying()) {
        m_isTurning = false;
        m_gesture.reset();
    }
}

void UavTool::end(bool takeBack)
{
    if (m_gesture && takeBack)
        m_gesture->cancel();
    else if (m_gesture)
        m_gesture->finish();
    m_isTurning = false;
    m_gesture.reset();
}

void UavTool::paint(QPainter& painter) const
{
    if (!m_isTurning)
        return;
    MapScene& scene = context().scene;
    const QPointF from = scene.view().toPixel(m_uav.position_m);
    paintDragTrail(painter, {from, m_now.at_px}, scene.theme());
    const QString heading =
        u"%1°"_s.arg(static_cast<int>(std::lround(m_uav.heading_deg)), 3, 10, QChar(u'0'));
    paintBubble(painter, m_now.at_px, PlacingTools::tr("Heading %1").arg(heading), scene.rect(),
                scene.theme());
}

QCursor UavTool::cursor(const std::string&) const
{
    return Qt::CrossCursor;
}

QString UavTool::status() const
{
    if (m_isTurning)
        return PlacingTools::tr("Let go to keep this heading. Esc takes it back.");
    return PlacingTools::tr("Click places the UAV, drag on to turn it. Esc leaves the tool.");
}

} // namespace berg
