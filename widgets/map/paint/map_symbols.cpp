#include "widgets/map/paint/map_symbols.h"

#include "core/base/angles.h"
#include "widgets/theme/painter_state.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {
namespace {

/** Side view of an iceberg in units of its half width; y grows downwards. */
struct IceForm
{
    QPolygonF outline;
    QPolygonF shade; ///< the facet turned away from the light
};

const std::array<IceForm, 3>& iceForms()
{
    static const std::array<IceForm, 3> forms = {{
        // Pinnacle left of the middle.
        {QPolygonF{{-1, 0.42},
                   {-0.72, -0.22},
                   {-0.28, -0.95},
                   {0.22, -0.42},
                   {0.55, -0.6},
                   {1, 0.38},
                   {0.48, 0.8},
                   {-0.55, 0.78}},
         QPolygonF{{-0.28, -0.95},
                   {0.22, -0.42},
                   {0.55, -0.6},
                   {1, 0.38},
                   {0.48, 0.8},
                   {0.02, 0.79},
                   {0.1, 0.1}}},
        // Wedge.
        {QPolygonF{{-1, 0.5},
                   {-0.55, -0.1},
                   {0.3, -0.95},
                   {0.78, -0.3},
                   {1, 0.45},
                   {0.35, 0.82},
                   {-0.6, 0.8}},
         QPolygonF{{0.3, -0.95}, {0.78, -0.3}, {1, 0.45}, {0.35, 0.82}, {0.2, 0.15}}},
        // Blocky, with a step.
        {QPolygonF{{-1, 0.4},
                   {-0.85, -0.38},
                   {-0.2, -0.85},
                   {0.42, -0.78},
                   {0.62, -0.15},
                   {1, 0.02},
                   {0.86, 0.66},
                   {-0.35, 0.84}},
         QPolygonF{
             {0.42, -0.78}, {0.62, -0.15}, {1, 0.02}, {0.86, 0.66}, {-0.02, 0.81}, {0.16, 0.05}}},
    }};
    return forms;
}

/** Four corner marks of a square round the symbol. */
void drawBrackets(QPainter& painter, const QPointF& centre, double half_px, const QColor& colour)
{
    painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const double arm_px = 0.45 * half_px;
    for (const double sx : {-1.0, 1.0}) {
        for (const double sy : {-1.0, 1.0}) {
            const QPointF corner = centre + QPointF(sx * half_px, sy * half_px);
            painter.drawPolyline(QPolygonF{corner - QPointF(sx * arm_px, 0), corner,
                                           corner - QPointF(0, sy * arm_px)});
        }
    }
}

/** Form of an iceberg in screen coordinates: many SVG readers lack pens that do not scale. */
IceForm formOf(const QPointF& centre, const IcebergStyle& style)
{
    const bool isMirrored = (style.variant / iceForms().size()) % 2 == 1;
    const QTransform place =
        QTransform::fromTranslate(centre.x(), centre.y())
            .scale(isMirrored ? -style.radius_px : style.radius_px, style.radius_px);
    const IceForm& form = iceForms()[style.variant % iceForms().size()];
    return {place.map(form.outline), place.map(form.shade)};
}

/** Draws an iceberg whose place is unknown. */
void drawLostForm(QPainter& painter, const QPointF& centre, const IcebergStyle& style,
                  const Theme& theme)
{
    QPen edge(theme.ink, 1.4, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    edge.setDashPattern({2.5, 2});
    painter.setPen(edge);
    painter.setBrush(theme.sea);
    painter.drawPolygon(formOf(centre, style).outline);
    QFont font = theme.strong();
    font.setPixelSize(static_cast<int>(std::lround(std::max(11.0, 1.5 * style.radius_px))));
    painter.setFont(font);
    const QRectF box(centre.x() - 20, centre.y() - 20, 40, 40);
    drawHaloText(painter, box, Qt::AlignCenter,
                 QString(style.status == TrackStatus::Lost ? u'?' : u'×'), theme.text, theme.sea);
}

double widestDigit(const QFontMetricsF& metrics)
{
    double widest = 0;
    for (char16_t digit = u'0'; digit <= u'9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QChar(digit)));
    return widest;
}

bool isPaper(const QPainter& painter)
{
    const QPaintEngine::Type type = painter.paintEngine()->type();
    return type == QPaintEngine::Pdf || type == QPaintEngine::SVG;
}

/** Halo for PDF and SVG as one outline, so that the text is searchable and copied only once. */
void drawOutline(QPainter& painter, const QRectF& box, const QString& text, const QColor& halo)
{
    QPainterPath outline;
    outline.addText(box.left(), box.top() + QFontMetricsF(painter.font()).ascent(), painter.font(),
                    text);
    painter.strokePath(outline, QPen(halo, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

/** Halo for the screen as shifted copies, which keep the font's hinting. */
void drawCopies(QPainter& painter, const QRectF& rect, int flags, const QString& text,
                const QColor& halo)
{
    painter.setPen(halo);
    for (const QPointF& shift :
         {QPointF(-1.5, 0), QPointF(1.5, 0), QPointF(0, -1.5), QPointF(0, 1.5), QPointF(-1, -1),
          QPointF(1, -1), QPointF(-1, 1), QPointF(1, 1)})
        painter.drawText(rect.translated(shift), flags, text);
}

} // namespace

double icebergSymbolRadius_px(double radius_m)
{
    // Size classes: growlers and bergy bits, small, medium, large, very large.
    if (radius_m < 7.5)
        return 7.5;
    if (radius_m < 30)
        return 9;
    if (radius_m < 60)
        return 11;
    return radius_m < 100 ? 12.5 : 14;
}

void drawIceberg(QPainter& painter, const QPointF& centre, const IcebergStyle& style,
                 const Theme& theme)
{
    const PainterState saved(painter);
    const bool isSure = !style.later && style.status == TrackStatus::Tracked;
    const Qt::PenStyle line = isSure ? Qt::SolidLine : Qt::DashLine;
    if (style.later)
        painter.setOpacity(0.6);
    if (style.inView) {
        drawBrackets(painter, centre, style.radius_px + 5,
                     style.bracket.isValid() ? style.bracket : theme.uav);
    } else if (style.ring_px > 0) {
        QColor fill = style.sigma;
        fill.setAlphaF(0.16F);
        const double before = painter.opacity();
        painter.setOpacity(before * style.ringOpacity);
        painter.setBrush(fill);
        painter.setPen(QPen(style.sigma, 1.8, line, Qt::FlatCap));
        painter.drawEllipse(centre, style.ring_px, style.ring_px);
        painter.setOpacity(before);
    }
    if (style.status != TrackStatus::Tracked) {
        drawLostForm(painter, centre, style, theme);
        return;
    }
    const IceForm form = formOf(centre, style);
    const QColor lit = style.inView ? theme.ice : mixed(style.sigma, theme.ice, 0.3);
    const QColor shaded = style.inView ? mixed(theme.ice, theme.ink, 0.22) : style.sigma;
    QPen edge(theme.isDark ? mixed(theme.ink, theme.sea, 0.1) : theme.ink, 1.2, line);
    edge.setJoinStyle(Qt::RoundJoin);
    painter.setPen(Qt::NoPen);
    painter.setBrush(lit);
    painter.drawPolygon(form.outline);
    painter.setBrush(shaded);
    painter.drawPolygon(form.shade);
    painter.setPen(edge);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(form.outline);
}

void drawUav(QPainter& painter, const QPointF& centre, double direction_rad, const QColor& colour,
             const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(centre);
    painter.rotate(-degFromRad(direction_rad));
    const QPolygonF dart{{15, 0}, {-10, 10}, {-5.5, 0}, {-10, -10}};
    painter.setPen(QPen(theme.sea, 3.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(dart);
    painter.setPen(QPen(theme.isDark ? theme.sea : theme.ink, 1.2, Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.setBrush(colour);
    painter.drawPolygon(dart);
}

void drawAsset(QPainter& painter, const QPointF& centre, const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(centre);
    painter.setPen(QPen(theme.ink, 1.8, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(theme.panel);
    painter.drawRect(QRectF(-9, -7, 18, 7));
    painter.drawLine(QPointF(-6, 0), QPointF(-8, 9));
    painter.drawLine(QPointF(6, 0), QPointF(8, 9));
    painter.drawLine(QPointF(-7, 5), QPointF(7, 5));
    painter.drawLine(QPointF(3, -7), QPointF(3, -13));
}

void drawHome(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(centre);
    painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(theme.panel);
    painter.drawPolygon(QPolygonF{{-7.5, 8}, {-7.5, -1}, {0, -8.5}, {7.5, -1}, {7.5, 8}});
    painter.setBrush(colour);
    painter.drawRect(QRectF(-2, 2, 4, 6));
}

void drawStation(QPainter& painter, const QPointF& centre, const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(centre);
    painter.setPen(QPen(theme.ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin));
    painter.setBrush(theme.panel);
    painter.drawPolygon(QPolygonF{{0, -3}, {6, 9}, {-6, 9}});
    painter.setBrush(Qt::NoBrush);
    constexpr int kSixteenths = 16; // Qt's arcs are in sixteenths of a degree
    for (const double radius_px : {5.0, 9.0})
        for (const int from_deg : {-35, 145})
            painter.drawArc(QRectF(-radius_px, -5 - radius_px, 2 * radius_px, 2 * radius_px),
                            from_deg * kSixteenths, 70 * kSixteenths);
    painter.setBrush(theme.ink);
    painter.drawEllipse(QPointF(0, -5), 2, 2);
}

QRectF noReturnRect(const QPointF& centre)
{
    return {centre.x() - 16, centre.y() - 22, 32, 28};
}

void drawNoReturn(QPainter& painter, const QPointF& centre, const QColor& colour,
                  const Theme& theme)
{
    const PainterState saved(painter);
    painter.setPen(QPen(colour, 2));
    painter.setBrush(theme.panel);
    painter.drawEllipse(centre, 5, 5);
    painter.drawLine(centre - QPointF(8, 0), centre + QPointF(8, 0));
}

void drawTruth(QPainter& painter, const QPointF& centre, const Theme& theme)
{
    constexpr double kHalf_px = 4.5;
    const PainterState saved(painter);
    painter.translate(centre);
    painter.setPen(QPen(theme.isDark ? theme.sea : theme.ink, 1.3));
    painter.setBrush(theme.ice);
    painter.drawPolygon(QPolygonF{{kHalf_px, 0}, {0, -kHalf_px}, {-kHalf_px, 0}, {0, kHalf_px}});
}

void drawAlarm(QPainter& painter, const QPointF& centre, const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(centre);
    const QPolygonF triangle{{0, -8}, {8, 6}, {-8, 6}};
    painter.setPen(QPen(theme.sea, 3, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolygon(triangle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.uav);
    painter.drawPolygon(triangle);
    painter.setPen(QPen(theme.sea, 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0, -3), QPointF(0, 1));
    painter.drawPoint(QPointF(0, 4));
}

void drawFence(QPainter& painter, const QLineF& line, const Theme& theme)
{
    constexpr double kPost_px = 6;
    constexpr double kGap_px = 14;
    if (line.length() < 1)
        return;
    const PainterState saved(painter);
    painter.setPen(QPen(theme.ink, 1.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(line);
    const QPointF along = (line.p2() - line.p1()) / line.length();
    const QPointF right(-along.y() * kPost_px, along.x() * kPost_px);
    for (double at_px = kGap_px / 2; at_px < line.length(); at_px += kGap_px) {
        const QPointF foot = line.p1() + along * at_px;
        painter.drawLine(foot, foot + right);
    }
}

void drawPin(QPainter& painter, const QPointF& tip, const QColor& colour, const Theme& theme)
{
    const PainterState saved(painter);
    painter.translate(tip);
    QPainterPath pin;
    pin.moveTo(0, 0);
    pin.cubicTo(-1.5, -4, -5, -5.5, -5, -9);
    pin.arcTo(QRectF(-5, -14, 10, 10), 180, -180);
    pin.cubicTo(5, -5.5, 1.5, -4, 0, 0);
    painter.setPen(QPen(theme.sea, 2.6, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPath(pin);
    painter.fillPath(pin, colour);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.sea);
    painter.drawEllipse(QPointF(0, -9), 1.8, 1.8);
}

void drawSearchPlace(QPainter& painter, const QPointF& centre, const QColor& colour)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 1.6, Qt::DotLine, Qt::RoundCap));
    painter.drawEllipse(centre, kSearchPlace_px, kSearchPlace_px);
}

QPen searchPen(const QColor& uav)
{
    return {uav, 1.6, Qt::DashDotLine, Qt::FlatCap, Qt::MiterJoin};
}

QPen clusterPen(const QColor& plan)
{
    return {plan, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin};
}

QPen circlePen(const Theme& theme)
{
    return {theme.ink, 1.2, Qt::DotLine, Qt::FlatCap};
}

QPen rangeRingPen(const Theme& theme)
{
    return {theme.mutedText, 1, Qt::DashLine};
}

QPen linkRingPen(const Theme& theme)
{
    return {theme.mutedText, 1.4, Qt::DotLine};
}

void drawClosed(QPainter& painter, const QPolygonF& outline, const QRectF& shown,
                const Theme& theme)
{
    constexpr double kSpacing_px = 9;
    const PainterState saved(painter);
    const QRectF box = outline.boundingRect() & shown;
    QPainterPath inside;
    inside.addPolygon(outline);
    inside.closeSubpath();
    painter.save();
    painter.setClipPath(inside, Qt::IntersectClip);
    QColor hatch = theme.uav;
    hatch.setAlphaF(0.55F);
    painter.setPen(QPen(hatch, 1));
    // Hatch lines are fixed to the screen, independent of the box, so that they do not flicker.
    const double first = std::ceil((box.left() + box.top()) / kSpacing_px) * kSpacing_px;
    for (double sum = first; sum < box.right() + box.bottom(); sum += kSpacing_px)
        painter.drawLine(QPointF(sum - box.top(), box.top()),
                         QPointF(sum - box.bottom(), box.bottom()));
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.uav, 1.6));
    painter.drawPath(inside);
}

QPen alarmRingPen(const Theme& theme, double width_px)
{
    return {theme.uav, width_px};
}

void drawArrow(QPainter& painter, const QLineF& line, const QPen& pen, double head_px)
{
    if (line.length() < 0.5)
        return;
    const PainterState saved(painter);
    const QPointF along(line.dx() / line.length(), line.dy() / line.length());
    const QPointF across(-along.y(), along.x());
    const double head = std::min(head_px, line.length());
    const QPointF base = line.p2() - along * head;
    painter.setPen(pen);
    painter.drawLine(line.p1(), base);
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen.color());
    painter.drawPolygon(
        QPolygonF{line.p2(), base + across * (0.45 * head), base - across * (0.45 * head)});
}

void drawDirectionMark(QPainter& painter, const QLineF& line, const QColor& colour, double size_px)
{
    if (line.length() < 5 * size_px)
        return;
    const PainterState saved(painter);
    const QPointF along(line.dx() / line.length(), line.dy() / line.length());
    const QPointF across(-along.y(), along.x());
    const QPointF tip = line.center() + along * (0.5 * size_px);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{tip, tip - along * size_px + across * (0.5 * size_px),
                                  tip - along * (0.7 * size_px),
                                  tip - along * size_px - across * (0.5 * size_px)});
}

QPen formerPlanPen(const QColor& colour)
{
    QPen pen(colour, 1.4, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({5, 3.5});
    return pen;
}

void drawAim(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme)
{
    constexpr double kArm_px = 3.5;
    const PainterState saved(painter);
    for (const QPen& pen : {QPen(theme.sea, 3.4), QPen(colour, 1.6)}) {
        painter.setPen(pen);
        painter.drawLine(centre + QPointF(-kArm_px, -kArm_px), centre + QPointF(kArm_px, kArm_px));
        painter.drawLine(centre + QPointF(-kArm_px, kArm_px), centre + QPointF(kArm_px, -kArm_px));
    }
}

void drawOrderDisk(QPainter& painter, const QPointF& centre, double radius_px, int number,
                   const Theme& theme, const QColor& colour)
{
    const PainterState saved(painter);
    const QColor ground = colour.isValid() ? colour : theme.plan;
    painter.setPen(QPen(theme.sea, 1.5));
    painter.setBrush(ground);
    painter.drawEllipse(centre, radius_px, radius_px);
    const bool isNearerText =
        contrastRatio(ground, theme.text) > contrastRatio(ground, theme.planText);
    painter.setPen(isNearerText ? theme.text : theme.planText);
    QFont font = theme.small();
    font.setWeight(QFont::Bold);
    if (number > 99)
        font.setPixelSize(7); // fits three digits on the disk
    painter.setFont(font);
    const QSizeF size(2 * radius_px + 8, 2 * radius_px);
    painter.drawText(QRectF(centre - QPointF(size.width() / 2, size.height() / 2), size),
                     Qt::AlignCenter, QString::number(number));
}

void drawHaloText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment,
                  const QString& text, const QColor& colour, const QColor& halo)
{
    const PainterState saved(painter);
    const int flags = static_cast<int>(alignment) | static_cast<int>(Qt::TextDontClip);
    if (isPaper(painter))
        drawOutline(painter, painter.boundingRect(rect, flags, text), text, halo);
    else
        drawCopies(painter, rect, flags, text, halo);
    painter.setPen(colour);
    painter.drawText(rect, flags, text);
}

void drawTabular(QPainter& painter, const QPointF& baseline, const QString& text)
{
    const QFontMetricsF metrics(painter.font());
    const double cell_px = widestDigit(metrics);
    QPointF at = baseline;
    for (const QChar c : text) {
        const double advance_px = metrics.horizontalAdvance(c);
        const double width_px = c.isDigit() ? cell_px : advance_px;
        painter.drawText(at + QPointF((width_px - advance_px) / 2, 0), QString(c));
        at.rx() += width_px;
    }
}

double tabularWidth(const QFontMetricsF& metrics, const QString& text)
{
    const double cell_px = widestDigit(metrics);
    double width_px = 0;
    for (const QChar c : text)
        width_px += c.isDigit() ? cell_px : metrics.horizontalAdvance(c);
    return width_px;
}

} // namespace berg
