#include "widgets/print/map_page.h"

#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/print/brief_table.h"
#include "widgets/print/export_picture.h"
#include "widgets/print/page_text.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kPage_px(1120, 700);
constexpr double kVisit_px = 3;         // radius of a visit's dot
constexpr double kDenseVisit_px = 1.6;  // radius if there are many visits
constexpr double kTimeHeight_px = 14;   // height of the time beside a dot
constexpr std::size_t kMostTimes = 60;  // more would hide the paths
constexpr double kFarthestTime_px = 24; // a farther label would be ambiguous
constexpr double kUavClearance_px = 17;

struct MapPageText
{
    Q_DECLARE_TR_FUNCTIONS(MapPageText)
};

/** Flown visit at the position of the UAV. */
struct VisitDot
{
    QPointF at_px;
    QColor colour;
    QString time;
    QRectF timeRect{}; ///< null if there is no room
};

/** Data that the page is painted from. */
struct MapSheet
{
    MapPicture picture;
    std::vector<VisitDot> visits;
    Theme theme = Theme::light();
    QLocale locale;
    MapLayout layout;
    Graticule graticule;
};

bool isOfIceberg(const Visit& visit)
{
    return visit.iceberg.has_value();
}

int visitCount(const ExportContent& content)
{
    std::ptrdiff_t count = 0;
    for (const ExportUav& uav : content.uavs)
        count += std::ranges::count_if(uav.visits, isOfIceberg);
    return static_cast<int>(count);
}

std::vector<MapReadout> flownFigures(const ExportContent& content, const QLocale& locale)
{
    std::vector<MapReadout> figures{
        {.caption = MapPageText::tr("Time"),
         .value = MissionClock{.start = content.start}.text(content.now_s),
         .unit = {}}};
    if (content.zeta_m2s) {
        const ShownUnit unit = zetaUnit(*content.zeta_m2s);
        figures.push_back({.caption = MapPageText::tr("Zeta ζ"),
                           .value = significantText(unit.fromSi(*content.zeta_m2s), 4, locale),
                           .unit = unit.name});
    }
    figures.push_back({.caption = MapPageText::tr("Visits, dots on the path"),
                       .value = fixedText(visitCount(content), 0, locale),
                       .unit = {}});
    return figures;
}

/** Readouts of a planned export; empty without a path. */
std::vector<MapReadout> plannedFigures(const ExportContent& content, const QLocale& locale)
{
    double length_m = 0;
    double longest_s = 0;
    for (const ExportUav& uav : content.uavs) {
        const PathTotals path = pathTotals(uav);
        length_m += path.length_m;
        longest_s = std::max(longest_s, path.time_s);
    }
    if (length_m == 0)
        return {};
    const ShownUnit unit = longDistanceUnit();
    return {{.caption = MapPageText::tr("This sortie"),
             .value = significantText(unit.fromSi(length_m), 3, locale),
             .unit = unit.name},
            {.caption = areDistinguished(content.uavs) ? MapPageText::tr("Longest flight")
                                                       : MapPageText::tr("Flight time"),
             .value = clockText(longest_s),
             .unit = {}},
            {.caption = MapPageText::tr("Visits"),
             .value = fixedText(visitCount(content), 0, locale),
             .unit = {}}};
}

/** Interpolated position at a time, on a track with points. */
Point placeAt_m(const std::vector<TrackPoint>& track, double time_s)
{
    const auto next = std::ranges::lower_bound(track, time_s, {}, &TrackPoint::time_s);
    if (next == track.end() || next == track.begin())
        return (next == track.end() ? track.back() : track.front()).state.position_m;
    const TrackPoint& before = *std::prev(next);
    const double part = (time_s - before.time_s) / (next->time_s - before.time_s);
    return before.state.position_m + part * (next->state.position_m - before.state.position_m);
}

std::vector<VisitDot> dotsOf(const ExportContent& content, const MapSheet& sheet)
{
    std::vector<VisitDot> dots;
    if (content.what != ExportScope::Track)
        return dots;
    for (const ExportUav& uav : content.uavs) {
        const std::vector<TrackPoint> track = uav.track.all();
        for (const Visit& visit : uav.visits)
            if (isOfIceberg(visit) && !track.empty())
                dots.push_back(
                    {.at_px = sheet.layout.view.toPixel(placeAt_m(track, visit.time_s)),
                     .colour = uavColour(sheet.theme, static_cast<int>(uav.row)),
                     .time = MissionClock{.start = content.start}.columnText(visit.time_s)});
    }
    return dots;
}

/** Adds a track in pieces long enough to approximate its position. */
void addTrack(std::vector<QLineF>& lines, const MapRoute& route, const MapViewTransform& view)
{
    constexpr double kPiece_px = 8;
    std::optional<QPointF> from_px;
    for (const MapTrackPoint& point : route.track) {
        const QPointF at_px = view.toPixel(point.position_m);
        if (from_px && QLineF(*from_px, at_px).length() < kPiece_px)
            continue;
        if (from_px)
            lines.emplace_back(*from_px, at_px);
        from_px = at_px;
    }
}

LabelDisk diskOf(const VisitDot& visit)
{
    return {.centre_px = visit.at_px, .radius_px = kVisit_px + 1};
}

LabelSurroundings surroundingsOf(const MapSheet& sheet)
{
    LabelSurroundings around;
    around.area = sheet.layout.rect.adjusted(3, 3, -3, -3);
    around.solids = sheet.layout.overlays();
    around.disks = sheet.layout.icebergs;
    for (const PlacedLabel& label : sheet.layout.labels)
        around.solids.push_back(label.rect);
    for (const QRectF& label : sheet.layout.uavLabels)
        around.solids.push_back(label);
    for (const MapUav& uav : sheet.picture.uavs)
        around.disks.push_back({.centre_px = sheet.layout.view.toPixel(uav.position_m),
                                .radius_px = kUavClearance_px});
    for (const VisitDot& visit : sheet.visits)
        around.disks.push_back(diskOf(visit));
    for (const MapRoute& route : sheet.picture.routes)
        addTrack(around.lines, route, sheet.layout.view);
    return around;
}

double distance_px(const QRectF& rect, const QPointF& at_px)
{
    const QPointF near_px(std::clamp(at_px.x(), rect.left(), rect.right()),
                          std::clamp(at_px.y(), rect.top(), rect.bottom()));
    return QLineF(at_px, near_px).length();
}

/** Places times beside the dots where they cover nothing. */
void placeTimes(MapSheet& sheet)
{
    if (sheet.visits.size() > kMostTimes)
        return;
    const QFontMetricsF metrics(sheet.theme.small());
    std::vector<LabelRequest> requests;
    for (const VisitDot& visit : sheet.visits)
        requests.push_back(
            {.anchor = diskOf(visit),
             .size_px = QSizeF(metrics.horizontalAdvance(visit.time) + 2, kTimeHeight_px)});
    const std::vector<PlacedLabel> placed = placeLabels(requests, surroundingsOf(sheet));
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (distance_px(placed[i].rect, sheet.visits[i].at_px) <= kFarthestTime_px)
            sheet.visits[i].timeRect = placed[i].rect;
}

void paintVisits(QPainter& painter, const MapSheet& sheet)
{
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(sheet.theme.small());
    const bool isDense = sheet.visits.size() > kMostTimes;
    const double radius_px = isDense ? kDenseVisit_px : kVisit_px;
    for (const VisitDot& visit : sheet.visits) {
        painter.setPen(isDense ? QPen(Qt::NoPen) : QPen(sheet.theme.sea, 1.2));
        painter.setBrush(visit.colour);
        painter.drawEllipse(visit.at_px, radius_px, radius_px);
        if (!visit.timeRect.isNull())
            drawHaloText(painter, visit.timeRect, Qt::AlignCenter, visit.time,
                         sheet.theme.mutedText, sheet.theme.sea);
    }
}

void paintSheet(QPainter& painter, const MapSheet& sheet)
{
    const MapStyle style{.theme = sheet.theme, .locale = sheet.locale};
    const MapFrame frame{.picture = sheet.picture,
                         .style = style,
                         .layout = sheet.layout,
                         .graticule = sheet.graticule};
    paintMapGround(painter, frame);
    paintMapContent(painter, frame);
    paintVisits(painter, sheet);
    paintMapLabels(painter, frame);
    paintMapOverlays(painter, frame);
}

} // namespace

PicturePage mapPage(const ExportContent& content, const QLocale& locale)
{
    auto sheet = std::make_shared<MapSheet>();
    sheet->locale = locale;
    sheet->picture = exportPicture(content);
    MapPicture& picture = sheet->picture;
    picture.title = pageTitle(content);
    picture.subtitle = pageSubtitle(content, pathsText(content), locale);
    picture.readouts = content.what == ExportScope::Track ? flownFigures(content, locale)
                                                          : plannedFigures(content, locale);
    picture.air = exportAir(content);
    sheet->layout = arrangeMap(picture, {.theme = sheet->theme, .locale = locale},
                               QRectF(QPointF(0, 0), kPage_px));
    sheet->visits = dotsOf(content, *sheet);
    placeTimes(*sheet);
    sheet->graticule =
        graticuleOf(LocalFrame(picture.origin), sheet->layout.view, sheet->layout.rect);
    return {.size_px = kPage_px,
            .title = picture.title,
            .description = picture.subtitle,
            .paint = [sheet = std::shared_ptr<const MapSheet>(std::move(sheet))](
                         QPainter& painter) { paintSheet(painter, *sheet); }};
}

} // namespace berg
