#include "widgets/map/view/drift_arrow.h"

#include "core/base/angles.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_drift.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/map/view/map_scene.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct DriftArrowText
{
    Q_DECLARE_TR_FUNCTIONS(DriftArrow)
};

constexpr double kDriftStep_mps = 0.001;

/** An arrow of usual length can show at least this drift. */
constexpr double kUsualDrift_mps = 0.4;
constexpr double kShortestTime_s = 60;

/** Horizon of the map's arrows, unless it is so long or short that an arrow is hard to draw. */
double drawnTime_s(MapScene& scene)
{
    const double usual_s = driftTimeFor_s(kUsualDrift_mps, scene.view().scale_pxpm());
    const double shown_s = scene.layout().symbols.driftTime_s;
    return std::max(shown_s > 0 ? std::min(shown_s, usual_s) : usual_s, kShortestTime_s);
}

double snapped(double value, double step)
{
    return std::round(value / step) * step;
}

} // namespace

DriftArrow::DriftArrow(MapScene& scene, const std::optional<std::string>& grabbed)
    : m_scene(scene), m_time_s(drawnTime_s(scene))
{
    const std::vector<MapIceberg>& icebergs = scene.picture().icebergs;
    const auto taken =
        grabbed ? std::ranges::find(icebergs, *grabbed, keyOf) : std::ranges::end(icebergs);
    if (taken != icebergs.end()) {
        const QLineF shown = driftArrow(scene.picture(), scene.layout(),
                                        static_cast<std::size_t>(taken - icebergs.begin()));
        QLineF drawn = shown;
        if (!shown.isNull())
            drawn.setLength(taken->velocity_mps.norm() * m_time_s * scene.view().scale_pxpm());
        m_grip_px = shown.p2() - drawn.p2();
    }
    m_scene.setDriftTime(m_time_s);
}

DriftArrow::~DriftArrow()
{
    m_scene.setDriftTime({});
}

Point DriftArrow::velocity_mps(const Iceberg& iceberg, const MapPointer& tip,
                               const Point& current_mps) const
{
    const QPointF centre = m_scene.view().toPixel(iceberg.position_m);
    const std::optional<LabelDisk> symbol = m_scene.symbolOf(iceberg.id);
    // The map's arrows begin at the edge of the symbol, so a tip inside means no drift.
    const double edge_px = symbol ? symbol->radius_px : 0;
    const QPointF tip_px = tip.at_px - m_grip_px;
    const Point path_px(tip_px.x() - centre.x(), centre.y() - tip_px.y());
    const double length_px = path_px.norm();
    if (length_px <= edge_px)
        return Point::Zero();
    Point along = path_px / length_px;
    if (tip.modifiers.testFlag(Qt::ShiftModifier)) {
        const double psi_rad =
            snapped(std::atan2(along.y(), along.x()), radFromDeg(kDirectionStep_deg));
        along = {std::cos(psi_rad), std::sin(psi_rad)};
    }
    const double metres = (length_px - edge_px) / m_scene.view().scale_pxpm();
    const Point overGround_mps = along * (metres / m_time_s);
    return roundedTo(clampedVelocity(overGround_mps - current_mps), kDriftStep_mps);
}

QString DriftArrow::status() const
{
    return DriftArrowText::tr(
               "The arrow shows the drift over %1. Shift snaps to steps of %2°; Esc cancels.")
        .arg(durationText(m_time_s, m_scene.locale()))
        .arg(kDirectionStep_deg);
}

QString driftText(const Point& drift_mps, const QLocale& locale)
{
    const double speed_mps = drift_mps.norm();
    const QString speed = fixedSpeedText(speed_mps, 2, locale);
    return speed_mps > 0 ? speed + u"  "_s + bearingText(drift_mps) : speed;
}

std::optional<double> headingTowards_deg(const Point& from_m, const MapPointer& pointer)
{
    const Point path_m = pointer.at_m - from_m;
    if (path_m.norm() <= 0)
        return std::nullopt;
    const double step_deg = pointer.modifiers.testFlag(Qt::ShiftModifier) ? kDirectionStep_deg : 1;
    const double heading_deg = headingFromPsi(std::atan2(path_m.y(), path_m.x()));
    return std::fmod(snapped(heading_deg, step_deg), 360.0);
}

QString headingText(double heading_deg)
{
    return DriftArrowText::tr("Heading %1").arg(directionText(heading_deg));
}

QString pathText(const Point& path_m, const QLocale& locale)
{
    return u"%1  %2"_s.arg(distanceText(path_m.norm(), locale), bearingText(path_m));
}

} // namespace berg
