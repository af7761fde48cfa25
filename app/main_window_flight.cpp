#include "app/main_window.h"
#include "widgets/charts/comparison_chart.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/comparison_track.h"
#include "widgets/map/map_view.h"
#include "widgets/map/mission_picture.h"
#include "widgets/model/event_text.h"
#include "widgets/model/wind.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/flight_banner.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/theme/quantity_text.h"

#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kLongestState_px = 420;

/** The words of the status bar for what the mission thread is doing. */
QString phaseText(RunPhase phase, const QString& fault)
{
    switch (phase) {
    case RunPhase::Planning:
        return MainWindow::tr("Planning");
    case RunPhase::Ready:
        return MainWindow::tr("Ready: Space flies it");
    case RunPhase::Flying:
        return MainWindow::tr("Flying");
    case RunPhase::Paused:
        return MainWindow::tr("Paused");
    case RunPhase::Finished:
        return MainWindow::tr("Run complete");
    case RunPhase::Failed:
        return MainWindow::tr("Cannot be planned: %1").arg(fault);
    }
    return {};
}

} // namespace

void MainWindow::togglePlay()
{
    if (m_workspace.isPlaying()) {
        m_workspace.pause();
        return;
    }
    if (m_workspace.lookedAt_s()) {
        m_workspace.fly(m_playback->rate());
        return;
    }
    switch (m_workspace.record().now.phase) {
    case RunPhase::Planning:
        statusBar()->showMessage(tr("The plan is still being made."), 4000);
        return;
    case RunPhase::Finished:
        m_workspace.reset();
        m_workspace.fly(m_playback->rate());
        return;
    case RunPhase::Ready:
    case RunPhase::Flying:
    case RunPhase::Paused:
    case RunPhase::Failed:
        m_workspace.fly(m_playback->rate());
        return;
    }
}

/** A flight that was given up can be had again; the banner says so for a while. */
void MainWindow::showGivenUp()
{
    const std::optional<double> flown_s = m_workspace.givenUp_s();
    findChild<QAction*>(u"bringBackAction"_s)->setEnabled(flown_s.has_value());
    m_banner->showGivenUp(flown_s ? tr("Flight to %1 given up").arg(clockText(*flown_s))
                                  : QString());
    if (flown_s)
        m_givenUpTimer.start();
}

void MainWindow::askWind()
{
    const double airspeed_mps = slowestAirspeed_mps(m_workspace.document().scenario());
    if (airspeed_mps <= 0)
        return;
    const bool wasInFlight = m_workspace.inFlight();
    const std::optional<Point> wind_mps =
        m_interaction.askWind(this, m_workspace.wind_mps(), airspeed_mps);
    if (wind_mps && mayAnswer(wasInFlight))
        m_workspace.setWind(*wind_mps);
}

void MainWindow::showFlight()
{
    const FlightRecord& record = m_workspace.record();
    MapPicture picture = missionPicture(record, locale());
    if (!m_sweptAction->isChecked())
        for (MapRoute& route : picture.routes)
            route.swept.clear();
    if (!m_truthAction->isChecked())
        hideTruth(picture);
    if (const RunPointer other = m_workspace.runs().otherIn(record.scenario))
        addComparison(picture, *other,
                      record.inFlight() ? record.shown().time_s : record.scenario.duration_s,
                      locale());
    picture.emptyHint = tr("Press I and click on the map to place one, drag on to let it drift, "
                           "or import sightings.");
    m_plan->setSigmaFull(picture.sigmaFull_m2);
    m_icebergs->setSigmaFull(picture.sigmaFull_m2);
    m_map->setPicture(std::move(picture));
    m_map->setMayIntervene(m_workspace.mayIntervene());
    const QString fault = planFault();
    m_tradeoff->showPlan(readoutOf(record, fault));
    const bool playing = m_workspace.isPlaying();
    if (!playing) // else at the pace of the tables
        showPlan();
    m_playback->showState(playing          ? RunPhase::Flying
                          : record.instant ? RunPhase::Paused
                                           : record.now.phase,
                          record.shown().time_s, record.scenario.duration_s, record.now.time_s);
    m_banner->showState(record.inFlight(), m_workspace.lookedAt_s(), fault);
    m_banner->showNotices(flightNotices(record, locale()));
    m_comparisonChart->setCursor_s(m_workspace.lookedAt_s());
    const QString phase = phaseText(record.now.phase, fault);
    m_stateLabel->setText(
        m_stateLabel->fontMetrics().elidedText(phase, Qt::ElideRight, kLongestState_px));
    m_stateLabel->setToolTip(phase == m_stateLabel->text() ? QString() : phase);
    m_playAction->setText(playing ? tr("Pause") : tr("Fly"));
    if (record.inFlight())
        showPlanner();
    showChartsSoon();
}

/** One after the other, and the tables after them. */
void MainWindow::showChartsSoon()
{
    m_chartsDue = m_charts.size();
    if (!m_chartTimer.isActive())
        m_chartTimer.start();
}

void MainWindow::showPlan()
{
    const FlightRecord& record = m_workspace.record();
    m_plan->setFaulty(!planFault().isEmpty());
    m_plan->showPlan(planSections(record.shown(), record.scenario));
    m_plan->showOutlook(planOutlook(record));
}

void MainWindow::showCharts()
{
    for (ChartPanel* chart : m_charts)
        showChart(*chart);
    showEvents();
}

void MainWindow::showChart(ChartPanel& chart)
{
    if (chart.isVisible()) // behind another tab it is shown when it comes to the front
        chart.showRecord(m_workspace.record());
}

/** One in a turn of the event loop, so that no frame has to paint all of them. */
void MainWindow::showNextChart()
{
    showChart(*m_charts[m_nextChart]);
    m_nextChart = (m_nextChart + 1) % m_charts.size();
    m_chartsDue -= std::min<std::size_t>(m_chartsDue, 1);
    if (m_chartsDue > 0)
        m_chartTimer.start();
    if (m_nextChart != 0)
        return;
    showEvents();
    if (!m_tableTimer.isActive())
        m_tableTimer.start();
}

void MainWindow::showTables()
{
    if (m_icebergs->isVisible())
        m_icebergs->showRecord(m_workspace.record());
    showPlan();
}

void MainWindow::showComparison()
{
    const std::optional<RunComparison> comparison = m_workspace.runs().comparison();
    m_comparisonChart->setComparison(comparison);
    if (comparison && m_comparison->isVisible()) // the user is comparing: the curves as well
        findChild<QDockWidget*>(u"comparisonChartDock"_s)->raise();
    showFlight();
}

/** The one iceberg selected stands out in the charts. */
void MainWindow::showSelection()
{
    const std::vector<std::string>& ids = m_workspace.selection().ids();
    for (ChartPanel* chart : m_charts)
        chart->setHighlight(ids.size() == 1 ? ids.front() : std::string());
}

void MainWindow::showEvents()
{
    const FlightRecord& record = m_workspace.record();
    const std::vector<MissionEvent>& events = record.history.events;
    if (record.history.rewrites != m_markRewrites) {
        m_markRewrites = record.history.rewrites;
        m_markedEvents = 0;
        m_marks.clear();
        m_playback->setMarks({});
    }
    if (events.size() > m_markedEvents) {
        for (; m_markedEvents < events.size(); ++m_markedEvents) {
            const MissionEvent& event = events[m_markedEvents];
            m_marks.push_back(
                {.time_s = event.time_s,
                 .kind = event.kind,
                 .text = eventText(event, record.now.icebergs, record.scenario.uavs)});
        }
        m_playback->setMarks(m_marks);
    }
    m_events->showRecord(record);
}

void MainWindow::showPlanner()
{
    m_tradeoff->showSettings(m_workspace.planner());
    m_pareto->setTau(m_workspace.planner().tau);
}

void MainWindow::showCurve()
{
    m_tradeoff->showCurve(m_workspace.curve().curve());
    m_pareto->setOfFleet(m_workspace.curve().isOfFleet());
    m_pareto->setCurve(m_workspace.curve().curve());
}

} // namespace berg
