#include "widgets/map/paint/map_drift.h"

#include "widgets/map/paint/map_paint.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {
namespace {

constexpr double kLongestArrow_px = 44;
constexpr std::array<double, 11> kDriftTimes_s = {60,   120,  300,   600,   1200, 1800,
                                                  3600, 7200, 21600, 43200, 86400};

constexpr double kTrackLine_px = 1.6;
constexpr double kTrackMark_px = 2.6;
constexpr double kLeastCircle_px = 5;      // smaller circles would hide the mark
constexpr double kLargestCircle_px = 4000; // larger ones fill every map
constexpr double kLabelRoom_px = 46;       // between two labelled marks
constexpr std::size_t kMostCircles = 25;   // icebergs with circles and labels

/** Translation context of free functions, which lupdate would otherwise omit. */
struct DriftTracksText
{
    Q_DECLARE_TR_FUNCTIONS(DriftTracksText)
};

QColor faint(QColor colour, double alpha)
{
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

/** Returns the time from the start of the track, which in flight is the time shown. */
double ahead_s(const DriftTrack& track, const DriftTrackPoint& point)
{
    return point.time_s - track.points.front().time_s;
}

bool isMark(const MapPaint& p, double ahead_s)
{
    constexpr double kRounding_s = 1;
    return ahead_s > 0 &&
           std::abs(std::remainder(ahead_s, p.style.layers.trackMark_s)) < kRounding_s;
}

/** Paints the circles of all tracks as one area: one over the other would hide the map. */
void paintSpread(const MapPaint& p, const std::vector<DriftTrack>& tracks)
{
    constexpr double kRim = 0.3;
    constexpr double kInside = 0.08;
    QPainterPath circles;
    circles.setFillRule(Qt::WindingFill);
    for (const DriftTrack& track : tracks)
        for (const DriftTrackPoint& point : track.points) {
            const double radius_px = point.sd_m * p.layout.view.scale_pxpm();
            if (isMark(p, ahead_s(track, point)) && radius_px >= kLeastCircle_px &&
                radius_px <= kLargestCircle_px)
                circles.addEllipse(p.layout.view.toPixel(point.position_m), radius_px, radius_px);
        }
    p.painter.fillPath(circles, faint(p.theme.comparison, kInside));
    p.painter.strokePath(circles, QPen(faint(p.theme.comparison, kRim), 1));
}

void paintTrackLine(const MapPaint& p, const DriftTrack& track)
{
    QPolygonF line;
    for (const DriftTrackPoint& point : track.points)
        line << p.layout.view.toPixel(point.position_m);
    p.painter.setPen(driftTrackPen(p.theme));
    p.painter.setBrush(Qt::NoBrush);
    p.painter.drawPolyline(line);
}

void paintHours(const MapPaint& p, const QPointF& at, double ahead_s)
{
    constexpr double kHour_s = 3600;
    constexpr double kBeside_px = 6;
    const QString text =
        DriftTracksText::tr("+%1 h").arg(p.style.locale.toString(ahead_s / kHour_s, 'g', 3));
    p.painter.setFont(p.theme.small());
    const QFontMetricsF metrics(p.theme.small());
    const QRectF box(at + QPointF(kBeside_px, -metrics.height() / 2),
                     QSizeF(metrics.horizontalAdvance(text) + 2, metrics.height()));
    drawHaloText(p.painter, box, Qt::AlignLeft | Qt::AlignVCenter, text, p.theme.text, p.theme.sea);
}

void paintTrackMarks(const MapPaint& p, const DriftTrack& track)
{
    QPointF labelled = p.layout.view.toPixel(track.points.front().position_m);
    for (const DriftTrackPoint& point : track.points) {
        if (!isMark(p, ahead_s(track, point)))
            continue;
        const QPointF at = p.layout.view.toPixel(point.position_m);
        p.painter.setPen(QPen(p.theme.sea, 1));
        p.painter.setBrush(p.theme.comparison);
        if (point.isAground)
            p.painter.drawRect(QRectF(at, QSizeF()).adjusted(-4, -4, 4, 4));
        else
            p.painter.drawEllipse(at, kTrackMark_px, kTrackMark_px);
        if (QLineF(labelled, at).length() < kLabelRoom_px)
            continue;
        paintHours(p, at, ahead_s(track, point));
        labelled = at;
        if (point.isAground)
            break;
    }
}

} // namespace

double driftTimeFor_s(double speed_mps, double scale_pxpm)
{
    double suitable_s = 0;
    for (const double time_s : kDriftTimes_s)
        if (speed_mps * time_s * scale_pxpm <= kLongestArrow_px)
            suitable_s = time_s;
    return suitable_s;
}

QLineF driftArrow(const MapPicture& picture, const MapLayout& layout, std::size_t iceberg)
{
    if (layout.density.isDense)
        return {};
    const Point path_m = picture.icebergs[iceberg].velocity_mps * layout.symbols.driftTime_s;
    const Point path_px = path_m * layout.view.scale_pxpm();
    const double length_px = path_px.norm();
    if (length_px < 1.5)
        return {};
    const QPointF along(path_px.x() / length_px, -path_px.y() / length_px);
    const LabelDisk& disk = layout.icebergs[iceberg];
    const QPointF start = disk.centre_px + along * disk.radius_px;
    return {start, start + along * std::min(length_px, kCappedArrow_px)};
}

bool isCapped(const QLineF& arrow)
{
    constexpr double kRounding_px = 1e-6;
    return arrow.length() > kCappedArrow_px - kRounding_px;
}

QPen driftTrackPen(const Theme& theme)
{
    return {theme.comparison, kTrackLine_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void paintDriftTracks(const MapPaint& p)
{
    if (!p.style.layers.tracks)
        return;
    const std::vector<DriftTrack>& tracks = *p.style.layers.tracks;
    const bool isSparse = !p.layout.density.isDense && tracks.size() <= kMostCircles;
    const PainterState saved(p.painter);
    if (isSparse)
        paintSpread(p, tracks);
    for (const DriftTrack& track : tracks)
        if (track.points.size() > 1)
            paintTrackLine(p, track);
    if (!isSparse)
        return;
    for (const DriftTrack& track : tracks)
        if (!track.points.empty())
            paintTrackMarks(p, track);
}

} // namespace berg
