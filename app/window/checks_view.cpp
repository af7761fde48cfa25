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

namespace berg {
namespace {

void openChecks(const WindowContext& context, const Docks& docks)
{
    docks.raise(Dock::Checks);
    context.panels.checks->setFocus();
}

/** Selects what a finding is about, brings it to the middle and shows where it can be changed. */
void showCulprit(const WindowContext& context, const Docks& docks, const Issue& issue)
{
    Workspace& w = context.workspace;
    MapView* map = context.panels.map;
    const Scenario& scenario = w.document().scenario();
    const auto centreOn = [&](const Point& p_m) {
        map->camera().centreOn(LocalFrame(scenario.origin).toGeographic(p_m));
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
        w.selection().set({id});
        map->camera().showIceberg(id);
    } else if (uav) {
        const Uav& found = scenario.uavs[*uav];
        w.selection().set({found.id});
        centreOn(found.position_m);
    } else if (issue.field.starts_with("asset") && scenario.asset) {
        w.selection().set({kAssetKey});
        centreOn(scenario.asset->position_m);
    } else if (area) {
        const std::string key = noFlyKey(*area);
        w.selection().set({key});
        centreOn(scenario.noFly[*area].corners_m.front());
    } else if (issue.field.starts_with("area_m")) {
        w.selection().set({kAreaKey});
        map->camera().fit();
    } else {
        w.selection().clear();
    }
    const bool isTradeoff = issue.field == "planner.tau" || issue.field == "planner.policy" ||
                            issue.field == "planner.backend";
    docks.raise(isTradeoff ? Dock::Tradeoff : Dock::Inspector);
}

} // namespace

void connectChecks(WindowContext& context, const Docks& docks, StatusLine& status)
{
    const Panels& panels = context.panels;
    const auto open = [&context, &docks] { openChecks(context, docks); };
    context.on(panels.checks, &CheckPanel::chosen,
               [&context, &docks](const Issue& issue) { showCulprit(context, docks, issue); });
    context.on(&status, &StatusLine::findingsRequested, open);
    context.on(panels.alarms, &AlarmStrip::checksRequested, open);
    context.on(panels.tradeoff, &TradeoffPanel::checksRequested, open);
    const ScenarioDocument& document = context.workspace.document();
    context.on(&document, &ScenarioDocument::editRejected, [&context](const Issue& why) {
        showMessage(context, StatusLine::tr("Not changed: %1").arg(issueText(why)),
                    kLongMessage_ms);
    });
    // Hints are for who opens the list; errors and warnings call for it.
    const auto showCounts = [&panels, &status] {
        status.showFindings(countIssues(panels.checks->issues()));
    };
    context.on(&document, &ScenarioDocument::scenarioChanged, showCounts);
    context.on(panels.checks, &CheckPanel::changed, showCounts);
    showCounts();
}

void toggleChecks(const WindowContext& context, const Docks& docks)
{
    if (!docks.isInFront(Dock::Checks))
        return openChecks(context, docks);
    docks.dock(Dock::Checks)->close();
    context.panels.map->setFocus();
}

} // namespace berg
