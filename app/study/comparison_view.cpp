#include "app/study/comparison_view.h"

#include "app/dialogs/interaction.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/charts/comparison_chart.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

namespace berg {

void connectComparison(WindowContext& context, const Docks& docks)
{
    Workspace& w = context.workspace;
    ComparisonPanel* panel = context.panels.comparison;
    ComparisonChart* chart = context.panels.comparisonChart;
    context.on(panel, &ComparisonPanel::openRunRequested, [&context] {
        const QString path = context.interaction.openPath(
            &context.window, ComparisonPanel::tr("Runs (*.bergrun);;All files (*)"));
        if (!path.isEmpty())
            context.workspace.runs().open(path);
    });
    const auto showCursor = [&w, chart] { chart->setCursor_s(w.lookedAt_s()); };
    const auto setScenario = [&w, panel] { panel->setScenario(w.document().scenario()); };
    context.on(&w.runs(), &RunList::comparisonChanged, [&w, &docks, panel, chart, showCursor] {
        const std::optional<RunComparison> comparison = w.runs().comparison();
        chart->setComparison(comparison);
        const QWidget* focused = QApplication::focusWidget();
        if (comparison && focused != nullptr && panel->isAncestorOf(focused))
            docks.dock(Dock::ComparisonChart)->raise(); // it was chosen there: the curves as well
        showCursor();
    });
    context.on(&w.document(), &ScenarioDocument::replaced,
               [&w] { w.runs().showWorld(w.document().scenario()); });
    context.on(&w.document(), &ScenarioDocument::scenarioChanged, setScenario);
    context.on(&w, &Workspace::flightChanged, showCursor);
    setScenario();
    chart->setComparison(w.runs().comparison());
    showCursor();
}

} // namespace berg
