#include "app/flight/flight_panels.h"

#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/theme/announcer.h"
#include "widgets/words/error_text.h"
#include "widgets/words/event_text.h"
#include "widgets/words/issue_text.h"
#include "widgets/workspace/workspace.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kChartInterval_ms = 40;
constexpr int kTableInterval_ms = 100;

} // namespace

QString planFault(Workspace& workspace)
{
    const MissionSnapshot& now = workspace.record().now;
    if (now.phase != RunPhase::Failed)
        return {};
    const ScenarioDocument& document = workspace.document();
    for (const Issue& issue : document.issues())
        if (issue.severity == Severity::Error)
            return issueLine(issue, document.scenario());
    return now.error ? errorReport(*now.error).section(u'\n', 0, 0) : QString();
}

FlightPanels::FlightPanels(WindowContext& context, const Docks& docks) : WindowPart(context)
{
    for (const ChartPanel* chart : panels().charts) {
        connect(chart, &ChartPanel::timePicked, &workspace(), &Workspace::seek);
        connect(chart, &ChartPanel::kindChanged, this, &FlightPanels::showCharts);
        connect(chart, &ChartPanel::icebergPicked, this,
                [this](const std::string& id) { workspace().selection().set({id}); });
    }
    connect(&docks, &Docks::shown, this, &FlightPanels::showSoon);
    connect(&workspace().bound(), &BoundRunner::updated, this, &FlightPanels::showSoon);
    connect(&workspace().selection(), &Selection::changed, this, &FlightPanels::showSelection);

    m_chartTimer.setSingleShot(true);
    m_chartTimer.setInterval(kChartInterval_ms / static_cast<int>(panels().charts.size()));
    connect(&m_chartTimer, &QTimer::timeout, this, &FlightPanels::showNextChart);
    m_tableTimer.setSingleShot(true);
    m_tableTimer.setInterval(kTableInterval_ms);
    connect(&m_tableTimer, &QTimer::timeout, this, &FlightPanels::showTables);
    showSelection();
}

void FlightPanels::showSoon()
{
    m_chartsDue = panels().charts.size();
    if (!m_chartTimer.isActive())
        m_chartTimer.start();
}

void FlightPanels::showPlan()
{
    const FlightRecord& record = workspace().record();
    const QString fault = planFault(workspace());
    std::vector<PlanSection> sections = planSections(record.shown(), record.scenario);
    PlanReadout readout = readoutOf(record, fault);
    readout.isHeld = !sections.empty() && std::ranges::none_of(sections, &PlanSection::isPlanned);
    panels().tradeoff->showPlan(readout);
    showSorties(record.isOver() ? std::vector<std::optional<PlannedSortie>>()
                                : plannedSorties(record.shown(), record.scenario),
                darkFlights(record.shown(), record.scenario, sections));
    panels().plan->setFaulty(!fault.isEmpty());
    panels().plan->showPlan(std::move(sections), timesOf(record));
    panels().plan->showOutlook(planOutlook(record));
}

/** Margins at home, contact and further findings of the plan, wherever they are shown. */
void FlightPanels::showSorties(std::vector<std::optional<PlannedSortie>> sorties,
                               std::vector<Issue> issues)
{
    std::optional<double> noReturn_s;
    for (std::size_t uav = 0; uav < sorties.size(); ++uav) {
        if (!sorties[uav])
            continue;
        const SortieOutlook& outlook = sorties[uav]->outlook;
        if (outlook.noReturn)
            noReturn_s =
                std::min(noReturn_s.value_or(outlook.noReturn->time_s), outlook.noReturn->time_s);
        for (Issue& issue : sortieIssues(uav, outlook, sorties[uav]->lowMargin_s))
            issues.push_back(std::move(issue));
    }
    if (noReturn_s)
        *noReturn_s += workspace().record().shown().time_s;
    panels().playback->timeLine().setNoReturn(noReturn_s);
    if (workspace().record().shown().time_s == 0) // in flight they would change all the time
        panels().checks->setPlanIssues(std::move(issues));
    panels().plan->showSorties(std::move(sorties));
}

void FlightPanels::showCharts()
{
    for (ChartPanel* chart : panels().charts)
        showChart(*chart);
    showEvents();
}

void FlightPanels::showChart(ChartPanel& chart)
{
    if (chart.isVisible()) // behind another tab it is shown when it comes to the front
        chart.showRecord(workspace().record());
}

/** One in a turn of the event loop, so that no frame has to paint all of them. */
void FlightPanels::showNextChart()
{
    showChart(*panels().charts[m_nextChart]);
    m_nextChart = (m_nextChart + 1) % panels().charts.size();
    m_chartsDue -= std::min<std::size_t>(m_chartsDue, 1);
    if (m_chartsDue > 0)
        m_chartTimer.start();
    if (m_nextChart != 0)
        return;
    showEvents();
    if (!m_tableTimer.isActive())
        m_tableTimer.start();
}

void FlightPanels::showTables()
{
    if (panels().icebergs->isVisible())
        panels().icebergs->showRecord(workspace().record());
    showPlan();
}

/** The one iceberg selected stands out in the charts. */
void FlightPanels::showSelection()
{
    const std::vector<std::string>& ids = workspace().selection().ids();
    panels().plan->showSelection(ids);
    for (ChartPanel* chart : panels().charts)
        chart->setHighlight(ids.size() == 1 ? ids.front() : std::string());
}

void FlightPanels::showEvents()
{
    const FlightRecord& record = workspace().record();
    const std::vector<MissionEvent>& events = record.history.events;
    const bool isNew = record.history.rewrites != m_markRewrites; // or opened
    if (isNew) {
        m_markRewrites = record.history.rewrites;
        m_markedEvents = 0;
        m_marks.clear();
        panels().playback->timeLine().setMarks({});
    }
    if (events.size() > m_markedEvents) {
        const bool isNews = workspace().inFlight() && !workspace().lookedAt_s() && !isNew;
        for (; m_markedEvents < events.size(); ++m_markedEvents) {
            const MissionEvent& event = events[m_markedEvents];
            m_marks.push_back({.time_s = event.time_s,
                               .kind = event.kind,
                               .text = eventText(event, record.now.icebergs, record.scenario.uavs,
                                                 locale(), clockOf(record.scenario))});
            if (isNews)
                panels().announcer->say(m_marks.back().text);
        }
        panels().playback->timeLine().setMarks(m_marks);
    }
    panels().events->showRecord(record);
}

} // namespace berg
