#include "widgets/charts/figure_painter.h"

#include "core/io/figure/mark_outline.h"
#include "widgets/charts/solve_time_chart.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/palette.h"
#include "widgets/words/policy_words.h"

#include <QFontMetricsF>
#include <QPolygonF>

#include <cmath>
#include <numbers>

namespace berg {
namespace {

constexpr double kGap_px = 1.2; // rim around a mark in the background colour
constexpr double kOutline_px = 1.6;
constexpr double kTint = 0.12; // strength of a hatched area between the lines
constexpr double kHatch = 0.5; // strength of the hatch lines

QFont fontOf(FigureFont font, const Theme& theme)
{
    if (font == FigureFont::Body)
        return theme.body();
    QFont chosen = font == FigureFont::Strong ? theme.strong() : theme.small();
    chosen.setBold(font != FigureFont::Small);
    return chosen;
}

QColor solverColour(double place, const Theme& theme)
{
    return benchmarkSolverColour(
        place < 0 ? std::nullopt
                  : std::optional(kBenchmarkSolverNames.at(static_cast<std::size_t>(place)).value),
        theme);
}

QColor fullColour(const Ink& ink, const Theme& theme)
{
    switch (ink.of) {
    case InkOf::Text:
        return theme.text;
    case InkOf::Muted:
        return theme.mutedText;
    case InkOf::Axis:
        return theme.chartAxis;
    case InkOf::Grid:
        return theme.chartGrid;
    case InkOf::Uav:
        return uavColour(theme, static_cast<int>(ink.value));
    case InkOf::Plan:
        return theme.plan;
    case InkOf::Accumulated:
        return theme.accumulated;
    case InkOf::Momentary:
        return theme.momentary;
    case InkOf::Comparison:
        return theme.comparison;
    case InkOf::Policy:
        return policyColour(static_cast<PolicyKind>(static_cast<int>(ink.value)), theme);
    case InkOf::Solver:
        return solverColour(ink.value, theme);
    case InkOf::Sigma:
        return theme.sigma.at(ink.value);
    case InkOf::Caution:
        return theme.warning;
    case InkOf::Danger:
        return theme.alarm;
    }
    return {};
}

QPolygonF polygonOf(const std::vector<Pixel>& points)
{
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(points.size()));
    for (const Pixel& point : points)
        polygon << toQt(point);
    return polygon;
}

void paintLine(QPainter& painter, const DrawnLine& line, const Theme& theme)
{
    const Qt::PenCapStyle cap = line.width_px < 2 ? Qt::FlatCap : Qt::RoundCap;
    QPen pen(inkColour(line.ink, theme), line.width_px, Qt::SolidLine, cap, Qt::RoundJoin);
    if (!line.dash_px.empty()) {
        QList<qreal> dashes; // in units of the pen width
        for (const double dash_px : line.dash_px)
            dashes << dash_px / line.width_px;
        pen.setDashPattern(dashes);
    }
    painter.setPen(pen);
    painter.drawPolyline(polygonOf(line.points));
}

void paintArea(QPainter& painter, const DrawnArea& area, const Theme& theme)
{
    const QPolygonF outline = polygonOf(area.outline);
    Ink ink = area.of.ink;
    const auto fill = [&](double strength, Qt::BrushStyle style) {
        ink.strength = strength;
        QColor colour = inkColour(ink, theme);
        colour.setAlphaF(static_cast<float>(area.of.opacity));
        painter.setBrush(QBrush(colour, style));
        painter.drawPolygon(outline);
    };
    painter.setPen(Qt::NoPen);
    fill(area.of.isHatched ? kTint : ink.strength, Qt::SolidPattern);
    if (area.of.isHatched)
        fill(kHatch, Qt::BDiagPattern);
}

void paintText(QPainter& painter, const DrawnText& text, const Theme& theme)
{
    const bool isLong = text.font == FigureFont::Body; // the message of an empty figure
    painter.setFont(fontOf(text.font, theme));
    painter.setPen(inkColour(text.ink, theme));
    const Qt::AlignmentFlag align = text.align == TextAlign::Left    ? Qt::AlignLeft
                                    : text.align == TextAlign::Right ? Qt::AlignRight
                                                                     : Qt::AlignHCenter;
    painter.drawText(toQt(text.rect),
                     static_cast<int>(align | Qt::AlignVCenter) |
                         (isLong ? Qt::TextWordWrap : Qt::TextDontClip),
                     QString::fromStdString(text.text));
}

} // namespace

QColor inkColour(const Ink& ink, const Theme& theme)
{
    const QColor colour = fullColour(ink, theme);
    return ink.strength < 1 ? mixed(theme.chart, colour, ink.strength) : colour;
}

FigureFonts figureFonts(const Theme& theme)
{
    std::vector<QFontMetricsF> all;
    for (const FigureFont font :
         {FigureFont::Small, FigureFont::SmallBold, FigureFont::Strong, FigureFont::Body})
        all.emplace_back(fontOf(font, theme));
    const auto metrics = [all = std::move(all)](FigureFont font) -> const QFontMetricsF& {
        return all[static_cast<std::size_t>(font)];
    };
    return {.width_px =
                [metrics](const std::string& text, FigureFont font) {
                    return metrics(font).horizontalAdvance(QString::fromStdString(text));
                },
            .elided =
                [metrics](const std::string& text, FigureFont font, double room_px) {
                    return metrics(font)
                        .elidedText(QString::fromStdString(text), Qt::ElideRight, room_px)
                        .toStdString();
                }};
}

QPointF toQt(const Pixel& pixel)
{
    return {pixel.x, pixel.y};
}

QRectF toQt(const PixelRect& rect)
{
    return {rect.left, rect.top, rect.width(), rect.height()};
}

void paintMark(QPainter& painter, const QPointF& at, const PlotMark& mark, const Theme& theme)
{
    const bool isRing = mark.shape == MarkShape::Ring;
    const QColor colour = inkColour(mark.ink, theme);
    painter.setPen(mark.isHollow || isRing ? QPen(colour, kOutline_px)
                                           : QPen(theme.chart, kGap_px));
    painter.setBrush(isRing ? QBrush(Qt::NoBrush) : mark.isHollow ? theme.chart : colour);
    if (const std::vector<Pixel> outline = markOutline(mark, {at.x(), at.y()}); !outline.empty())
        painter.drawPolygon(polygonOf(outline));
    else
        painter.drawEllipse(at, mark.radius_px, mark.radius_px);
}

void paintDrawing(QPainter& painter, const Drawing& drawing, const Theme& theme)
{
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const DrawnLine& line : drawing.grid)
        paintLine(painter, line, theme);
    for (const DrawnArea& area : drawing.areas)
        paintArea(painter, area, theme);
    painter.setBrush(Qt::NoBrush);
    for (const DrawnLine& line : drawing.lines)
        paintLine(painter, line, theme);
    for (const DrawnMark& mark : drawing.marks)
        paintMark(painter, toQt(mark.at), mark.of, theme);
    paintFrame(painter, drawing, theme);
}

void paintFrame(QPainter& painter, const Drawing& drawing, const Theme& theme)
{
    const PainterState saved(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (!drawing.grid.empty()) // the last grid line is the axis
        paintLine(painter, drawing.grid.back(), theme);
    for (const DrawnLine& line : drawing.over)
        paintLine(painter, line, theme);
    for (const DrawnText& text : drawing.texts)
        paintText(painter, text, theme);
}

} // namespace berg
