#include "widgets/charts/pareto_chart.h"

#include "widgets/charts/figure_text.h"
#include "widgets/forecast/curve_choice.h"

#include <QKeyEvent>

namespace berg {
namespace {

constexpr double kPlan_px = 3.6;
constexpr double kPresent_px = 7;
constexpr int kRoomForEnds_px = 310; // width required to name the ends of the front
constexpr double kEndGap_px = 12;    // distance of a name from its end
constexpr double kTopGap_px = 15;    // distance of the upper end from the middle of its name

PlotPoint placeOf(const CurveInterval& interval)
{
    return {longDistanceUnit().fromSi(interval.distance_m), interval.reward_m2};
}

} // namespace

ParetoChart::ParetoChart(const Theme& theme, QWidget* parent) : FigureView(theme, parent)
{
    connect(this, &FigureView::itemActivated, this, [this](std::size_t plan) {
        setChosen({}); // the present plan is already highlighted
        choose(shortTau(m_curve.intervals[plan]));
    });
    setTitleShown(true);
}

void ParetoChart::setCurve(const TauCurve& curve)
{
    m_curve = curve;
    forgetItems(0);
    refresh();
}

void ParetoChart::setTau(double tau)
{
    if (tau == m_tau)
        return;
    m_tau = tau;
    refresh();
}

Figure ParetoChart::figure() const
{
    Figure figure{.name = utf8(tr("Distance against uncertainty reward"))};
    figure.title = figure.name;
    const std::vector<CurveInterval>& plans = m_curve.intervals;
    const std::string computing =
        m_curve.complete ? std::string() : utf8(tr("Computing the plans for every τ"));
    if (plans.empty()) {
        figure.emptyText = m_curve.complete ? utf8(tr("No icebergs to plan for")) : computing;
        return figure;
    }
    // Distance and reward both decrease along the curve.
    const PlotPoint least = placeOf(plans.back());
    const PlotPoint largest = placeOf(plans.front());
    figure.x = {.least = least.x,
                .largest = largest.x,
                .spacing_px = 64,
                .text = numberText(locale()),
                .title = utf8(tr("Whole order, %1").arg(longDistanceUnit().name))};
    figure.y = {
        .least = least.y, .largest = largest.y, .spacing_px = 34, .text = numberText(locale())};
    figure.leftTitles = {utf8(tr("Uncertainty reward, m²")), utf8(tr("Reward, m²"))};
    figure.rightTitles = {computing};
    figure.rightInk = {};
    figure.description = computing;
    addPlans(figure);
    addEnds(figure);
    return figure;
}

void ParetoChart::addPlans(Figure& figure) const
{
    // The plans of an incomplete curve are not yet used in flight.
    const std::optional<int> present =
        m_curve.complete ? presentInterval(m_curve, m_tau) : std::nullopt;
    PlotLine front{.points = {}, .ink = {.of = InkOf::Plan, .strength = 0.6}, .width_px = 1.2};
    for (const CurveInterval& plan : m_curve.intervals) {
        const std::size_t id = figure.items.size();
        const bool isPresent = static_cast<int>(id) == present;
        const PlotPoint at = placeOf(plan);
        const QString figures = tr("%1, %2").arg(distanceText(plan.distance_m, locale()),
                                                 sigmaText(plan.reward_m2, locale()));
        const QString whole = intervalText(plan, locale());
        front.points.push_back(at);
        figure.marks.push_back({.at = at,
                                .radius_px = isPresent ? kPresent_px : kPlan_px,
                                .ink = {.of = InkOf::Plan},
                                .isHollow = !plan.proven});
        figure.items.push_back({.id = id, .at = at, .readout = utf8(QStringList{figures, whole})});
        if (isPresent) {
            figure.rightTitles = {utf8(figures)};
            figure.description = utf8(whole);
        }
    }
    figure.lines.push_back(std::move(front));
}

/** Names the two ends of the front, where there is room above and to the right. */
void ParetoChart::addEnds(Figure& figure) const
{
    if (m_curve.intervals.size() < 2 || width() < kRoomForEnds_px)
        return;
    const auto add = [&](const QString& text, PlotPoint end, LabelPlace place) {
        figure.labels.push_back({.text = utf8(text),
                                 .end = end,
                                 .ink = {.of = InkOf::Muted},
                                 .place = place,
                                 .needsMargin = false});
    };
    PlotPoint top = placeOf(m_curve.intervals.front());
    PlotPoint foot = placeOf(m_curve.intervals.back());
    top.dy_px = -kTopGap_px;
    figure.y.reserve_px = 1.5 * kTopGap_px;
    foot.dx_px = kEndGap_px;
    add(tr("Most uncertain first"), top, LabelPlace::Left);
    add(tr("Shortest path"), foot, LabelPlace::Right);
}

void ParetoChart::keyPressEvent(QKeyEvent* event)
{
    // Paths get longer to the right.
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return choose(tauOfNextPlan(m_curve, m_tau));
    case Qt::Key_Right:
    case Qt::Key_Up:
        return choose(tauOfPreviousPlan(m_curve, m_tau));
    default:                           // skips the item selection of `FigureView`
        QWidget::keyPressEvent(event); // NOLINT(bugprone-parent-virtual-call)
    }
}

void ParetoChart::choose(std::optional<double> tau)
{
    if (tau)
        emit tauChosen(*tau);
}

} // namespace berg
