#include "widgets/map/paint/map_paths.h"

#include "widgets/map/paint/map_legs.h"
#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/paint/swept_layer.h"
#include "widgets/map/picture/footprint.h"
#include "widgets/map/picture/route_colours.h"
#include "widgets/theme/palette.h"
#include "widgets/words/plan_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kOldestTrack = 0.2; // share of the track's colour at its oldest end
constexpr int kTrackShades = 40;
constexpr double kComparison_px = 1.2;      // thinner than the track
constexpr double kComparisonMarks_px = 150; // distance of its arrow heads
constexpr double kComparisonMark_px = 9;
constexpr std::size_t kHeadingLegs = 3;
constexpr double kHeading_px = 24;
constexpr double kFarPlan = 0.5; // colour share of far legs in a dense field

/** Longest straight piece, which has most room for an arrow head. */
QLineF longestPiece(const QPolygonF& leg)
{
    QLineF longest;
    for (qsizetype i = 1; i < leg.size(); ++i)
        if (const QLineF piece(leg[i - 1], leg[i]); piece.length() > longest.length())
            longest = piece;
    return longest;
}

/** Unit vector of the heading for a course in wind, both over the local plane. */
Point headingOn(const Point& course, const Point& wind_mps, double airspeed_mps)
{
    const double across = std::clamp(-cross(course, wind_mps) / airspeed_mps, -1.0, 1.0);
    return Eigen::Rotation2Dd(std::asin(across)) * course;
}

/** Draws small aircraft that crab along their legs. */
void paintHeadingMarks(const MapPaint& p, std::size_t uav, const QColor& colour)
{
    constexpr double kSize = 0.7; // relative to a UAV's symbol
    for (const QLineF& mark : headingMarks(p.picture, p.layout, uav)) {
        p.painter.save();
        p.painter.translate(mark.p1());
        p.painter.scale(kSize, kSize);
        drawUav(p.painter, {}, std::atan2(-mark.dy(), mark.dx()), colour, p.theme);
        p.painter.restore();
    }
}

/** Draws aim points. A leg ends when its iceberg comes into view; a dotted line leads on to them.
 */
void paintAims(const MapPaint& p, const MapRoute& route, const QColor& colour)
{
    for (const MapPath& path : route.planPaths) {
        if (!path.aim_m)
            continue;
        const QPointF aim = p.layout.view.toPixel(*path.aim_m);
        p.painter.setPen(QPen(colour, 1, Qt::DotLine, Qt::FlatCap));
        p.painter.drawLine(p.layout.view.toPixel(path.path_m.back()), aim);
        drawAim(p.painter, aim, colour, p.theme);
    }
}

/** Draws a track in one colour with arrow heads, which distinguish it from the flown track. */
void paintComparisonTrack(const MapPaint& p, const std::vector<MapTrackPoint>& track)
{
    if (track.size() < 2)
        return;
    QPolygonF line{p.layout.view.toPixel(track.front().position_m)};
    std::vector<QLineF> marks;
    double sinceMark_px = kComparisonMarks_px / 2;
    for (const MapTrackPoint& point : track) {
        const QLineF step(line.back(), p.layout.view.toPixel(point.position_m));
        if (step.length() < 1)
            continue;
        line << step.p2();
        sinceMark_px += step.length();
        if (sinceMark_px >= kComparisonMarks_px && p.layout.rect.contains(step.p2())) {
            // Longer than the step, because direction marks are not drawn on short lines.
            const QPointF reach = (step.p2() - step.p1()) / step.length() * 3 * kComparisonMark_px;
            marks.emplace_back(step.p2() - reach, step.p2() + reach);
            sinceMark_px = 0;
        }
    }
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(
        QPen(p.theme.comparison, kComparison_px, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
    p.painter.drawPolyline(line);
    for (const QLineF& mark : marks)
        drawDirectionMark(p.painter, mark, p.theme.comparison, kComparisonMark_px);
}

void paintTrack(const MapPaint& p, const std::vector<MapTrackPoint>& track, const QColor& colour)
{
    if (track.size() < 2)
        return;
    const double from_s = track.front().time_s;
    const double span_s = std::max(1e-9, track.back().time_s - from_s);
    const auto shadeOf = [&](double time_s) {
        return static_cast<int>((time_s - from_s) / span_s * (kTrackShades - 1));
    };
    p.painter.setBrush(Qt::NoBrush);
    QPolygonF piece{p.layout.view.toPixel(track.front().position_m)};
    int shade = 0;
    const auto flush = [&] {
        // Mixed with the sea instead of translucent, else crossings would add up. Bevel joins look
        // like round ones on so thin a line and are much faster.
        const double share =
            kOldestTrack + (1 - kOldestTrack) * static_cast<double>(shade) / (kTrackShades - 1);
        p.painter.setPen(QPen(mixed(p.theme.sea, colour, share), 1.6, Qt::SolidLine, Qt::FlatCap,
                              Qt::BevelJoin));
        p.painter.drawPolyline(piece);
    };
    for (const MapTrackPoint& point : track) {
        const QPointF at = p.layout.view.toPixel(point.position_m);
        const QPointF step = at - piece.back();
        if (QPointF::dotProduct(step, step) >= 1)
            piece << at;
        if (shadeOf(point.time_s) == shade)
            continue;
        flush();
        piece = QPolygonF{piece.back()};
        shade = shadeOf(point.time_s);
    }
    piece << p.layout.view.toPixel(track.back().position_m);
    flush();
}

/** Draws places to search as rings with the probability of finding an iceberg there. */
void paintSearchPlaces(const MapPaint& p, const MapRoute& route, const QColor& colour)
{
    const QFontMetricsF metrics(p.theme.small());
    p.painter.setFont(p.theme.small());
    for (const MapSearchPlace& place : route.searchPlaces) {
        const QPointF centre = p.layout.view.toPixel(place.position_m);
        drawSearchPlace(p.painter, centre, colour);
        const QString text = chanceText(place.chance, p.style.locale);
        const QRectF box(centre + QPointF(kSearchPlace_px + 2, -metrics.height() / 2),
                         QSizeF(metrics.horizontalAdvance(text) + 1, metrics.height()));
        drawHaloText(p.painter, box, Qt::AlignLeft | Qt::AlignVCenter, text, p.theme.ink,
                     p.theme.sea);
    }
}

void paintPlan(const MapPaint& p, std::size_t uav)
{
    const MapRoute& route = p.picture.routes[uav];
    const RouteColours colours = routeColours(p.picture, p.theme, uav);
    paintAims(p, route, colours.plan);
    const std::vector<QPolygonF> legs = planLegs(p.picture, p.layout, uav);
    p.painter.setBrush(Qt::NoBrush);
    p.painter.setPen(QPen(colours.plan, 1.6, Qt::DashLine, Qt::FlatCap));
    p.painter.drawPolyline(homeLeg(p.picture, p.layout, uav));
    for (std::size_t k = legs.size(); k-- > 0;) {
        const bool isNext = k == 0 && route.search_m.empty();
        const double width_px = isNext ? 3.2 : 1.6;
        if (legs[k].size() < 2)
            continue;
        if (p.layout.density.isDense && k >= kNumberedNext) { // far legs must not cover the field
            p.painter.setPen(QPen(mixed(p.theme.sea, colours.plan, kFarPlan), 1));
            p.painter.drawPolyline(legs[k]);
            continue;
        }
        // A rim of sea sets the line off from the track below.
        p.painter.setPen(
            QPen(p.theme.sea, width_px + 2.4, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
        p.painter.drawPolyline(legs[k]);
        p.painter.setPen(QPen(colours.plan, width_px, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
        p.painter.drawPolyline(legs[k]);
        drawDirectionMark(p.painter, longestPiece(legs[k]), colours.plan, isNext ? 13 : 10);
    }
    paintSearchPlaces(p, route, colours.plan);
    paintHeadingMarks(p, uav, colours.uav);
}

} // namespace

void paintSwept(const MapPaint& p)
{
    if (!p.picture.showsSwept())
        return;
    const SweptStyle style{.view = p.layout.view,
                           .rect = p.layout.rect,
                           .ratio = p.painter.device()->devicePixelRatioF(),
                           .tint = p.theme.swept};
    std::vector<SweptTrail> trails;
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav)
        if (const SweptPointer& swept = p.picture.routes[uav].swept)
            trails.push_back({.poses = *swept, .sensor = p.picture.uavs[uav].sensor});
    if (p.swept != nullptr) {
        p.swept->paint(p.painter, trails, style);
        return;
    }
    SweptMask mask;
    p.painter.drawImage(p.layout.rect.topLeft(), mask.updated(trails, style));
}

void paintComparison(const MapPaint& p)
{
    for (const std::vector<MapTrackPoint>& track : p.picture.comparisonTracks)
        paintComparisonTrack(p, track);
}

void paintTracks(const MapPaint& p)
{
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav)
        paintTrack(p, p.picture.routes[uav].track, routeColours(p.picture, p.theme, uav).track);
}

void paintFieldsOfView(const MapPaint& p)
{
    for (const MapUav& uav : p.picture.uavs) {
        const QColor line = uavColour(p.theme, uav.place);
        QColor fill = line;
        fill.setAlphaF(0.09F);
        p.painter.setPen(QPen(line, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        p.painter.setBrush(fill);
        p.painter.drawPolygon(fieldOutline(uav, p.layout.view));
    }
}

QPen laterVisitsPen(const QColor& colour)
{
    QColor faint = colour;
    faint.setAlphaF(0.45F);
    return {faint, 1, Qt::DotLine, Qt::FlatCap, Qt::BevelJoin};
}

void paintLaterVisits(const MapPaint& p)
{
    p.painter.setBrush(Qt::NoBrush);
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav) {
        const MapRoute& route = p.picture.routes[uav];
        if (route.laterVisits_m.empty())
            continue;
        QPolygonF line;
        if (!route.planPaths.empty() && !route.planPaths.back().path_m.empty())
            line << p.layout.view.toPixel(route.planPaths.back().path_m.back());
        for (const Point& place_m : route.laterVisits_m)
            line << p.layout.view.toPixel(place_m);
        p.painter.setPen(laterVisitsPen(routeColours(p.picture, p.theme, uav).plan));
        p.painter.drawPolyline(line);
    }
}

void paintFormerPlans(const MapPaint& p)
{
    p.painter.setBrush(Qt::NoBrush);
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav) {
        p.painter.setPen(formerPlanPen(routeColours(p.picture, p.theme, uav).former));
        for (const QPolygonF& leg : formerLegs(p.picture, p.layout, uav))
            p.painter.drawPolyline(leg);
    }
}

std::vector<QLineF> headingMarks(const MapPicture& picture, const MapLayout& layout,
                                 std::size_t uav)
{
    if (picture.air.wind_mps.isZero(0))
        return {};
    std::vector<QLineF> marks;
    std::vector<QPolygonF> legs = planLegs(picture, layout, uav);
    legs.resize(std::min(legs.size(), kHeadingLegs));
    for (const QPolygonF& leg : legs) {
        const QLineF piece = longestPiece(leg);
        if (piece.length() < 2 * kHeading_px)
            continue;
        const Point course(piece.dx() / piece.length(), -piece.dy() / piece.length());
        const Point nose = headingOn(course, picture.air.wind_mps, picture.uavs[uav].airspeed_mps);
        marks.emplace_back(piece.center(),
                           piece.center() + QPointF(nose.x(), -nose.y()) * kHeading_px);
    }
    return marks;
}

void paintSearches(const MapPaint& p)
{
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav) {
        const MapRoute& route = p.picture.routes[uav];
        if (route.search_m.empty())
            continue;
        const QColor colour = routeColours(p.picture, p.theme, uav).uav;
        QPolygonF path{p.layout.view.toPixel(p.picture.uavs[uav].position_m)};
        path << p.layout.view.toPixels(route.search_m);
        p.painter.setBrush(Qt::NoBrush);
        p.painter.setPen(searchPen(colour));
        p.painter.drawPolyline(path);
        drawDirectionMark(p.painter, QLineF(path[0], path[1]), colour, 10);
    }
}

void paintPlans(const MapPaint& p)
{
    for (std::size_t uav = 0; uav < p.picture.routes.size(); ++uav)
        paintPlan(p, uav);
}

} // namespace berg
