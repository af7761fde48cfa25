#pragma once

#include "core/plan/policy/tau_curve.h"
#include "widgets/charts/figure_view.h"

namespace berg {

/**
 * Trade-off of all optimal plans: distance against uncertainty reward, the supported Pareto front
 * of Eq. (1). The present plan stands out, unproven plans are hollow; a click or an arrow key
 * chooses another one, which only emits a signal.
 */
class ParetoChart : public FigureView
{
    Q_OBJECT

public:
    explicit ParetoChart(const Theme& theme, QWidget* parent = nullptr);

    /** Sets the curve, whose plans are the items, in its order. */
    void setCurve(const TauCurve& curve);
    /** Sets the present tau, whose plan stands out. */
    void setTau(double tau);

signals:
    /** The user chose the plan that is optimal for this tau. */
    void tauChosen(double tau);

protected:
    [[nodiscard]] Figure figure() const override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addPlans(Figure& figure) const;
    void addEnds(Figure& figure) const;
    void choose(std::optional<double> tau);

    TauCurve m_curve{.intervals = {}, .complete = true};
    double m_tau = 1;
};

} // namespace berg
