#pragma once

#include "core/base/nice_ticks.h"
#include "core/plan/policy/tau_curve.h"
#include "widgets/charts/chart_frame.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace berg {

/**
 * What can be had for what: distance of every optimal plan against its uncertainty reward, the
 * supported Pareto front of Eq. (1). The present plan stands out, unproven ones are hollow; a click
 * or an arrow key chooses another one. Holds nothing of its own.
 */
class ParetoChart : public QWidget
{
    Q_OBJECT

public:
    explicit ParetoChart(const Theme& theme, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /** Without it the plot has its room: for a chart inside something that has a title. */
    void setTitleShown(bool shown);
    void setCurve(const TauCurve& curve);
    /** With several UAVs there is no curve: the chart says so. */
    void setOfFleet(bool isOfFleet);
    void setTau(double tau);

    /** Places of the plans, in the order of the curve's intervals; device-independent pixels. */
    [[nodiscard]] std::vector<QPointF> points() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** The user wants the plan that is best for this tau. */
    void tauChosen(double tau);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] std::vector<ChartTick> ticks(const NiceRange& axis, double from_px,
                                               double to_px) const;
    [[nodiscard]] QPointF place(const CurveInterval& interval) const;
    [[nodiscard]] int planNear(const QPointF& at) const;
    void refresh();
    void layOut();
    void fillTitles();
    void setHovered(int plan);
    void choose(std::optional<double> tau);
    void paintFront(QPainter& painter) const;
    void paintEnds(QPainter& painter) const;
    void paintPlan(QPainter& painter, const CurveInterval& interval, double radius_px) const;

    Theme m_theme;
    TauCurve m_curve{.intervals = {}, .complete = true};
    bool m_isOfFleet = false;
    double m_tau = 1;
    bool m_titleShown = true;
    int m_present = -1;
    int m_hovered = -1;
    NiceRange m_distance; ///< km or nmi
    NiceRange m_reward;   ///< m^2
    ChartFrame m_frame;
};

} // namespace berg
