#include "widgets/map/paint/wind_panel.h"

#include "core/base/angles.h"
#include "core/scenario/limits.h"
#include "widgets/document/wind.h"
#include "widgets/map/paint/map_marks.h"
#include "widgets/map/paint/map_symbols.h"
#include "widgets/theme/painter_state.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct WindText
{
    Q_DECLARE_TR_FUNCTIONS(WindText)
};

constexpr double kDial_px = 34; // radius
constexpr double kPadding_px = 10;
constexpr double kTextGap_px = 5;    // gap below the dial
constexpr double kCurrentGap_px = 4; // gap above the text of the current
constexpr double kCurrentArrow_px = 16;
constexpr double kTick_px = 4;
constexpr double kGrip_px = 5; // gap between the arrow head and the handle at its tip
constexpr double kStep_mps = 0.5;
constexpr double kStep_deg = 5;

/** Two lines of text; one in calm. */
QStringList windLines(const MapAir& air, const QLocale& locale)
{
    if (air.wind_mps.isZero(0))
        return {WindText::tr("No wind")};
    const QString speed = fixedSpeedText(air.wind_mps.norm(), 1, locale);
    const QString from = bearingText(-air.wind_mps);
    return (isStrong(air) ? WindText::tr("Wind %1\nfrom %2, strong")
                          : WindText::tr("Wind %1\nfrom %2"))
        .arg(speed, from)
        .split(u'\n');
}

/** Two lines of text; empty without a current. */
QStringList currentLines(const MapAir& air, const QLocale& locale)
{
    if (air.current_mps.isZero(0))
        return {};
    return WindText::tr("Current %1\ntowards %2")
        .arg(fixedSpeedText(air.current_mps.norm(), 2, locale), bearingText(air.current_mps))
        .split(u'\n');
}

/** Origin of the wind in a word; empty without a forecast. */
QStringList originLines(const MapAir& air)
{
    if (air.forecast.isEmpty())
        return {};
    return {air.isReported ? WindText::tr("reported") : WindText::tr("forecast")};
}

double widest_px(const QStringList& lines, const QFontMetricsF& metrics)
{
    double width_px = 0;
    for (const QString& line : lines)
        width_px = std::max(width_px, tabularWidth(metrics, line));
    return width_px;
}

/** Draws lines of text centred between `left` and `right`, from `top` down. */
void drawLines(QPainter& painter, const QStringList& lines, double left, double right, double top)
{
    const QFontMetricsF metrics(painter.font());
    for (const QString& line : lines) {
        const double x = (left + right - tabularWidth(metrics, line)) / 2;
        drawTabular(painter, {x, top + metrics.ascent()}, line);
        top += metrics.height();
    }
}

QPointF dialCentre(const QRectF& panel)
{
    return {panel.center().x(), panel.top() + kPadding_px + kDial_px};
}

/** Screen vector on the dial of a velocity. */
QPointF onDial(const Point& velocity_mps, const MapAir& air)
{
    // A forecast may exceed the airspeed.
    const double full_mps = std::max(air.limit_mps, velocity_mps.norm());
    return QPointF(velocity_mps.x(), -velocity_mps.y()) * (kDial_px / full_mps);
}

void paintDial(QPainter& painter, const QPointF& centre, const MapStyle& style)
{
    const Theme& theme = style.theme;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.mutedText, 1));
    painter.drawEllipse(centre, kDial_px, kDial_px);
    for (const QPointF& direction : {QPointF(0, -1), QPointF(1, 0), QPointF(0, 1), QPointF(-1, 0)})
        painter.drawLine(centre + direction * (kDial_px - kTick_px), centre + direction * kDial_px);
    painter.setPen(QPen(theme.graticuleText, 1, Qt::DashLine));
    painter.drawEllipse(centre, kStrongWindShare * kDial_px, kStrongWindShare * kDial_px);
}

void paintArrow(QPainter& painter, const QPointF& centre, const MapAir& air, const MapStyle& style)
{
    const QPointF arrow = onDial(air.wind_mps, air);
    const double length_px = QLineF({0, 0}, arrow).length();
    const double short_px = style.isLive ? kGrip_px : 0;
    if (length_px <= short_px / 2)
        return;
    const QColor ink = isStrong(air) ? style.theme.uav : style.theme.ink;
    drawArrow(painter, {centre - arrow, centre + arrow * (1 - short_px / length_px)},
              QPen(ink, 2.2), 9);
}

} // namespace

bool isStrong(const MapAir& air)
{
    return air.wind_mps.norm() >= kStrongWindShare * air.limit_mps;
}

QSizeF windPanelSize(const MapAir& air, const MapStyle& style)
{
    const bool isStill = air.wind_mps.isZero(0) && air.current_mps.isZero(0);
    if (air.limit_mps <= 0 || (isStill && !style.isLive))
        return {};
    const QFontMetricsF metrics(style.theme.small());
    // Uses the longest texts, so that the panel keeps its size while the wind is dragged.
    const MapAir fastest{.wind_mps = {air.limit_mps, 0}, .limit_mps = air.limit_mps};
    const double wind_px = widest_px(windLines(fastest, style.locale), metrics);
    const QStringList origin = originLines(air);
    QSizeF size(std::max({2 * kDial_px, wind_px, widest_px(origin, metrics)}),
                2 * kDial_px + kTextGap_px +
                    (2 + static_cast<double>(origin.size())) * metrics.height());
    if (const QStringList current = currentLines(air, style.locale); !current.isEmpty())
        size = {
            std::max(size.width(), kCurrentArrow_px + kTextGap_px + widest_px(current, metrics)),
            size.height() + kCurrentGap_px + 2 * metrics.height()};
    return QSizeF(std::ceil(size.width()), std::ceil(size.height())) +
           QSizeF(2 * kPadding_px, 2 * kPadding_px - 3);
}

void paintWindPanel(QPainter& painter, const QRectF& rect, const MapAir& air, const MapStyle& style)
{
    const PainterState saved(painter);
    const Theme& theme = style.theme;
    paintPanel(painter, rect, theme);
    const QPointF centre = dialCentre(rect);
    paintDial(painter, centre, style);
    paintArrow(painter, centre, air, style);

    painter.setFont(theme.small());
    const double line_px = QFontMetricsF(theme.small()).height();
    const double left = rect.left() + kPadding_px;
    const double right = rect.right() - kPadding_px;
    double top = centre.y() + kDial_px + kTextGap_px;
    painter.setPen(theme.text);
    drawLines(painter, windLines(air, style.locale), left, right, top);
    top += 2 * line_px;
    painter.setPen(theme.mutedText);
    const QStringList origin = originLines(air);
    drawLines(painter, origin, left, right, top);
    top += static_cast<double>(origin.size()) * line_px + kCurrentGap_px;
    const QStringList current = currentLines(air, style.locale);
    if (current.isEmpty())
        return;
    const QPointF middle(left + kCurrentArrow_px / 2, top + line_px);
    const QPointF half = QPointF(air.current_mps.x(), -air.current_mps.y()) *
                         (kCurrentArrow_px / 2 / air.current_mps.norm());
    drawArrow(painter, {middle - half, middle + half}, QPen(theme.plan, 1.6), 7);
    painter.setPen(theme.text);
    drawLines(painter, current, left + kCurrentArrow_px + kTextGap_px, right, top);
}

QPointF windTip(const QRectF& panel, const MapAir& air)
{
    return dialCentre(panel) + onDial(air.wind_mps, air);
}

Point windAtTip(const QRectF& panel, const MapAir& air, const QPointF& tip, bool inLargeSteps)
{
    const QPointF path_px = tip - dialCentre(panel);
    const Point towards(path_px.x(), -path_px.y());
    const double step_mps =
        shownUnits().speed == SpeedUnit::Knots ? speedUnit().toSi(1) : kStep_mps;
    const double wanted_mps =
        std::round(towards.norm() * air.limit_mps / kDial_px / step_mps) * step_mps;
    if (wanted_mps <= 0)
        return Point::Zero();
    const double step_deg = inLargeSteps ? kDirectionStep_deg : kStep_deg;
    return windOf(std::min(wanted_mps, fastestWind_mps(air.limit_mps, step_mps)),
                  std::round(windFrom_deg(towards) / step_deg) * step_deg);
}

QString windText(const MapAir& air, const QLocale& locale)
{
    return windLines(air, locale).join(u' ');
}

QString windToolTip(const MapAir& air, const QLocale& locale)
{
    QStringList lines{windText(air, locale)};
    if (air.gust_mps)
        lines << WindText::tr("Gusts %1").arg(fixedSpeedText(*air.gust_mps, 1, locale));
    if (const QStringList current = currentLines(air, locale); !current.isEmpty())
        lines << current.join(u' ');
    if (!air.forecast.isEmpty())
        lines << air.forecast + u'.';
    if (air.isReported)
        lines << WindText::tr("UAVs fly in the wind that the crew has reported, and icebergs drift "
                              "in the forecast.");
    if (air.isFixed)
        lines << WindText::tr("Remove the forecast in the Inspector to set the wind yourself.");
    lines << WindText::tr("The arrow points downwind. The ring is the airspeed of the slowest UAV "
                          "(%1); beyond the dashed ring UAVs make little headway.")
                 .arg(speedText(air.limit_mps, locale));
    if (!air.wind_mps.isZero(0))
        lines << WindText::tr(
            "The small aircraft in the middle of a leg shows the heading flown there.");
    return lines.join(u'\n');
}

} // namespace berg
