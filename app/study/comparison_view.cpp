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

using namespace Qt::StringLiterals;

namespace berg {

ComparisonView::ComparisonView(WindowContext& context, const Docks& docks)
    : WindowPart(context), m_docks(docks)
{
    connect(panels().comparison, &ComparisonPanel::openRunRequested, this,
            &ComparisonView::openRun);
    connect(&workspace().runs(), &RunList::comparisonChanged, this,
            &ComparisonView::showComparison);
    connect(&workspace().document(), &ScenarioDocument::replaced, this,
            [this] { workspace().runs().showWorld(workspace().document().scenario()); });
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            [this] { panels().comparison->setScenario(workspace().document().scenario()); });
    connect(&workspace(), &Workspace::flightChanged, this, &ComparisonView::showCursor);
}

void ComparisonView::show()
{
    panels().comparison->setScenario(workspace().document().scenario());
    panels().comparisonChart->setComparison(workspace().runs().comparison());
    showCursor();
}

void ComparisonView::showComparison()
{
    const std::optional<RunComparison> comparison = workspace().runs().comparison();
    panels().comparisonChart->setComparison(comparison);
    const QWidget* focused = QApplication::focusWidget();
    if (comparison && focused != nullptr && panels().comparison->isAncestorOf(focused))
        m_docks.dock(Dock::ComparisonChart)->raise(); // it was chosen there: the curves as well
    showCursor();
}

void ComparisonView::openRun()
{
    const QString path = interaction().openPath(&window(), tr("Runs (*.bergrun);;All files (*)"));
    if (!path.isEmpty())
        workspace().runs().open(path);
}

/** The instant looked back at. */
void ComparisonView::showCursor()
{
    panels().comparisonChart->setCursor_s(workspace().lookedAt_s());
}

} // namespace berg
