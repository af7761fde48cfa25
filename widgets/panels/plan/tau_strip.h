#pragma once

#include "core/plan/policy/tau_curve.h"
#include "widgets/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QSlider;

namespace berg {

/**
 * The plans along the trade-off, to be placed below its slider: a tick where the plan changes, the
 * present plan filled, hatched where nothing is proven (yet). A click or an arrow key chooses
 * another plan. Covers tau 0 to 5; holds nothing of its own.
 */
class TauStrip : public QWidget
{
    Q_OBJECT

public:
    explicit TauStrip(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Maps tau as this slider does, whose range stands for tau 0 to 5. */
    void alignWith(const QSlider* slider);

    void setCurve(const TauCurve& curve);
    void setTau(double tau);

    /** Tau to jump to for the plan before the present one (more uncertain first), if any. */
    [[nodiscard]] std::optional<double> previousPlan() const;
    /** Tau to jump to for the plan after the present one (shorter way), if any. */
    [[nodiscard]] std::optional<double> nextPlan() const;

    // Device-independent pixels from the left edge.
    [[nodiscard]] double xOf(double tau) const;
    [[nodiscard]] double tauAt(double x_px) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** The user wants the plan that is best for this tau. */
    void tauChosen(double tau);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Span
    {
        double from_px = 0;
        double to_px = 0;
    };
    [[nodiscard]] Span scale() const;
    [[nodiscard]] QRectF bar(const CurveInterval& interval) const;
    /** Interval below a place, -1: none. */
    [[nodiscard]] int intervalNear(double x_px) const;
    [[nodiscard]] const CurveInterval* interval(int index) const;
    void setHovered(int index);
    void choose(std::optional<double> tau);
    void describe();
    void paintBand(QPainter& painter, const QRectF& band) const;
    void paintTicks(QPainter& painter, const QRectF& band) const;
    void paintPresent(QPainter& painter, const QRectF& band) const;

    Theme m_theme = Theme::light();
    TauCurve m_curve{.intervals = {}, .complete = true};
    double m_tau = 1;
    int m_hovered = -1;
    QPointer<const QSlider> m_slider;
};

} // namespace berg
