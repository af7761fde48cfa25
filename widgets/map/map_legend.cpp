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
constexpr double kCompactSwatch_px = 26;
constexpr double kRow_px = 18;
constexpr double kSymbolRow_px = 26;
constexpr double kHeading_px = 18;
constexpr double kNumber_px = 14;
constexpr double kGap_px = 8;
constexpr double kColumnGap_px = 10;
constexpr double kTextGap_px = 8;
constexpr int kGradientStops = 24;

struct MapLegend
{
    Q_DECLARE_TR_FUNCTIONS(MapLegend)
};

/** One row: a small drawing and what it means. */
struct LegendRow
{
    QString text;
    QString word;                                       ///< the same where there is little room
    std::function<void(QPainter&, const QRectF&)> draw; ///< into a swatch
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
    const QRectF box(swatch.left() + 2, swatch.center().y() - 6, swatch.width() - 4, 12);
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
        rows.push_back({MapLegend::tr("In view now: σ is 0"), MapLegend::tr("In view"),
                        [&](QPainter& p, const QRectF& r) {
                            drawIceberg(p, r.center(), {.radius_px = 6, .inView = true}, theme);
                        },
                        kSymbolRow_px});
    const bool anyLater =
        std::any_of(picture.icebergs.begin(), picture.icebergs.end(),
                    [](const MapIceberg& iceberg) { return iceberg.appears_s > 0; });
    if (anyLater)
        rows.push_back(
            {MapLegend::tr("Still to come, with its time"), MapLegend::tr("To come"),
             [&](QPainter& p, const QRectF& r) {
                 drawIceberg(
                     p, r.center(),
                     {.radius_px = 6, .ring_px = 10, .sigma = theme.sigma.at(0.3), .later = true},
                     theme);
             },
             kSymbolRow_px});
    if (!picture.plan.empty())
        rows.push_back({MapLegend::tr("Plan, next leg thicker"), MapLegend::tr("Plan"),
                        [&](QPainter& p, const QRectF& r) { drawPlanSwatch(p, r, theme); }});
    if (!picture.planWays.empty())
        rows.push_back({MapLegend::tr("Point aimed at"), MapLegend::tr("Aim point"),
                        [&](QPainter& p, const QRectF& r) { drawAim(p, r.center(), theme); }});
    if (!picture.formerPlan.empty())
        rows.push_back({MapLegend::tr("Plan before the change"), MapLegend::tr("Former plan"),
                        [&](QPainter& p, const QRectF& r) { drawFormerSwatch(p, r, theme); }});
    if (picture.track.size() > 1)
        rows.push_back({MapLegend::tr("Flown, older parts fainter"), MapLegend::tr("Flown"),
                        [&](QPainter& p, const QRectF& r) { drawTrackSwatch(p, r, theme); }});
    if (picture.comparisonTrack.size() > 1) {
        const QString text = MapLegend::tr("Compared: %1").arg(picture.comparisonName);
        const QFontMetricsF small(theme.small());
        rows.push_back({small.elidedText(text, Qt::ElideRight, kBarWidth_px + kUnitColumn_px),
                        small.elidedText(picture.comparisonName, Qt::ElideRight, kBarWidth_px / 2),
                        [&](QPainter& p, const QRectF& r) { drawComparisonSwatch(p, r, theme); }});
    }
    if (picture.uav)
        rows.push_back({MapLegend::tr("Field of view"), MapLegend::tr("Field of view"),
                        [&](QPainter& p, const QRectF& r) { drawFieldSwatch(p, r, theme); }});
    if (picture.showsSwept())
        rows.push_back({MapLegend::tr("Seen so far"), MapLegend::tr("Seen so far"),
                        [&](QPainter& p, const QRectF& r) { drawSweptSwatch(p, r, theme); }});
    if (scale.driftTime_s > 0)
        rows.push_back(
            {MapLegend::tr("Drift in %1").arg(durationText(scale.driftTime_s, style.locale)),
             MapLegend::tr("Drift in %1").arg(durationText(scale.driftTime_s, style.locale)),
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

/** Where the parts that explain sigma are, from the top of the block. */
struct SigmaBlock
{
    double samples_y = 0; ///< centres of the sample rings
    double bar_y = 0;
    double numbers_y = 0;
    double height_px = 0;
};

SigmaBlock sigmaBlock(const MapPicture& picture, const SymbolScale& scale, bool compact)
{
    const double ring_px = largestRing_px(picture, scale);
    SigmaBlock block{.samples_y = (compact ? 0 : kHeading_px) + ring_px};
    block.bar_y = compact ? ring_px - kBarHeight_px / 2 : block.samples_y + ring_px + kGap_px;
    block.numbers_y = compact ? 2 * ring_px + 2 : block.bar_y + kBarHeight_px + 4;
    block.height_px = block.numbers_y + 2 * kNumber_px;
    return block;
}

void paintSigma(QPainter& painter, const QPointF& at, const SigmaBlock& block,
                const MapPicture& picture, const MapStyle& style, const SymbolScale& scale)
{
    const Theme& theme = style.theme;
    const QRectF bar(at.x(), at.y() + block.bar_y, kBarWidth_px, kBarHeight_px);
    paintSigmaBar(painter, bar, picture, theme);
    const double variance_y = at.y() + block.numbers_y;
    const double root_y = variance_y + kNumber_px;
    const auto number = [&](double x, double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRectF(x - 40, y, 80, kNumber_px), Qt::AlignCenter, text);
    };
    for (const double tick_m2 : sigmaTicks(picture.sigmaFull_m2)) {
        const double x = bar.left() + bar.width() * tick_m2 / picture.sigmaFull_m2;
        drawIceberg(painter, {x, at.y() + block.samples_y},
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
}

/** Signs and their texts below each other, or in two columns. */
class SignGrid
{
public:
    SignGrid(std::vector<LegendRow> rows, const QFontMetricsF& metrics, bool compact)
        : m_rows(std::move(rows))
        , m_columns(compact ? 2 : 1)
        , m_swatch_px(compact ? kCompactSwatch_px : kSwatch_px)
    {
        if (compact)
            for (LegendRow& row : m_rows)
                row.text = row.word;
        for (const LegendRow& row : m_rows)
            m_column_px = std::max(m_column_px,
                                   m_swatch_px + kTextGap_px + metrics.horizontalAdvance(row.text));
    }

    [[nodiscard]] double width_px() const
    {
        return static_cast<double>(m_columns) * m_column_px +
               static_cast<double>(m_columns - 1) * kColumnGap_px;
    }

    [[nodiscard]] double height_px() const
    {
        double height_px = 0;
        for (std::size_t i = 0; i < m_rows.size(); i += m_columns)
            height_px += lineHeight_px(i);
        return height_px;
    }

    void paint(QPainter& painter, QPointF at, const Theme& theme) const
    {
        for (std::size_t i = 0; i < m_rows.size(); i += m_columns) {
            const double line_px = lineHeight_px(i);
            for (std::size_t k = i; k < std::min(i + m_columns, m_rows.size()); ++k)
                paintRow(painter,
                         QRectF(at.x() + static_cast<double>(k - i) * (m_column_px + kColumnGap_px),
                                at.y(), m_column_px, line_px),
                         m_rows[k], theme);
            at.ry() += line_px;
        }
    }

private:
    [[nodiscard]] double lineHeight_px(std::size_t first) const
    {
        double height_px = 0;
        for (std::size_t k = first; k < std::min(first + m_columns, m_rows.size()); ++k)
            height_px = std::max(height_px, m_rows[k].height_px);
        return height_px;
    }

    void paintRow(QPainter& painter, const QRectF& cell, const LegendRow& row,
                  const Theme& theme) const
    {
        {
            const PainterState swatchOnly(painter);
            row.draw(painter, QRectF(cell.left(), cell.top(), m_swatch_px, cell.height()));
        }
        painter.setFont(theme.small());
        painter.setPen(theme.text);
        painter.drawText(cell.adjusted(m_swatch_px + kTextGap_px, 0, kTextGap_px, 0),
                         static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter), row.text);
    }

    std::vector<LegendRow> m_rows;
    std::size_t m_columns;
    double m_swatch_px;
    double m_column_px = 0;
};

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

QSizeF legendSize(const MapPicture& picture, const MapStyle& style, const SymbolScale& scale,
                  bool compact)
{
    if (picture.icebergs.empty())
        return {};
    const SigmaBlock sigma = sigmaBlock(picture, scale, compact);
    const SignGrid signs(rowsOf(picture, style, scale), QFontMetricsF(style.theme.small()),
                         compact);
    const double width_px = std::max(kBarWidth_px + kUnitColumn_px, signs.width_px());
    return {std::ceil(width_px) + 2 * kPadding_px,
            std::ceil(sigma.height_px + kGap_px + signs.height_px()) + 2 * kPadding_px - 6};
}

void paintLegend(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                 const MapStyle& style, const SymbolScale& scale, bool compact)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    paintPanel(painter, rect, theme);
    painter.setFont(theme.small());
    const QPointF at = rect.topLeft() + QPointF(kPadding_px, kPadding_px - 3);
    const SigmaBlock sigma = sigmaBlock(picture, scale, compact);
    if (!compact) {
        painter.setPen(theme.text);
        painter.drawText(at + QPointF(0, QFontMetricsF(theme.small()).ascent()),
                         MapLegend::tr("Uncertainty σ"));
    }
    paintSigma(painter, at, sigma, picture, style, scale);
    const SignGrid signs(rowsOf(picture, style, scale), QFontMetricsF(theme.small()), compact);
    signs.paint(painter, at + QPointF(0, sigma.height_px + kGap_px), theme);
}

} // namespace berg
