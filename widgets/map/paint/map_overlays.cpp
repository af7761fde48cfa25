#include "widgets/map/paint/map_overlays.h"

#include "core/base/angles.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPadding_px = 12;
constexpr double kReadoutGap_px = 24;
constexpr double kReadoutsBelow_px = 8; // gap below the title
constexpr double kParts_px = 32;        // reserved for the buttons that move and fold the panel
constexpr double kUnitGap_px = 5;
constexpr double kMetresPerNauticalMile = 1852;
constexpr double kBarLength_px = 120;
constexpr double kBarRow_px = 19;
constexpr double kBarHeight_px = 5;

struct MapOverlays
{
    Q_DECLARE_TR_FUNCTIONS(MapOverlays)
};

QFont titleFont(const Theme& theme)
{
    QFont font = theme.strong();
    font.setPixelSize(15);
    return font;
}

double readoutWidth(const MapReadout& readout, const Theme& theme)
{
    const QFontMetricsF small(theme.small());
    double number_px = tabularWidth(QFontMetricsF(theme.figure()), readout.value);
    if (!readout.unit.isEmpty())
        number_px += kUnitGap_px + QFontMetricsF(theme.body()).horizontalAdvance(readout.unit);
    return std::max(number_px, small.horizontalAdvance(readout.caption));
}

double textHeight(const QFont& font)
{
    return QFontMetricsF(font).height();
}

/** One scale bar, of a round length in its unit. */
struct ScaleBar
{
    double length_px = 0;
    QString text;
};

ScaleBar scaleBar(const MapViewTransform& view, const MapStyle& style, DistanceUnit unit)
{
    const double unit_m = unit == DistanceUnit::Nautical ? kMetresPerNauticalMile : 1;
    const double length_m = roundDown125(kBarLength_px / view.scale_pxpm() / unit_m) * unit_m;
    return {.length_px = length_m * view.scale_pxpm(),
            .text = distanceText(length_m, style.locale, 1, unit)};
}

void paintBar(QPainter& painter, const QPointF& at, const ScaleBar& bar, const Theme& theme)
{
    // Alternating fields, as on paper charts, mark the halves.
    painter.setPen(QPen(theme.ink, 1));
    for (int field = 0; field < 2; ++field) {
        const QRectF half(at.x() + field * bar.length_px / 2, at.y() - kBarHeight_px / 2,
                          bar.length_px / 2, kBarHeight_px);
        painter.setBrush(field == 0 ? theme.ink : theme.panel);
        painter.drawRect(half);
    }
    painter.setPen(theme.text);
    painter.setFont(theme.small());
    painter.drawText(QRectF(at.x() + bar.length_px + 8, at.y() - 10, 200, 20),
                     static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignVCenter),
                     bar.text);
}

} // namespace

double SymbolScale::ringRadius_px(double symbol_px, double sigma_m2) const
{
    constexpr double kLargest_px = 18; // limit for sigmas far beyond the scale
    return sigma_m2 > 0 ? symbol_px + 2.5 + std::min(ring_pxpm * std::sqrt(sigma_m2), kLargest_px)
                        : 0;
}

double roundDown125(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= value * (1 + 1e-12))
            return step * decade;
    return decade;
}

void paintPanel(QPainter& painter, const QRectF& rect, const Theme& theme)
{
    const PainterState saved(painter);
    QColor ground = theme.panel;
    ground.setAlphaF(0.94F);
    painter.setPen(QPen(theme.panelLine, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 7, 7);
}

std::vector<MapReadout> readoutsThatFit(const MapPicture& picture, const Theme& theme,
                                        double room_px)
{
    const std::vector<MapReadout>& all = picture.readouts;
    std::vector<std::size_t> byRank(all.size());
    std::iota(byRank.begin(), byRank.end(), std::size_t{0});
    std::ranges::stable_sort(byRank, {}, [&](std::size_t i) { return all[i].rank; });
    std::vector<bool> fits(all.size());
    double left_px = room_px + kReadoutGap_px;
    for (const std::size_t i : byRank) {
        const double width_px = readoutWidth(all[i], theme) + kReadoutGap_px;
        fits[i] = width_px <= left_px; // a cut-off number could be misread
        left_px -= fits[i] ? width_px : 0;
    }
    std::vector<MapReadout> shown;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (fits[i])
            shown.push_back(all[i]);
    return shown;
}

QSizeF titleSize(const MapPicture& picture, const MapStyle& style, TitleForm form)
{
    if (picture.title.isEmpty() && picture.readouts.empty())
        return {};
    const QFont font = titleFont(style.theme);
    double width_px = kParts_px;
    double height_px = 0;
    if (!form.isCompact) {
        width_px += QFontMetricsF(font).horizontalAdvance(picture.title);
        height_px += textHeight(font);
    }
    if (!picture.subtitle.isEmpty() && !form.isCompact) {
        width_px = std::max(width_px,
                            QFontMetricsF(style.theme.small()).horizontalAdvance(picture.subtitle));
        height_px += textHeight(style.theme.small()) + 2;
    }
    width_px = std::min(width_px, form.widestText_px - 2 * kPadding_px - 1);
    if (!picture.readouts.empty()) {
        double row_px = -kReadoutGap_px;
        for (MapReadout readout : picture.readouts) {
            if (style.isLive && !readout.unit.isEmpty() && readout.value.size() < 6)
                readout.value = u"88 888"_s; // room for growth in flight
            row_px += readoutWidth(readout, style.theme) + kReadoutGap_px;
        }
        width_px = std::max(width_px, row_px);
        height_px += textHeight(style.theme.small()) + textHeight(style.theme.figure()) +
                     (form.isCompact ? 0 : kReadoutsBelow_px);
    }
    return {std::min(std::ceil(width_px) + 2 * kPadding_px + 1, form.widest_px),
            height_px + 2 * kPadding_px - 4};
}

namespace {

/** Paints readouts side by side, the first caption at `at`. */
void paintReadouts(QPainter& painter, QPointF at, const std::vector<MapReadout>& readouts,
                   const Theme& theme)
{
    const double captionHeight_px = textHeight(theme.small());
    const QFontMetricsF small(theme.small());
    const QFontMetricsF large(theme.figure());
    for (const MapReadout& readout : readouts) {
        painter.setFont(theme.small());
        painter.setPen(theme.mutedText);
        painter.drawText(at + QPointF(0, small.ascent()), readout.caption);
        const QPointF baseline = at + QPointF(0, captionHeight_px + large.ascent());
        painter.setFont(theme.figure());
        painter.setPen(theme.text);
        drawTabular(painter, baseline, readout.value);
        painter.setFont(theme.body());
        painter.setPen(theme.mutedText);
        painter.drawText(baseline + QPointF(tabularWidth(large, readout.value) + kUnitGap_px, 0),
                         readout.unit);
        at.rx() += readoutWidth(readout, theme) + kReadoutGap_px;
    }
}

} // namespace

void paintTitle(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                const MapStyle& style, bool isCompact)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    paintPanel(painter, rect, theme);
    painter.setClipRect(rect);
    const double width_px = rect.width() - 2 * kPadding_px;
    QPointF at = rect.topLeft() + QPointF(kPadding_px, kPadding_px - 2);
    const auto line = [&](const QFont& font, const QColor& colour, const QString& text,
                          double room_px) {
        const QFontMetricsF metrics(font);
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(at + QPointF(0, metrics.ascent()),
                         metrics.elidedText(text, Qt::ElideRight, room_px));
        at.ry() += metrics.height();
    };
    if (!isCompact) {
        line(titleFont(theme), theme.text, picture.title, width_px - kParts_px);
        if (!picture.subtitle.isEmpty()) {
            at.ry() += 2;
            line(theme.small(), theme.mutedText, picture.subtitle, width_px);
        }
        at.ry() += kReadoutsBelow_px;
    }
    paintReadouts(painter, at, readoutsThatFit(picture, theme, width_px + kPadding_px / 2), theme);
}

QSizeF scaleBarSize(const MapViewTransform& view, const MapStyle& style)
{
    const QFontMetricsF small(style.theme.small());
    double width_px = 0;
    for (const DistanceUnit unit : {DistanceUnit::Metric, DistanceUnit::Nautical}) {
        const ScaleBar bar = scaleBar(view, style, unit);
        width_px = std::max(width_px, bar.length_px + 8 + small.horizontalAdvance(bar.text));
    }
    return {std::ceil(width_px) + 2 * kPadding_px, 2 * kBarRow_px + 12};
}

void paintScaleBar(QPainter& painter, const QRectF& rect, const MapViewTransform& view,
                   const MapStyle& style)
{
    const PainterState saved(painter);
    paintPanel(painter, rect, style.theme);
    QPointF at = rect.topLeft() + QPointF(kPadding_px, 6 + kBarRow_px / 2);
    for (const DistanceUnit unit : {DistanceUnit::Metric, DistanceUnit::Nautical}) {
        paintBar(painter, at, scaleBar(view, style, unit), style.theme);
        at.ry() += kBarRow_px;
    }
}

QSizeF northArrowSize()
{
    return {38, 52};
}

void paintNorthArrow(QPainter& painter, const QRectF& rect, double angle_rad, const MapStyle& style)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    paintPanel(painter, rect, theme);
    painter.translate(rect.center());
    painter.rotate(degFromRad(angle_rad));
    painter.setPen(QPen(theme.ink, 1.1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(theme.ink);
    painter.drawPolygon(QPolygonF{{0, -6}, {0, 13}, {-7, 18}});
    painter.setBrush(theme.panel);
    painter.drawPolygon(QPolygonF{{0, -6}, {0, 13}, {7, 18}});
    painter.setPen(theme.text);
    painter.setFont(theme.strong());
    painter.drawText(QRectF(-15, -24, 30, 18), Qt::AlignCenter,
                     MapOverlays::tr("N", "north on the compass"));
}

void paintEmptyState(QPainter& painter, const QRectF& area, const MapPicture& picture,
                     const MapStyle& style)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    QFont font = theme.strong();
    font.setPixelSize(18);
    const double width_px = std::min(460.0, area.width() - 24);
    if (width_px < 60)
        return;
    const int centred = static_cast<int>(Qt::AlignHCenter) | static_cast<int>(Qt::TextWordWrap);
    const QRectF open(0, 0, width_px - 2 * kPadding_px, 1000);
    const QRectF title = QFontMetricsF(font).boundingRect(open, centred, picture.emptyTitle);
    const QRectF hint = QFontMetricsF(theme.body()).boundingRect(open, centred, picture.emptyHint);
    const double symbol_px = 58;
    const QSizeF size(width_px, symbol_px + title.height() + hint.height() + 34);
    if (size.height() > area.height())
        return;
    // Placed below the middle, because the UAV is in the middle.
    const double top = area.top() + 0.8 * (area.height() - size.height());
    const QRectF rect(QPointF(area.center().x() - size.width() / 2, top), size);
    paintPanel(painter, rect, theme);
    drawIceberg(painter, QPointF(rect.center().x(), rect.top() + 38),
                {.radius_px = 22, .sigma = theme.sigma.at(0.4)}, theme);
    painter.setFont(font);
    painter.setPen(theme.text);
    QRectF text(rect.left() + kPadding_px, rect.top() + symbol_px + 8, open.width(),
                title.height());
    painter.drawText(text, centred, picture.emptyTitle);
    painter.setFont(theme.body());
    painter.setPen(theme.mutedText);
    text = QRectF(text.left(), text.bottom() + 6, open.width(), hint.height() + 4);
    painter.drawText(text, centred, picture.emptyHint);
}

} // namespace berg
