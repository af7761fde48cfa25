#pragma once

#include "core/plan/policy/tau_curve.h"
#include "widgets/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <optional>

class QSlider;

namespace berg {

/**
 * The plans along the trade-off, below its slider: a tick where the plan changes, the present plan
 * filled, unproven ones hatched. A click or an arrow key chooses another plan. Covers tau 0 to 5;
 * stores nothing of its own.
 */
class TauStrip : public QWidget
{
    Q_OBJECT

public:
    explicit TauStrip(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Aligns tau with this slider, whose range stands for tau 0 to 5. */
    void alignWith(const QSlider* slider);

    void setCurve(const TauCurve& curve);
    void setTau(double tau);

    /** Returns tau of the previous plan (more uncertain first), if any. */
    [[nodiscard]] std::optional<double> previousPlan() const;
    /** Returns tau of the next plan (shorter path), if any. */
    [[nodiscard]] std::optional<double> nextPlan() const;

    // Conversions to and from device-independent pixels from the left edge.
    [[nodiscard]] double xOf(double tau) const;
    [[nodiscard]] double tauAt(double x_px) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** Emitted when the user chooses the plan that is best for this tau. */
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
    /** Returns the index of the interval below a position, or nullopt if there is none. */
    [[nodiscard]] std::optional<int> intervalNear(double x_px) const;
    /** Returns the interval with this index; null without an index. */
    [[nodiscard]] const CurveInterval* interval(std::optional<int> index) const;
    void setHovered(std::optional<int> index);
    void choose(std::optional<double> tau);
    void describe();
    void paintBand(QPainter& painter, const QRectF& band) const;
    void paintTicks(QPainter& painter, const QRectF& band) const;
    void paintPresent(QPainter& painter, const QRectF& band) const;

    Theme m_theme = Theme::light();
    TauCurve m_curve{.intervals = {}, .complete = true};
    double m_tau = 1;
    std::optional<int> m_hovered;
    QPointer<const QSlider> m_slider;
};

} // namespace berg
