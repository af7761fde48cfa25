#include "widgets/map/map_overlays.h"
#include "widgets/map/map_symbols.h"
#include "widgets/map/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPadding_px = 12;
constexpr double kBarWidth_px = 190;
constexpr double kBarHeight_px = 9;
constexpr double kUnitColumn_px = 34; ///< room for "m²" after the last number
constexpr double kSymbolRadius_px = 8;
constexpr double kSwatch_px = 34;
constexpr double kRow_px = 18;
constexpr double kSymbolRow_px = 26;
constexpr int kGradientStops = 24;

struct MapLegend
{
    Q_DECLARE_TR_FUNCTIONS(MapLegend)
};

/** One row: a small drawing and what it means. */
struct LegendRow
{
    QString text;
    std::function<void(QPainter&, const QRectF&)> draw; ///< into a swatch of kSwatch_px
    double height_px = kRow_px;
};

void drawPlanSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const double y = swatch.center().y();
    painter.setPen(QPen(theme.plan, 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(swatch.left(), y), QPointF(swatch.center().x(), y));
    painter.setPen(QPen(theme.plan, 1.5));
    painter.drawLine(QPointF(swatch.center().x(), y), QPointF(swatch.right(), y));
    drawOrderDisk(painter, {swatch.center().x(), y}, 7.5, 1, theme);
}

void drawFormerSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    painter.setPen(formerPlanPen(theme));
    painter.drawLine(QPointF(swatch.left(), swatch.center().y()),
                     QPointF(swatch.right(), swatch.center().y()));
}

void drawTrackSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    QLinearGradient fade(swatch.topLeft(), swatch.topRight());
    fade.setColorAt(0, mixed(theme.panel, theme.track, 0.15));
    fade.setColorAt(1, theme.track);
    painter.setPen(QPen(fade, 2));
    painter.drawLine(QPointF(swatch.left(), swatch.center().y()),
                     QPointF(swatch.right(), swatch.center().y()));
}

void drawComparisonSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const QLineF line(swatch.left(), swatch.center().y(), swatch.right(), swatch.center().y());
    painter.setPen(QPen(theme.comparison, 1.6, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
    const QPointF beyond(kSwatch_px, 0); // marks keep off lines too short for them
    drawDirectionMark(painter, QLineF(line.p1() - beyond, line.p2() + beyond), theme.comparison, 9);
}

void drawFieldSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const QRectF box(swatch.left() + 8, swatch.center().y() - 6, 18, 12);
    QColor fill = theme.uav;
    fill.setAlphaF(0.12F);
    painter.setPen(QPen(theme.uav, 1.5));
    painter.setBrush(fill);
    painter.drawRect(box);
}

/** Water, the right half of it seen. */
void drawSweptSwatch(QPainter& painter, const QRectF& swatch, const Theme& theme)
{
    const QRectF box(swatch.left() + 2, swatch.center().y() - 6, kSwatch_px - 4, 12);
    painter.fillRect(box, theme.sea);
    painter.fillRect(box.adjusted(box.width() / 2, 0, 0, 0), theme.swept);
    painter.setPen(QPen(theme.panelLine, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
}

std::vector<LegendRow> rowsOf(const MapPicture& picture, const MapStyle& style,
                              const SymbolScale& scale)
{
    const Theme& theme = style.theme;
    std::vector<LegendRow> rows;
    const bool anyInView = std::any_of(picture.icebergs.begin(), picture.icebergs.end(),
                                       [](const MapIceberg& iceberg) { return iceberg.inView; });
    if (anyInView)
        rows.push_back({MapLegend::tr("In view now: σ is 0"),
                        [&](QPainter& p, const QRectF& r) {
                            drawIceberg(p, r.center(), {.radius_px = 6, .inView = true}, theme);
                        },
                        kSymbolRow_px});
    const bool anyLater =
        std::any_of(picture.icebergs.begin(), picture.icebergs.end(),
                    [](const MapIceberg& iceberg) { return iceberg.appears_s > 0; });
    if (anyLater)
        rows.push_back(
            {MapLegend::tr("Still to come, with its time"),
             [&](QPainter& p, const QRectF& r) {
                 drawIceberg(
                     p, r.center(),
                     {.radius_px = 6, .ring_px = 10, .sigma = theme.sigma.at(0.3), .later = true},
                     theme);
             },
             kSymbolRow_px});
    if (!picture.plan.empty())
        rows.push_back({MapLegend::tr("Plan, next leg thicker"),
                        [&](QPainter& p, const QRectF& r) { drawPlanSwatch(p, r, theme); }});
    if (!picture.formerPlan.empty())
        rows.push_back({MapLegend::tr("Plan before the change"),
                        [&](QPainter& p, const QRectF& r) { drawFormerSwatch(p, r, theme); }});
    if (picture.track.size() > 1)
        rows.push_back({MapLegend::tr("Flown, older parts fainter"),
                        [&](QPainter& p, const QRectF& r) { drawTrackSwatch(p, r, theme); }});
    if (picture.comparisonTrack.size() > 1) {
        const QString text = MapLegend::tr("Compared: %1").arg(picture.comparisonName);
        rows.push_back({QFontMetricsF(theme.small())
                            .elidedText(text, Qt::ElideRight, kBarWidth_px + kUnitColumn_px),
                        [&](QPainter& p, const QRectF& r) { drawComparisonSwatch(p, r, theme); }});
    }
    if (picture.uav)
        rows.push_back({MapLegend::tr("Field of view"),
                        [&](QPainter& p, const QRectF& r) { drawFieldSwatch(p, r, theme); }});
    if (picture.showsSwept())
        rows.push_back({MapLegend::tr("Seen so far"),
                        [&](QPainter& p, const QRectF& r) { drawSweptSwatch(p, r, theme); }});
    if (scale.driftTime_s > 0)
        rows.push_back(
            {MapLegend::tr("Drift in %1").arg(durationText(scale.driftTime_s, style.locale)),
             [&](QPainter& p, const QRectF& r) {
                 const QLineF arrow(r.left() + 4, r.center().y(), r.right() - 4, r.center().y());
                 drawArrow(p, arrow, QPen(theme.ink, 1.6), 7);
             }});
    return rows;
}

double largestRing_px(const MapPicture& picture, const SymbolScale& scale)
{
    return scale.ringRadius_px(kSymbolRadius_px, picture.sigmaFull_m2);
}

/** Height of the part that explains sigma: heading, sample rings, bar, two rows of numbers. */
double sigmaHeight_px(const MapPicture& picture, const SymbolScale& scale)
{
    return 18 + 2 * largestRing_px(picture, scale) + 8 + kBarHeight_px + 2 * 14 + 4;
}

/** "5" or "0.25": a tick is round, so it needs no more digits than it has. */
QString tickText(double tick_m2, const QLocale& locale)
{
    int decimals = 0;
    for (double v = tick_m2; decimals < 6 && std::abs(v - std::round(v)) > 1e-6; v *= 10)
        ++decimals;
    return fixedText(tick_m2, decimals, locale);
}

void paintSigmaBar(QPainter& painter, const QRectF& bar, const MapPicture& picture,
                   const Theme& theme)
{
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= kGradientStops; ++i) {
        const double t = static_cast<double>(i) / kGradientStops;
        gradient.setColorAt(t, theme.sigma.at(t));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(gradient);
    painter.drawRoundedRect(bar, 2, 2);
    painter.setPen(QPen(theme.ink, 1));
    for (const double tick_m2 : sigmaTicks(picture.sigmaFull_m2)) {
        const double x = bar.left() + bar.width() * tick_m2 / picture.sigmaFull_m2;
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
    }
}

} // namespace

std::vector<double> sigmaTicks(double full_m2)
{
    // Few enough that the sample rings stay apart.
    double step_m2 = full_m2 / 2;
    for (const double parts : {4.0, 3.0}) {
        if (std::abs(roundDown125(full_m2 / parts) - full_m2 / parts) < 1e-9 * full_m2) {
            step_m2 = full_m2 / parts;
            break;
        }
    }
    std::vector<double> ticks_m2;
    for (int k = 1; k * step_m2 <= full_m2 * (1 + 1e-9); ++k)
        ticks_m2.push_back(k * step_m2);
    return ticks_m2;
}

QSizeF legendSize(const MapPicture& picture, const MapStyle& style, const SymbolScale& scale)
{
    if (picture.icebergs.empty())
        return {};
    const QFontMetricsF small(style.theme.small());
    const auto rows = rowsOf(picture, style, scale);
    double width_px = kBarWidth_px + kUnitColumn_px;
    double height_px = sigmaHeight_px(picture, scale) + 8;
    for (const LegendRow& row : rows) {
        width_px = std::max(width_px, kSwatch_px + 8 + small.horizontalAdvance(row.text));
        height_px += row.height_px;
    }
    return {std::ceil(width_px) + 2 * kPadding_px, std::ceil(height_px) + 2 * kPadding_px - 6};
}

void paintLegend(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                 const MapStyle& style, const SymbolScale& scale)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    const QFontMetricsF small(theme.small());
    paintPanel(painter, rect, theme);
    QPointF at = rect.topLeft() + QPointF(kPadding_px, kPadding_px - 3);
    painter.setPen(theme.text);
    painter.setFont(theme.small());
    painter.drawText(at + QPointF(0, small.ascent()), MapLegend::tr("Uncertainty σ"));
    at.ry() += 18;

    const double ring_px = largestRing_px(picture, scale);
    const QRectF bar(at.x(), at.y() + 2 * ring_px + 8, kBarWidth_px, kBarHeight_px);
    paintSigmaBar(painter, bar, picture, theme);
    const auto number = [&](double x, double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRectF(x - 40, y, 80, 14), Qt::AlignCenter, text);
    };
    const double variance_y = bar.bottom() + 4;
    const double root_y = variance_y + 14;
    for (const double tick_m2 : sigmaTicks(picture.sigmaFull_m2)) {
        const double x = bar.left() + bar.width() * tick_m2 / picture.sigmaFull_m2;
        drawIceberg(painter, {x, at.y() + ring_px},
                    {.radius_px = kSymbolRadius_px,
                     .ring_px = scale.ringRadius_px(kSymbolRadius_px, tick_m2),
                     .sigma = theme.sigma.colour(tick_m2, picture.sigmaFull_m2)},
                    theme);
        painter.setFont(theme.small());
        number(x, variance_y, tickText(tick_m2, style.locale), theme.text);
        number(x, root_y, significantText(std::sqrt(tick_m2), 2, style.locale), theme.mutedText);
    }
    const auto label = [&](double x, double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QPointF(x, y + 11), text);
    };
    label(bar.right() + 16, variance_y, u"m²"_s, theme.text);
    label(bar.right() + 16, root_y, u"m"_s, theme.mutedText);
    label(bar.left(), variance_y, u"σ"_s, theme.text);
    label(bar.left(), root_y, u"√σ"_s, theme.mutedText);

    at.ry() += sigmaHeight_px(picture, scale) - 18 + 4;
    for (const LegendRow& row : rowsOf(picture, style, scale)) {
        {
            const PainterState swatchOnly(painter);
            row.draw(painter, QRectF(at.x(), at.y(), kSwatch_px, row.height_px));
        }
        painter.setPen(theme.text);
        painter.drawText(QRectF(at.x() + kSwatch_px + 8, at.y(), rect.width(), row.height_px),
                         static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignVCenter),
                         row.text);
        at.ry() += row.height_px;
    }
}

} // namespace berg
