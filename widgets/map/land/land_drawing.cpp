#include "widgets/map/land/land_drawing.h"

#include "core/base/angles.h"
#include "widgets/map/land/cell_projection.h"
#include "widgets/map/land/clipping.h"
#include "widgets/theme/painter_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {
namespace {

/** Above this scale the coarse data show corners, and few enough of the fine data are in view. */
constexpr double kFineScale_pxpm = 6e-4;

constexpr double kSmallestScale =
    0.99; // smallest ratio of lengths in a plane to true ones: at the pole of UPS
constexpr double kCullSlack_rad = 0.02; // covers the sphere and cell borders off their chords
constexpr double kClipMargin_px = 8;    // hides cuts and caps of lines
constexpr double kCoast_px = 1;
constexpr double kFineCoast_px = 0.5;    // coast width at small scales
constexpr double kFullScale_pxpm = 1e-4; // from this scale coasts have their full width
constexpr double kDetail_px = 0.7;       // coast finer than this is left out
constexpr double kSmallest_px = 0.4;     // smaller islands are left out

Eigen::Vector3d onSphere(LatLon place)
{
    const double latitude_rad = radFromDeg(place.latitude_deg);
    const double longitude_rad = radFromDeg(place.longitude_deg);
    return {std::cos(latitude_rad) * std::cos(longitude_rad),
            std::cos(latitude_rad) * std::sin(longitude_rad), std::sin(latitude_rad)};
}

double arc_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return 2 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

bool isWithin(const WorldBounds& inner, const WorldBounds& outer)
{
    return (inner.min_m.array() >= outer.min_m.array()).all() &&
           (inner.max_m.array() <= outer.max_m.array()).all();
}

LatLon middleOf(const MapPlane& plane)
{
    return toGeographic(plane, Point::Zero());
}

} // namespace

LandStyle landStyleOf(const Theme& theme)
{
    return {.sea = theme.sea, .land = theme.land, .coast = theme.coast, .beyond = theme.panel};
}

LandDetail landDetailFor(double scale_pxpm)
{
    return scale_pxpm < kFineScale_pxpm ? LandDetail::Coarse : LandDetail::Fine;
}

LandDrawing::LandDrawing(const LandData& data, const MapPlane& plane)
    : m_data(data)
    , m_plane(plane)
    , m_middle(onSphere(middleOf(plane)))
    , m_cells(data.cells().size())
{
    const double half_deg = data.cellSide_deg() / 2;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const LatLon southWest = data.placeOf(data.cells()[i].southWest);
        const LatLon middle{southWest.latitude_deg + half_deg, southWest.longitude_deg + half_deg};
        m_cells[i].middle = onSphere(middle);
        const double nearEquator_deg =
            std::max(0.0, std::abs(middle.latitude_deg) - half_deg); // the farthest corners
        m_cells[i].radius_rad = arc_rad(
            m_cells[i].middle, onSphere({std::copysign(nearEquator_deg, middle.latitude_deg),
                                         southWest.longitude_deg}));
    }
}

const std::vector<LandDrawing::Ring>& LandDrawing::projected(std::size_t cell)
{
    std::optional<std::vector<Ring>>& rings = m_cells[cell].rings;
    if (rings)
        return *rings;
    rings.emplace();
    const CellProjection project(m_plane, m_data.placeOf(m_data.cells()[cell].southWest),
                                 m_data.cellSide_deg());
    for (const LandRing& outline : m_data.cells()[cell].rings) {
        Ring ring;
        ring.points_m.reserve(outline.size());
        LandPoint before = outline.back();
        for (const LandPoint& point : outline) {
            ring.points_m.push_back(project(m_data.placeOf(point)));
            ring.isCut.push_back(m_data.isCut(before, point));
            before = point;
        }
        ring.bounds = boundsOf(ring.points_m);
        rings->push_back(std::move(ring));
    }
    return *rings;
}

void LandDrawing::addTo(QPainterPath& land, QPainterPath& coast, const Ring& ring,
                        const MapViewTransform& view, const QRectF& rect) const
{
    const std::size_t count = ring.points_m.size();
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(count));
    QPointF before = view.toPixel(ring.points_m.back());
    for (std::size_t i = 0; i < count; ++i) {
        const QPointF at = view.toPixel(ring.points_m[i]);
        // The neighbouring cell shares the ends of cuts, so they must stay.
        const bool isEnd = i + 1 == count || ring.isCut[i] || ring.isCut[i + 1];
        if (!isEnd && (at - before).manhattanLength() < kDetail_px)
            continue;
        polygon << at;
        const QLineF edge(std::exchange(before, at), at);
        if (!ring.isCut[i])
            addClipped(coast, edge, rect);
    }
    land.addPolygon(isWithin(ring.bounds, view.visible(rect)) ? polygon : clipped(polygon, rect));
}

void LandDrawing::paint(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
                        const LandStyle& style)
{
    const QRectF wide =
        rect.adjusted(-kClipMargin_px, -kClipMargin_px, kClipMargin_px, kClipMargin_px);
    const WorldBounds visible = view.visible(wide);
    const Eigen::Vector3d middle = onSphere(toGeographic(m_plane, visible.centre_m()));
    const double radius_rad =
        0.5 * visible.size_m().norm() / kEarthRadius_m / kSmallestScale + kCullSlack_rad;
    const double smallest_m = kSmallest_px / view.scale_pxpm();
    QPainterPath land;
    land.setFillRule(Qt::WindingFill);
    QPainterPath coast;
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Cell& cell = m_cells[i];
        if (arc_rad(middle, cell.middle) > radius_rad + cell.radius_rad ||
            arc_rad(m_middle, cell.middle) > radFromDeg(kMapReach_deg) + cell.radius_rad)
            continue;
        for (const Ring& ring : projected(i))
            if (meet(ring.bounds, visible) && ring.bounds.size_m().maxCoeff() >= smallest_m)
                addTo(land, coast, ring, view, wide);
    }
    const PainterState saved(painter);
    painter.setClipRect(rect, Qt::IntersectClip);
    painter.fillRect(rect, style.sea);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(land, style.land);
    const double coast_px =
        std::clamp(kCoast_px * view.scale_pxpm() / kFullScale_pxpm, kFineCoast_px, kCoast_px);
    painter.strokePath(coast,
                       QPen(style.coast, coast_px, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
    paintBeyond(painter, view, rect, style);
}

void LandDrawing::paintBeyond(QPainter& painter, const MapViewTransform& view, const QRectF& rect,
                              const LandStyle& style) const
{
    const std::optional<QPainterPath> reach = reachIn(rect, m_plane, view);
    if (!reach)
        return;
    QPainterPath beyond;
    beyond.setFillRule(Qt::OddEvenFill);
    beyond.addRect(rect.united(reach->boundingRect()).adjusted(-1, -1, 1, 1));
    beyond.addPath(*reach);
    painter.fillPath(beyond, style.beyond);
    painter.strokePath(*reach, QPen(style.coast, kCoast_px));
}

std::optional<QPainterPath> reachIn(const QRectF& rect, const MapPlane& plane,
                                    const MapViewTransform& view)
{
    const double radius_m = mapReach_m(plane);
    const WorldBounds seen = view.visible(rect);
    if (seen.min_m.cwiseAbs().cwiseMax(seen.max_m.cwiseAbs()).norm() < radius_m)
        return std::nullopt;
    const double radius_px = radius_m * view.scale_pxpm();
    QPainterPath disk;
    disk.addEllipse(view.toPixel(Point::Zero()), radius_px, radius_px);
    return disk;
}

void paintLand(QPainter& painter, const MapPlane& plane, const MapViewTransform& view,
               const QRectF& rect, const LandStyle& style)
{
    LandDrawing(landData(landDetailFor(view.scale_pxpm())), plane)
        .paint(painter, view, rect, style);
}

} // namespace berg
