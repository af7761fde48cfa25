#include "app/flight/planner_view.h"

#include "app/layout/panels.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/workspace/workspace.h"

#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kDetailsKey = "view/planDetails";

} // namespace

PlannerView::PlannerView(WindowContext& context) : WindowPart(context)
{
    panels().tradeoff->setDetailsShown(settings().value(kDetailsKey, false).toBool());
    connect(panels().tradeoff, &TradeoffPanel::detailsToggled, this,
            [this](bool isShown) { settings().setValue(kDetailsKey, isShown); });
    connect(panels().tradeoff, &TradeoffPanel::tauEdited, &workspace(), &Workspace::setTau);
    connect(panels().tradeoff, &TradeoffPanel::tauEditFinished, &workspace().document(),
            &ScenarioDocument::endGesture);
    connect(panels().tradeoff, &TradeoffPanel::policyEdited, &workspace(), &Workspace::setPolicy);
    connect(panels().tradeoff, &TradeoffPanel::backendEdited, &workspace(), &Workspace::setBackend);
    connect(panels().tradeoff, &TradeoffPanel::routeEdited, &workspace(), &Workspace::setRoute);

    connect(&workspace().forecasts(), &PolicyForecasts::updated, this, &PlannerView::showForecasts);
    connect(panels().pareto, &ParetoChart::tauChosen, panels().tradeoff, &TradeoffPanel::chooseTau);
    connect(&workspace().curve(), &CurveRunner::updated, this, &PlannerView::showCurve);

    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            &PlannerView::showPlanner);
    connect(&workspace(), &Workspace::inFlightChanged, this, &PlannerView::showPlanner);
    connect(&workspace(), &Workspace::refused, this, [this] { // what was refused is not in force
        panels().tradeoff->finishTau();
        showPlanner();
    });
    connect(&workspace(), &Workspace::flightChanged, this, [this] {
        if (workspace().inFlight())
            showPlanner();
    });
}

void PlannerView::show()
{
    showPlanner();
    showCurve();
    showForecasts();
}

void PlannerView::showPlanner()
{
    panels().tradeoff->showSettings(workspace().planner());
    panels().pareto->setTau(workspace().planner().tau);
}

void PlannerView::showCurve()
{
    panels().tradeoff->showCurve(workspace().curve().curve());
    panels().pareto->setCurve(workspace().curve().curve());
}

void PlannerView::showForecasts()
{
    panels().tradeoff->showForecasts(workspace().forecasts().forecasts());
}

} // namespace berg
