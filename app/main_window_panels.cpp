#include "app/main_window.h"
#include "app/tab_order.h"
#include "widgets/charts/comparison_chart.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/map_view.h"
#include "widgets/map/overview_inset.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/flight_banner.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"

#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QStatusBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kChartInterval_ms = 40;
constexpr int kTableInterval_ms = 100;
constexpr int kGivenUp_ms = 20'000; ///< then the menu still has it
constexpr int kRefusal_ms = 8000;   ///< to read why something was not done

} // namespace

void MainWindow::buildPanels()
{
    m_map = new MapView(m_workspace.document(), m_workspace.selection());
    m_playback = new PlaybackBar;
    m_tradeoff = new TradeoffPanel;
    m_plan = new PlanPanel;
    m_inspector = new InspectorPanel(m_workspace.document(), m_workspace.selection());
    m_charts = {new ChartPanel(ChartKind::Zeta, m_theme),
                new ChartPanel(ChartKind::Sigma, m_theme)};
    m_pareto = new ParetoChart(m_theme);
    m_pareto->setTitleShown(false);
    m_solveTime = new SolveTimePanel(m_workspace.benchmark());
    m_study = new StudyPanel(m_workspace.study());
    m_banner = new FlightBanner(m_map);
    m_overview = new OverviewInset(m_map);
    m_overview->hide();
    m_history = new QUndoView(m_workspace.document().undoStack());
    m_history->setEmptyLabel(tr("As opened"));
    m_history->setToolTip(tr("Click a line to go back or forth to it; the disk marks what is "
                             "saved."));
    m_events = new EventPanel;
    m_checks = new CheckPanel(m_workspace.document());
    m_icebergs = new IcebergTable(m_workspace.document(), m_workspace.selection());
    m_icebergs->setHiddenColumns(m_settings.value("icebergs/hiddenColumns").toStringList());
    m_comparison = new ComparisonPanel(m_workspace.runs());
    m_comparisonChart = new ComparisonChart(m_theme);
    m_comparisonChart->setTitleShown(false);

    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_map, 1);
    column->addWidget(m_playback);
    setCentralWidget(centre);

    m_stateLabel = new QLabel;
    m_stateLabel->setObjectName(u"stateLabel"_s);
    m_autosaveLabel = new CaptionLabel;
    m_autosaveLabel->setObjectName(u"autosaveLabel"_s);
    m_cursorLabel = new QLabel;
    m_cursorLabel->setObjectName(u"cursorLabel"_s);
    m_hintLabel = new QLabel;
    m_hintLabel->setObjectName(u"hintLabel"_s);
    statusBar()->addWidget(m_hintLabel, 1);
    m_checksButton = new QToolButton;
    m_checksButton->setObjectName(u"checksButton"_s);
    m_checksButton->setAutoRaise(true);
    m_checksButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_checksButton->setFocusPolicy(Qt::TabFocus);
    m_checksButton->setToolTip(tr("Shows what is found about the scenario."));
    QSizePolicy room = m_checksButton->sizePolicy();
    room.setRetainSizeWhenHidden(true); // or the map above gets another size
    m_checksButton->setSizePolicy(room);
    statusBar()->addPermanentWidget(m_checksButton);
    statusBar()->addPermanentWidget(m_stateLabel);
    statusBar()->addPermanentWidget(m_cursorLabel);
    statusBar()->addPermanentWidget(m_autosaveLabel);
}

void MainWindow::buildDocks()
{
    const auto dock = [this](const char* name, const QString& title, QWidget* content,
                             Qt::DockWidgetArea area) {
        auto* widget = new QDockWidget(title, this);
        widget->setObjectName(QLatin1String(name));
        widget->setWidget(content);
        addDockWidget(area, widget);
        connect(widget, &QDockWidget::visibilityChanged, this, [this](bool visible) {
            if (visible)
                showChartsSoon();
        });
        connect(
            widget, &QDockWidget::visibilityChanged, this,
            [this] { // what is typed is to be seen
                if (const QWidget* focused = focusWidget();
                    focused != nullptr && isBehindATab(*focused))
                    m_map->setFocus();
            },
            Qt::QueuedConnection);
        connect(widget->toggleViewAction(), &QAction::triggered, widget, [widget](bool shown) {
            if (shown)
                widget->raise(); // among its tabs
        });
        m_docks.push_back(widget);
        return widget;
    };
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* tradeoff =
        dock("tradeoffDock", tr("Trade-off"), m_tradeoff, Qt::RightDockWidgetArea);
    QDockWidget* plan = dock("planDock", tr("Plan"), m_plan, Qt::RightDockWidgetArea);
    QDockWidget* inspector =
        dock("inspectorDock", tr("Inspector"), m_inspector, Qt::RightDockWidgetArea);
    QDockWidget* pareto = dock("paretoDock", tr("Trade-offs"), m_pareto, Qt::RightDockWidgetArea);
    tabifyDockWidget(plan, inspector);
    tabifyDockWidget(inspector, pareto);
    QDockWidget* history = dock("historyDock", tr("History"), m_history, Qt::RightDockWidgetArea);
    tabifyDockWidget(pareto, history);
    history->hide(); // for whoever wants it
    plan->raise();
    QDockWidget* zeta = dock("zetaDock", tr("Chart"), m_charts.front(), Qt::BottomDockWidgetArea);
    QDockWidget* sigma =
        dock("sigmaDock", tr("Chart 2"), m_charts.back(), Qt::BottomDockWidgetArea);
    QDockWidget* events = dock("eventsDock", tr("Events"), m_events, Qt::BottomDockWidgetArea);
    splitDockWidget(zeta, sigma, Qt::Horizontal);
    QDockWidget* comparisonChart = dock("comparisonChartDock", tr("Comparison chart"),
                                        m_comparisonChart, Qt::BottomDockWidgetArea);
    QDockWidget* checks = dock("checksDock", tr("Checks"), m_checks, Qt::BottomDockWidgetArea);
    tabifyDockWidget(zeta, comparisonChart);
    tabifyDockWidget(comparisonChart, checks);
    zeta->raise();
    const auto scrolling = [](QWidget* content) { // does not ask for the room it is best in
        auto* scroll = new QScrollArea;
        scroll->setWidgetResizable(true);
        scroll->setFrameShape(QFrame::NoFrame);
        scroll->setWidget(content);
        return scroll;
    };
    QDockWidget* solveTime =
        dock("solveTimeDock", tr("Solve time"), scrolling(m_solveTime), Qt::BottomDockWidgetArea);
    QDockWidget* study =
        dock("studyDock", tr("Study"), scrolling(m_study), Qt::BottomDockWidgetArea);
    // Studies, not part of watching a flight; hidden before their tabs ask for room.
    solveTime->hide();
    study->hide();
    QDockWidget* comparison =
        dock("comparisonDock", tr("Comparison"), m_comparison, Qt::BottomDockWidgetArea);
    QDockWidget* icebergs =
        dock("icebergsDock", tr("Icebergs"), m_icebergs, Qt::BottomDockWidgetArea);
    tabifyDockWidget(sigma, icebergs);
    tabifyDockWidget(icebergs, events);
    tabifyDockWidget(events, comparison);
    tabifyDockWidget(comparison, solveTime);
    tabifyDockWidget(solveTime, study);
    sigma->raise();
    resizeDocks({tradeoff}, {310}, Qt::Horizontal);
    resizeDocks({zeta}, {230}, Qt::Vertical);
    resizeDocks({zeta, sigma}, {470, 490}, Qt::Horizontal);
    resizeDocks({tradeoff, plan}, {300, 400}, Qt::Vertical);
}

void MainWindow::connectPanels()
{
    connectWorkspace();
    buildPlaces();
    connectSafety();
    connectChecks();
    connectStudy();
    connectPlanner();
    connectFlight();
    connectCharts();
    connectTables();
    connectMap();
}

void MainWindow::connectWorkspace()
{
    ScenarioDocument& document = m_workspace.document();
    connect(&m_system, &SystemAppearance::changed, this, &MainWindow::followSystem);
    connect(&m_workspace, &Workspace::flightChanged, this, &MainWindow::showFlight);
    connect(&m_workspace, &Workspace::inFlightChanged, this, &MainWindow::setInFlight);
    connect(&m_workspace, &Workspace::takeOffAhead, this, [this] {
        m_map->cancelGesture();
        finishTyping();
    });
    connect(&m_workspace, &Workspace::refused, this, [this](const QString& text) {
        statusBar()->showMessage(text, kRefusal_ms);
        showPlanner(); // what was refused is not in force
    });
    connect(&m_workspace.runner(), &MissionRunner::exportReady, this, &MainWindow::writeExport);
    connect(&m_workspace.runner(), &MissionRunner::runReady, this,
            [this](const QString& path, const std::shared_ptr<const RunFile>& run) {
                writeRun(path, *run);
            });
    connect(&document, &ScenarioDocument::scenarioChanged, this, [this] {
        m_comparison->setScenario(m_workspace.document().scenario());
        m_study->setScenario(m_workspace.document().scenario());
        showPlanner();
        showFlight();
        showTitle();
    });
    connect(&document, &ScenarioDocument::filePathChanged, this, &MainWindow::showTitle);
    connect(&document, &ScenarioDocument::cleanChanged, this, &MainWindow::showTitle);
    connect(&m_workspace.selection(), &Selection::changed, this, [this] {
        updateActions();
        showSelection();
    });
}

void MainWindow::connectPlanner()
{
    connect(m_tradeoff, &TradeoffPanel::tauEdited, &m_workspace, &Workspace::setTau);
    connect(m_tradeoff, &TradeoffPanel::tauEditFinished, &m_workspace.document(),
            &ScenarioDocument::endGesture);
    connect(m_tradeoff, &TradeoffPanel::policyEdited, &m_workspace, &Workspace::setPolicy);
    connect(m_tradeoff, &TradeoffPanel::backendEdited, &m_workspace, &Workspace::setBackend);
    connect(m_tradeoff, &TradeoffPanel::routeEdited, &m_workspace, &Workspace::setRoute);

    connect(&m_workspace.forecasts(), &PolicyForecasts::updated, this,
            [this] { m_tradeoff->showForecasts(m_workspace.forecasts().forecasts()); });
    connect(m_pareto, &ParetoChart::tauChosen, m_tradeoff, &TradeoffPanel::chooseTau);
    connect(&m_workspace.curve(), &CurveRunner::updated, this, &MainWindow::showCurve);
}

void MainWindow::connectFlight()
{
    connect(m_playback, &PlaybackBar::playRequested, this, &MainWindow::togglePlay);
    connect(m_playback, &PlaybackBar::pauseRequested, &m_workspace, &Workspace::pause);
    connect(m_playback, &PlaybackBar::stepRequested, &m_workspace, &Workspace::step);
    connect(m_playback, &PlaybackBar::resetRequested, &m_workspace, &Workspace::reset);
    connect(m_playback, &PlaybackBar::rateEdited, &m_workspace, &Workspace::setRate);
    connect(m_playback, &PlaybackBar::timeEdited, &m_workspace, &Workspace::lookAt);
    connect(m_events, &EventPanel::timeChosen, &m_workspace, &Workspace::lookAt);

    connect(m_banner, &FlightBanner::stopRequested, &m_workspace, &Workspace::reset);
    connect(m_banner, &FlightBanner::flyOnRequested, &m_workspace, &Workspace::flyOnFromHere);
    connect(m_banner, &FlightBanner::bringBackRequested, &m_workspace, &Workspace::bringBackFlight);
    connect(&m_workspace, &Workspace::givenUpChanged, this, &MainWindow::showGivenUp);
    m_givenUpTimer.setSingleShot(true);
    m_givenUpTimer.setInterval(kGivenUp_ms);
    connect(&m_givenUpTimer, &QTimer::timeout, this, [this] { m_banner->showGivenUp({}); });
    connect(m_banner, &FlightBanner::newestRequested, &m_workspace, &Workspace::lookAtNewest);
}

void MainWindow::connectCharts()
{
    for (ChartPanel* chart : m_charts) {
        connect(chart, &ChartPanel::timePicked, &m_workspace, &Workspace::lookAt);
        connect(chart, &ChartPanel::kindChanged, this, &MainWindow::showCharts);
        connect(chart, &ChartPanel::exportRequested, this, [this, chart] { exportChart(*chart); });
        connect(chart, &ChartPanel::icebergPicked, this,
                [this](const std::string& id) { m_workspace.selection().set({id}); });
    }
    connect(m_comparison, &ComparisonPanel::openRunRequested, this, &MainWindow::openRunToCompare);
    connect(&m_workspace.runs(), &RunList::comparisonChanged, this, &MainWindow::showComparison);
    connect(&m_workspace.bound(), &BoundRunner::updated, this, &MainWindow::showChartsSoon);

    m_chartTimer.setSingleShot(true);
    m_chartTimer.setInterval(kChartInterval_ms / static_cast<int>(m_charts.size()));
    connect(&m_chartTimer, &QTimer::timeout, this, &MainWindow::showNextChart);
}

void MainWindow::connectTables()
{
    connect(m_plan, &PlanPanel::hovered, m_map, &MapView::setHighlight);
    connect(m_map, &MapView::hovered, m_plan, &PlanPanel::setHighlight);
    connect(m_icebergs, &IcebergTable::hovered, m_map, &MapView::setHighlight);
    connect(m_map, &MapView::hovered, m_icebergs, &IcebergTable::setHighlight);
    connect(m_icebergs, &IcebergTable::chosen, this, [this](const std::string& id) {
        m_workspace.selection().set({id});
        m_map->showIceberg(id);
    });
    connect(m_icebergs, &IcebergTable::mapPasteRequested, m_map, &MapView::paste);
    connect(m_icebergs, &IcebergTable::hiddenColumnsChanged, this, [this](const QStringList& keys) {
        m_settings.setValue("icebergs/hiddenColumns", keys);
    });
    connect(m_plan, &PlanPanel::activated, this,
            [this](const std::string& id) { m_workspace.selection().set({id}); });
    connect(m_plan, &PlanPanel::menuRequested, this, &MainWindow::showPlanMenu);
    connect(m_plan, &PlanPanel::handedOver, this,
            [this](const std::string& iceberg, const std::string& uav) {
                m_workspace.assign({iceberg}, uav);
            });

    m_tableTimer.setSingleShot(true);
    m_tableTimer.setInterval(kTableInterval_ms);
    connect(&m_tableTimer, &QTimer::timeout, this, &MainWindow::showTables);
}

void MainWindow::connectMap()
{
    connect(m_map, &MapView::outlineChanged, this, &MainWindow::showOverview);
    connect(m_overview, &OverviewInset::placePicked, m_map, &MapView::centreOn);
    connect(m_map, &MapView::followUavChanged, m_followAction, &QAction::setChecked);
    connect(m_map, &MapView::cursorMoved, this, &MainWindow::showCursor);
    connect(m_map, &MapView::windEdited, &m_workspace, &Workspace::setWind);
    connect(m_map, &MapView::assetMoved, &m_workspace, &Workspace::moveAsset);
    connect(m_map, &MapView::icebergPlaced, &m_workspace, &Workspace::addIceberg);
    connect(m_map, &MapView::cursorLeft, m_cursorLabel, &QLabel::clear);
    connect(m_map, &MapView::editRequested, this, &MainWindow::openInspector);
    connect(m_map, &MapView::statusText, this, [this](const QString& text) {
        m_hintLabel->setText(text);
        updateActions(); // drawing has begun or ended
    });
    connect(m_map, &MapView::refused, this,
            [this](const QString& text) { statusBar()->showMessage(text, kRefusal_ms); });
    connect(m_map, &MapView::contextMenuRequested, this, &MainWindow::showContextMenu);
}

} // namespace berg
