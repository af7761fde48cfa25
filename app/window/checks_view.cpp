#include "app/window/checks_view.h"

#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "app/layout/status_line.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/words/issue_text.h"
#include "widgets/workspace/workspace.h"

#include <QDockWidget>

using namespace Qt::StringLiterals;

namespace berg {

ChecksView::ChecksView(WindowContext& context, const Docks& docks, StatusLine& status)
    : WindowPart(context), m_docks(docks), m_status(status)
{
    connect(panels().checks, &CheckPanel::chosen, this, &ChecksView::showCulprit);
    connect(&m_status, &StatusLine::findingsRequested, this, &ChecksView::openChecks);
    connect(panels().alarms, &AlarmStrip::checksRequested, this, &ChecksView::openChecks);
    connect(panels().tradeoff, &TradeoffPanel::checksRequested, this, &ChecksView::openChecks);
    ScenarioDocument& document = workspace().document();
    connect(&document, &ScenarioDocument::editRejected, this, [this](const Issue& why) {
        showMessage(tr("Not changed: %1").arg(issueText(why)), kLongMessage_ms);
    });
    connect(&document, &ScenarioDocument::scenarioChanged, this, &ChecksView::showChecks);
    connect(panels().checks, &CheckPanel::changed, this, &ChecksView::showChecks);
}

/** Hints are for who opens the list; errors and warnings call for it. */
void ChecksView::showChecks()
{
    m_status.showFindings(countIssues(panels().checks->issues()));
}

void ChecksView::openChecks()
{
    m_docks.raise(Dock::Checks);
    panels().checks->setFocus();
}

void ChecksView::toggleChecks()
{
    if (!m_docks.isInFront(Dock::Checks))
        return openChecks();
    m_docks.dock(Dock::Checks)->close();
    panels().map->setFocus();
}

/** Selects what a finding is about, brings it to the middle and shows where it can be changed. */
void ChecksView::showCulprit(const Issue& issue)
{
    const Scenario& scenario = workspace().document().scenario();
    const auto centreOn = [&](const Point& p_m) {
        panels().map->centreOn(LocalFrame(scenario.origin).toGeographic(p_m));
    };
    // The list may be older than the scenario.
    const auto placeIn = [&issue](const auto& list, const char* name) {
        const std::optional<std::size_t> place = issueIndex(issue, name);
        return place && *place < list.size() ? place : std::nullopt;
    };
    const std::optional<std::size_t> iceberg = placeIn(scenario.icebergs, "icebergs");
    const std::optional<std::size_t> uav = placeIn(scenario.uavs, "uavs");
    const std::optional<std::size_t> area = placeIn(scenario.noFly, "no_fly");
    if (iceberg) {
        const std::string id = scenario.icebergs[*iceberg].id;
        workspace().selection().set({id});
        panels().map->showIceberg(id);
    } else if (uav) {
        const Uav& found = scenario.uavs[*uav];
        workspace().selection().set({found.id});
        centreOn(found.position_m);
    } else if (issue.field.starts_with("asset") && scenario.asset) {
        workspace().selection().set({kAssetKey});
        centreOn(scenario.asset->position_m);
    } else if (area) {
        const std::string key = noFlyKey(*area);
        workspace().selection().set({key});
        centreOn(scenario.noFly[*area].corners_m.front());
    } else if (issue.field.starts_with("area_m")) {
        workspace().selection().set({kAreaKey});
        panels().map->fit();
    } else {
        workspace().selection().clear();
    }
    const bool isTradeoff = issue.field == "planner.tau" || issue.field == "planner.policy" ||
                            issue.field == "planner.backend";
    m_docks.raise(isTradeoff ? Dock::Tradeoff : Dock::Inspector);
}

} // namespace berg
