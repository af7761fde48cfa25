#include "core/tracking/position_error.h"
#include "widgets/map/paint/map_legend_rows.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr double kPadding_px = 12;
constexpr double kBarHeight_px = 9;
constexpr double kSymbolRadius_px = 8;
constexpr double kCompactSwatch_px = 26;
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

double largestRing_px(const MapPicture& picture, const SymbolScale& scale)
{
    return scale.ringRadius_px(kSymbolRadius_px, picture.sigmaFull_m2);
}

/** "5" or "0.25": as many digits as the round tick needs. */
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

/** Vertical positions in the block that explains sigma, from its top. */
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

/** Draws sample icebergs of round sigmas along the bar. */
void paintSamples(QPainter& painter, const QPointF& from, const MapPicture& picture,
                  const MapStyle& style, const SymbolScale& scale)
{
    const Theme& theme = style.theme;
    for (const double tick_m2 : sigmaTicks(picture.sigmaFull_m2))
        drawIceberg(
            painter, from + QPointF(kLegendBar_px * tick_m2 / picture.sigmaFull_m2, 0),
            {.radius_px = kSymbolRadius_px,
             .ring_px = scale.showsRings ? scale.ringRadius_px(kSymbolRadius_px, tick_m2) : 0,
             .ringOpacity = style.layers.opacity(MapLayer::Rings),
             .sigma = theme.sigma.colour(tick_m2, picture.sigmaFull_m2)},
            theme);
}

double widestNumber_px(const MapPicture& picture, const MapStyle& style)
{
    return QFontMetricsF(style.theme.small())
        .horizontalAdvance(tickText(picture.sigmaFull_m2, style.locale));
}

/** Distance of the unit from the end of the bar, on which the last number is centred. */
double unitAfter_px(double number_px)
{
    return std::max(16.0, number_px / 2 + 5);
}

/**
 * Draws the sigmas and the 95 % radii below the bar in two lines. If numbers are wide, every other
 * one is left out, but never the last.
 */
void paintSigmaNumbers(QPainter& painter, const QPointF& from, const MapPicture& picture,
                       const MapStyle& style)
{
    const Theme& theme = style.theme;
    const bool isSigmaFirst = shownUnits().uncertainty == UncertaintyForm::Sigma;
    const double sigma_y = from.y() + (isSigmaFirst ? 0 : kNumber_px);
    const double radius_y = from.y() + (isSigmaFirst ? kNumber_px : 0);
    const QColor& sigmaInk = isSigmaFirst ? theme.text : theme.mutedText;
    const QColor& radiusInk = isSigmaFirst ? theme.mutedText : theme.text;
    const ShownUnit radius = radius95Unit(picture.sigmaFull_m2);
    const auto number = [&](double x, double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRectF(x - 40, y, 80, kNumber_px), Qt::AlignCenter, text);
    };
    const auto label = [&](double x, double y, const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QPointF(x, y + 11), text);
    };
    painter.setFont(theme.small());
    const std::vector<double> ticks_m2 = sigmaTicks(picture.sigmaFull_m2);
    const double widest_px = widestNumber_px(picture, style);
    const bool isTight = widest_px + 4 > kLegendBar_px / static_cast<double>(ticks_m2.size());
    for (std::size_t i = ticks_m2.size(); i-- > 0;) {
        if (isTight && (ticks_m2.size() - i) % 2 == 0)
            continue;
        const double x = from.x() + kLegendBar_px * ticks_m2[i] / picture.sigmaFull_m2;
        number(x, sigma_y, tickText(ticks_m2[i], style.locale), sigmaInk);
        number(x, radius_y,
               significantText(radius.fromSi(radius95_m(ticks_m2[i])), 2, style.locale), radiusInk);
    }
    const double unit_x = from.x() + kLegendBar_px + unitAfter_px(widest_px);
    label(unit_x, sigma_y, u"m²"_s, sigmaInk);
    label(unit_x, radius_y, radius.name, radiusInk);
    label(from.x(), sigma_y, u"σ"_s, sigmaInk);
    label(from.x(), radius_y, u"95 %"_s, radiusInk);
}

void paintSigma(QPainter& painter, const QPointF& at, const SigmaBlock& block,
                const MapPicture& picture, const MapStyle& style, const SymbolScale& scale)
{
    paintSigmaBar(painter, QRectF(at.x(), at.y() + block.bar_y, kLegendBar_px, kBarHeight_px),
                  picture, style.theme);
    paintSamples(painter, at + QPointF(0, block.samples_y), picture, style, scale);
    paintSigmaNumbers(painter, at + QPointF(0, block.numbers_y), picture, style);
}

/** Symbols with their texts, in one or two columns. */
class SignGrid
{
public:
    SignGrid(std::vector<LegendRow> rows, const QFontMetricsF& metrics, bool compact)
        : m_rows(std::move(rows))
        , m_columns(compact ? 2 : 1)
        , m_swatch_px(compact ? kCompactSwatch_px : kLegendSwatch_px)
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
    // Few enough ticks to keep the sample rings separate.
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
    const SignGrid signs(legendRows(picture, style, scale), QFontMetricsF(style.theme.small()),
                         compact);
    const double unit_px = kLegendUnits_px - 16;
    const double units_px = unitAfter_px(widestNumber_px(picture, style)) + unit_px;
    const double width_px = std::max(kLegendBar_px + units_px, signs.width_px());
    const LegendUavs uavs(picture, style.theme, width_px);
    return {std::ceil(width_px) + 2 * kPadding_px,
            std::ceil(sigma.height_px + kGap_px + uavs.height_px() + signs.height_px()) +
                2 * kPadding_px - 6};
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
    const LegendUavs uavs(picture, theme, rect.width() - 2 * kPadding_px);
    const double uavs_y = sigma.height_px + kGap_px;
    uavs.paint(painter, at + QPointF(0, uavs_y), theme);
    const SignGrid signs(legendRows(picture, style, scale), QFontMetricsF(theme.small()), compact);
    signs.paint(painter, at + QPointF(0, uavs_y + uavs.height_px()), theme);
}

} // namespace berg
