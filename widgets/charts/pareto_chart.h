#pragma once

#include "core/plan/policy/tau_curve.h"
#include "widgets/charts/figure_view.h"

namespace berg {

/**
 * What can be had for what: distance of every optimal plan against its uncertainty reward, the
 * supported Pareto front of Eq. (1). The present plan stands out, unproven ones are hollow; a click
 * or an arrow key chooses another one. Holds nothing of its own.
 */
class ParetoChart : public FigureView
{
    Q_OBJECT

public:
    explicit ParetoChart(const Theme& theme, QWidget* parent = nullptr);

    /** Its plans are the items, in its order. */
    void setCurve(const TauCurve& curve);
    void setTau(double tau);

signals:
    /** The user wants the plan that is best for this tau. */
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
