// What is found about the scenario, where it is found, and fields of icebergs made at once.

#include "app/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/model/error_text.h"
#include "widgets/panels/dialogs/generate_dialog.h"
#include "widgets/panels/flight/flight_banner.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/inspector/issue_text.h"
#include "widgets/panels/plan/tradeoff_panel.h"

#include <QDockWidget>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kDialogEdge_px = 12;
constexpr int kRefusal_ms = 8000;

void raiseDock(const QWidget& window, const QString& name)
{
    auto* dock = window.findChild<QDockWidget*>(name);
    dock->show();
    dock->raise();
}

} // namespace

void MainWindow::connectChecks()
{
    connect(m_checks, &CheckPanel::chosen, this, &MainWindow::showCulprit);
    connect(m_checksButton, &QToolButton::clicked, this, &MainWindow::openChecks);
    connect(m_banner, &FlightBanner::checksRequested, this, &MainWindow::openChecks);
    connect(&m_workspace.document(), &ScenarioDocument::impossible, this, [this](const Issue& why) {
        statusBar()->showMessage(tr("Not changed: %1").arg(issueText(why)), kRefusal_ms);
    });
    connect(m_tradeoff, &TradeoffPanel::checksRequested, this, &MainWindow::openChecks);
    connect(&m_workspace.document(), &ScenarioDocument::scenarioChanged, this,
            &MainWindow::showChecks);
}

/** Hints are for who opens the list; errors and warnings call for it. */
void MainWindow::showChecks()
{
    const IssueCounts counts = countIssues(m_workspace.document().issues());
    m_checksButton->setVisible(counts.errors + counts.warnings > 0);
    m_checksButton->setText(countsText(counts));
    m_checksButton->setIcon(icon(counts.errors > 0 ? IconName::Fault : IconName::Warning, m_theme));
}

void MainWindow::openChecks()
{
    raiseDock(*this, u"checksDock"_s);
    m_checks->setFocus();
}

/** Selects what a finding is about, brings it to the middle and shows where it can be changed. */
void MainWindow::showCulprit(const Issue& issue)
{
    const Scenario& scenario = m_workspace.document().scenario();
    const auto centreOn = [&](const Point& p_m) {
        m_map->centreOn(LocalFrame(scenario.origin).toGeographic(p_m));
    };
    const int iceberg = issueIndex(issue, "icebergs");
    const int uav = issueIndex(issue, "uavs");
    if (iceberg >= 0) {
        const std::string id = scenario.icebergs[static_cast<std::size_t>(iceberg)].id;
        m_workspace.selection().set({id});
        m_map->showIceberg(id);
    } else if (uav >= 0) {
        const Uav& found = scenario.uavs[static_cast<std::size_t>(uav)];
        m_workspace.selection().set({found.id});
        centreOn(found.position_m);
    } else if (issue.field.starts_with("asset") && scenario.asset) {
        m_workspace.selection().set({kAssetKey});
        centreOn(scenario.asset->position_m);
    } else if (issue.field.starts_with("area_m")) {
        m_workspace.selection().set({kAreaKey});
        m_map->fit();
    } else {
        m_workspace.selection().clear();
    }
    const bool isTradeoff = issue.field == "planner.tau" || issue.field == "planner.policy" ||
                            issue.field == "planner.backend";
    raiseDock(*this, isTradeoff ? u"tradeoffDock"_s : u"inspectorDock"_s);
}

/** Why nothing can be planned, in one sentence; empty: nothing stands in the way. */
QString MainWindow::planFault() const
{
    const MissionSnapshot& now = m_workspace.record().now;
    if (now.phase != RunPhase::Failed)
        return {};
    const ScenarioDocument& document = m_workspace.document();
    for (const Issue& issue : document.issues())
        if (issue.severity == Severity::Error)
            return issueLine(issue, document.scenario());
    return now.error ? errorReport(*now.error).section(u'\n', 0, 0) : QString();
}

void MainWindow::generateIcebergs()
{
    finishTyping();
    auto* dialog = new GenerateDialog(m_workspace.document().scenario(),
                                      m_map->view().visible(m_map->rect()), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto preview = [this, dialog] {
        m_map->setPreview(dialog->count() > 0 ? &dialog->result() : nullptr);
    };
    connect(dialog, &GenerateDialog::drawn, this, preview);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (!mayAnswer(false))
            return;
        const int count = dialog->count();
        m_workspace.document().edit(
            count == 1 ? tr("Generate iceberg") : tr("Generate %n icebergs", nullptr, count),
            [dialog](Scenario& scenario) { scenario.icebergs = dialog->result().icebergs; });
    });
    connect(dialog, &QDialog::finished, this, [this] { m_map->setPreview(nullptr); });
    preview();
    dialog->open();
    // Beside the sea that the preview is on.
    dialog->move(geometry().right() - dialog->width() - kDialogEdge_px,
                 m_map->mapToGlobal(QPoint(0, kDialogEdge_px)).y());
}

} // namespace berg
