#include "widgets/panels/plan/tau_strip.h"

#include "widgets/forecast/curve_choice.h"
#include "widgets/theme/accessible_roles.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSlider>
#include <QStyleOptionSlider>

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kEnd = 5; ///< tau at the right end
constexpr int kHeight_px = 16;
constexpr double kInset_px = 8; ///< inset without a slider to align with
constexpr double kBand_px = 8;
constexpr double kTickOut_px = 2; ///< length of ticks beyond the band, above and below
constexpr double kPresent_px = 12;
constexpr double kNarrowest_px = 5; ///< keeps the present plan visible
constexpr double kCorner_px = 2;
constexpr double kHatch_px = 5; ///< distance between lines

/** Fills `area` with diagonal lines whose position does not depend on the area. */
void hatch(QPainter& painter, const QRectF& area, const QColor& colour)
{
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.setPen(QPen(colour, 1));
    const double rise = area.height();
    for (double x = std::floor((area.left() - rise) / kHatch_px) * kHatch_px; x < area.right();
         x += kHatch_px)
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x + rise, area.top()));
    painter.restore();
}

} // namespace

TauStrip::TauStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleRole(*this, QAccessible::Chart);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Plans along the trade-off τ"));
    describe();
}

void TauStrip::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void TauStrip::alignWith(const QSlider* slider)
{
    m_slider = slider;
    update();
}

void TauStrip::setCurve(const TauCurve& curve)
{
    m_curve = curve;
    setHovered(underMouse() ? intervalNear(mapFromGlobal(QCursor::pos()).x()) : std::nullopt);
    describe();
}

void TauStrip::setTau(double tau)
{
    if (tau == m_tau)
        return;
    m_tau = tau;
    describe();
    update();
}

/** Updates the accessible description. */
void TauStrip::describe()
{
    const CurveInterval* present = interval(presentInterval(m_curve, m_tau));
    QString text = tr("%n plans", nullptr, static_cast<int>(m_curve.intervals.size()));
    if (present != nullptr)
        text = tr("%1. Present plan: %2").arg(text, intervalText(*present, locale()));
    setAccessibleDescription(text);
}

std::optional<double> TauStrip::previousPlan() const
{
    return tauOfPreviousPlan(m_curve, m_tau);
}

std::optional<double> TauStrip::nextPlan() const
{
    return tauOfNextPlan(m_curve, m_tau);
}

TauStrip::Span TauStrip::scale() const
{
    if (m_slider == nullptr)
        return {kInset_px, std::max(kInset_px + 1, width() - kInset_px)};
    QStyleOptionSlider option;
    option.initFrom(m_slider);
    option.subControls = QStyle::SC_SliderGroove | QStyle::SC_SliderHandle;
    option.orientation = Qt::Horizontal;
    option.minimum = m_slider->minimum();
    option.maximum = m_slider->maximum();
    option.tickPosition = m_slider->tickPosition();
    const auto handleAt = [&](int position) {
        option.sliderPosition = position;
        option.sliderValue = position;
        const QRect handle = m_slider->style()->subControlRect(QStyle::CC_Slider, &option,
                                                               QStyle::SC_SliderHandle, m_slider);
        const QPoint middle(handle.center().x(), 0);
        return static_cast<double>(mapFromGlobal(m_slider->mapToGlobal(middle)).x());
    };
    return {handleAt(option.minimum), handleAt(option.maximum)};
}

double TauStrip::xOf(double tau) const
{
    const Span span = scale();
    return span.from_px + (span.to_px - span.from_px) * tau / kEnd;
}

double TauStrip::tauAt(double x_px) const
{
    const Span span = scale();
    return std::clamp((x_px - span.from_px) / (span.to_px - span.from_px), 0.0, 1.0) * kEnd;
}

const CurveInterval* TauStrip::interval(std::optional<int> index) const
{
    return index ? &m_curve.intervals[static_cast<std::size_t>(*index)] : nullptr;
}

std::optional<int> TauStrip::intervalNear(double x_px) const
{
    // The bar of the present plan may be wider than its interval.
    const std::optional<int> present = presentInterval(m_curve, m_tau);
    if (present) {
        const QRectF shown = bar(*interval(present));
        if (x_px >= shown.left() && x_px < shown.right())
            return present;
    }
    return presentInterval(m_curve, tauAt(x_px));
}

QRectF TauStrip::bar(const CurveInterval& interval) const
{
    const double left_px = xOf(interval.tauFrom);
    const double right_px = xOf(std::min(interval.tauTo, kEnd));
    const double spare_px = std::max(0.0, kNarrowest_px - (right_px - left_px)) / 2;
    return QRectF(left_px - spare_px, (height() - kPresent_px) / 2,
                  right_px - left_px + 2 * spare_px, kPresent_px);
}

QSize TauStrip::sizeHint() const
{
    return {200, kHeight_px};
}

QSize TauStrip::minimumSizeHint() const
{
    return {80, kHeight_px};
}

void TauStrip::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!isEnabled())
        painter.setOpacity(0.4);
    const QRectF band(xOf(0), (height() - kBand_px) / 2, xOf(kEnd) - xOf(0), kBand_px);
    paintBand(painter, band);
    paintTicks(painter, band);
    paintPresent(painter, band);
    if (hasFocus()) {
        painter.setPen(QPen(m_theme.plan, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(band.adjusted(-3, -3.5, 3, 3.5), 4, 4);
    }
}

void TauStrip::paintBand(QPainter& painter, const QRectF& band) const
{
    painter.save();
    QPainterPath outline;
    outline.addRoundedRect(band, kCorner_px, kCorner_px);
    painter.setClipPath(outline);
    painter.fillRect(band, mixed(m_theme.panel, m_theme.text, 0.14));
    if (const CurveInterval* hovered = interval(m_hovered)) {
        QRectF part = bar(*hovered);
        part.setTop(band.top());
        part.setBottom(band.bottom());
        painter.fillRect(part, mixed(m_theme.panel, m_theme.plan, 0.45));
    }
    const QColor line = mixed(m_theme.panel, m_theme.text, 0.42);
    if (m_curve.intervals.empty() && !m_curve.complete)
        hatch(painter, band, line);
    for (const CurveInterval& interval : m_curve.intervals)
        if (!interval.proven && interval.tauFrom < kEnd)
            hatch(painter,
                  QRectF(QPointF(xOf(interval.tauFrom), band.top()),
                         QPointF(xOf(std::min(interval.tauTo, kEnd)), band.bottom())),
                  line);
    painter.restore();
}

void TauStrip::paintTicks(QPainter& painter, const QRectF& band) const
{
    painter.save();
    // Crisp lines on any scale: each tick on whole device pixels, no two on the same.
    const double pixel = 1 / devicePixelRatioF();
    const double width_px = std::max(1.0, std::round(devicePixelRatioF())) * pixel;
    const std::optional<int> present = presentInterval(m_curve, m_tau);
    std::optional<double> last_px;
    for (int i = 0; i + 1 < static_cast<int>(m_curve.intervals.size()); ++i) {
        if (i == present || i + 1 == present)
            continue; // its bar ends there
        const double tau = interval(i)->tauTo;
        const double x = std::round((xOf(tau) - width_px / 2) / pixel) * pixel;
        if (tau > kEnd || x == last_px)
            continue;
        last_px = x;
        painter.fillRect(
            QRectF(x, band.top() - kTickOut_px, width_px, band.height() + 2 * kTickOut_px),
            m_theme.mutedText);
    }
    painter.restore();
}

void TauStrip::paintPresent(QPainter& painter, const QRectF& band) const
{
    const CurveInterval* present = interval(presentInterval(m_curve, m_tau));
    if (present == nullptr || m_tau > kEnd)
        return;
    const QRectF shown = bar(*present);
    painter.save();
    painter.setPen(QPen(m_theme.panel, 1)); // separates it from the ticks beside it
    painter.setBrush(m_theme.plan);
    painter.drawRoundedRect(shown, kCorner_px, kCorner_px);
    if (!present->proven)
        hatch(painter, shown.adjusted(1, (kPresent_px - band.height()) / 2, -1, -2),
              mixed(m_theme.plan, m_theme.planText, 0.6));
    painter.restore();
}

void TauStrip::setHovered(std::optional<int> index)
{
    m_hovered = index;
    const QString computing =
        m_curve.complete ? QString() : tr("The plans for every τ are being computed.");
    setToolTip(index ? intervalText(*interval(index), locale()) : computing);
    update();
}

void TauStrip::mouseMoveEvent(QMouseEvent* event)
{
    if (const std::optional<int> index = intervalNear(event->position().x()); index != m_hovered)
        setHovered(index);
}

void TauStrip::leaveEvent(QEvent* /*event*/)
{
    setHovered(std::nullopt);
}

void TauStrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    if (const CurveInterval* pressed = interval(intervalNear(event->position().x())))
        choose(shortTau(*pressed));
}

void TauStrip::keyPressEvent(QKeyEvent* event)
{
    const std::vector<CurveInterval>& all = m_curve.intervals;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        choose(previousPlan());
        return;
    case Qt::Key_Right:
    case Qt::Key_Up:
        choose(nextPlan());
        return;
    case Qt::Key_Home:
        choose(all.empty() ? std::nullopt : std::optional(shortTau(all.front())));
        return;
    case Qt::Key_End:
        choose(all.empty() ? std::nullopt : std::optional(shortTau(all.back())));
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void TauStrip::choose(std::optional<double> tau)
{
    if (tau)
        emit tauChosen(*tau);
}

} // namespace berg
