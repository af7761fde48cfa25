#include "app/main_window.h"

#include "widgets/charts/mission_charts.h"
#include "widgets/charts/time_chart.h"
#include "widgets/map/map_view.h"
#include "widgets/map/mission_picture.h"
#include "widgets/model/error_text.h"
#include "widgets/model/event_text.h"
#include "widgets/panels/inspector_panel.h"
#include "widgets/panels/plan_panel.h"
#include "widgets/panels/playback_bar.h"
#include "widgets/panels/tradeoff_panel.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QStatusBar>
#include <QUndoStack>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kChartInterval_ms = 40;
constexpr int kLayoutVersion = 1;

/** The words of the status bar for what the mission thread is doing. */
QString phaseText(const MissionSnapshot& snapshot)
{
    switch (snapshot.phase) {
    case RunPhase::Planning:
        return MainWindow::tr("Planning");
    case RunPhase::Ready:
        return MainWindow::tr("Ready: Space flies it");
    case RunPhase::Flying:
        return MainWindow::tr("Flying: the scenario is locked, tau and policy are not");
    case RunPhase::Paused:
        return MainWindow::tr("Paused: reset to edit the scenario");
    case RunPhase::Finished:
        return MainWindow::tr("Flown to the end: reset to edit the scenario");
    case RunPhase::Failed:
        return MainWindow::tr("Cannot be planned: %1")
            .arg(snapshot.error ? errorReport(*snapshot.error).section(u'\n', 0, 0) : QString());
    }
    return {};
}

} // namespace

MainWindow::MainWindow(Workspace& workspace, Interaction& interaction, QSettings& settings)
    : m_workspace(workspace)
    , m_interaction(interaction)
    , m_settings(settings)
    , m_theme(Theme::light())
{
    setObjectName(u"mainWindow"_s);
    setAcceptDrops(true);
    setAttribute(Qt::WA_DeleteOnClose, false);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    buildPanels();
    buildDocks();
    buildActions();
    connectPanels();
    resize(1280, 800);
    m_defaultLayout = saveState(kLayoutVersion);
    restoreGeometry(m_settings.value("window/geometry").toByteArray());
    restoreState(m_settings.value("window/state").toByteArray(), kLayoutVersion);
    setAppearance(static_cast<Appearance>(m_settings.value("view/appearance", 0).toInt()));
    setInFlight(m_workspace.inFlight());
    showTitle();
    showPlanner();
    showFlight();
    showCharts();
}

MainWindow::~MainWindow()
{
    hide(); // fields commit what is being typed while there still is a window to take it
}

void MainWindow::buildPanels()
{
    m_map = new MapView(m_workspace.document(), m_workspace.selection());
    m_playback = new PlaybackBar;
    m_tradeoff = new TradeoffPanel;
    m_plan = new PlanPanel;
    m_inspector = new InspectorPanel(m_workspace.document(), m_workspace.selection());
    m_zetaChart = new TimeChart(m_theme);
    m_sigmaChart = new TimeChart(m_theme);
    m_events = new QListWidget;
    m_events->setObjectName(u"eventList"_s);
    m_events->setUniformItemSizes(true);
    m_events->setFrameShape(QFrame::NoFrame);

    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_map, 1);
    column->addWidget(m_playback);
    setCentralWidget(centre);

    m_stateLabel = new QLabel;
    m_stateLabel->setObjectName(u"stateLabel"_s);
    m_cursorLabel = new QLabel;
    m_cursorLabel->setObjectName(u"cursorLabel"_s);
    statusBar()->addWidget(m_stateLabel, 1);
    statusBar()->addPermanentWidget(m_cursorLabel);
}

void MainWindow::buildDocks()
{
    const auto dock = [this](const char* name, const QString& title, QWidget* content,
                             Qt::DockWidgetArea area) {
        auto* widget = new QDockWidget(title, this);
        widget->setObjectName(QLatin1String(name));
        widget->setWidget(content);
        addDockWidget(area, widget);
        m_docks.push_back(widget);
        return widget;
    };
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    QDockWidget* tradeoff =
        dock("tradeoffDock", tr("Trade-off"), m_tradeoff, Qt::RightDockWidgetArea);
    QDockWidget* plan = dock("planDock", tr("Plan"), m_plan, Qt::RightDockWidgetArea);
    QDockWidget* inspector =
        dock("inspectorDock", tr("Inspector"), m_inspector, Qt::RightDockWidgetArea);
    tabifyDockWidget(plan, inspector);
    plan->raise();
    QDockWidget* zeta = dock("zetaDock", tr("Zeta"), m_zetaChart, Qt::BottomDockWidgetArea);
    QDockWidget* sigma = dock("sigmaDock", tr("Sigma"), m_sigmaChart, Qt::BottomDockWidgetArea);
    QDockWidget* events = dock("eventsDock", tr("Events"), m_events, Qt::BottomDockWidgetArea);
    splitDockWidget(zeta, sigma, Qt::Horizontal);
    tabifyDockWidget(sigma, events);
    sigma->raise();
    resizeDocks({tradeoff}, {310}, Qt::Horizontal);
    resizeDocks({zeta}, {210}, Qt::Vertical);
}

void MainWindow::connectPanels()
{
    ScenarioDocument& document = m_workspace.document();
    connect(&m_workspace, &Workspace::flightChanged, this, &MainWindow::showFlight);
    connect(&m_workspace, &Workspace::inFlightChanged, this, &MainWindow::setInFlight);
    connect(&m_workspace, &Workspace::refused, this,
            [this](const QString& text) { statusBar()->showMessage(text, 8000); });
    connect(&document, &ScenarioDocument::scenarioChanged, this, [this] {
        showPlanner();
        showFlight();
        showTitle();
    });
    connect(&document, &ScenarioDocument::filePathChanged, this, &MainWindow::showTitle);
    connect(&document, &ScenarioDocument::cleanChanged, this, &MainWindow::showTitle);
    connect(&m_workspace.selection(), &Selection::changed, this, &MainWindow::updateActions);

    connect(m_tradeoff, &TradeoffPanel::tauEdited, &m_workspace, &Workspace::setTau);
    connect(m_tradeoff, &TradeoffPanel::tauEditFinished, &document, &ScenarioDocument::endGesture);
    connect(m_tradeoff, &TradeoffPanel::policyEdited, &m_workspace, &Workspace::setPolicy);
    connect(m_tradeoff, &TradeoffPanel::backendEdited, &m_workspace, &Workspace::setBackend);
    connect(m_tradeoff, &TradeoffPanel::routeEdited, &m_workspace, &Workspace::setRoute);

    connect(m_playback, &PlaybackBar::playRequested, this, &MainWindow::togglePlay);
    connect(m_playback, &PlaybackBar::pauseRequested, &m_workspace, &Workspace::pause);
    connect(m_playback, &PlaybackBar::stepRequested, &m_workspace, &Workspace::step);
    connect(m_playback, &PlaybackBar::resetRequested, &m_workspace, &Workspace::reset);
    connect(m_playback, &PlaybackBar::rateEdited, &m_workspace, &Workspace::setRate);

    connect(m_plan, &PlanPanel::hovered, m_map, &MapView::setHighlight);
    connect(m_map, &MapView::hovered, m_plan, &PlanPanel::setHighlight);
    connect(m_plan, &PlanPanel::activated, this,
            [this](const std::string& id) { m_workspace.selection().set({id}); });
    connect(m_map, &MapView::followUavChanged, m_followAction, &QAction::setChecked);
    connect(m_map, &MapView::cursorMoved, this, &MainWindow::showCursor);
    connect(m_map, &MapView::cursorLeft, m_cursorLabel, &QLabel::clear);
    connect(m_map, &MapView::editRequested, this, [this] {
        m_docks[2]->show();
        m_docks[2]->raise();
        m_inspector->setFocus();
    });
    connect(m_map, &MapView::statusText, this,
            [this](const QString& text) { statusBar()->showMessage(text, 4000); });
    connect(m_map, &MapView::contextMenuRequested, this, &MainWindow::showContextMenu);

    m_chartTimer.setSingleShot(true);
    m_chartTimer.setInterval(kChartInterval_ms);
    connect(&m_chartTimer, &QTimer::timeout, this, &MainWindow::showCharts);
}

void MainWindow::togglePlay()
{
    switch (m_workspace.record().now.phase) {
    case RunPhase::Flying:
        m_workspace.pause();
        return;
    case RunPhase::Finished:
        m_workspace.reset();
        m_workspace.fly(m_playback->rate());
        return;
    case RunPhase::Planning:
    case RunPhase::Ready:
    case RunPhase::Paused:
    case RunPhase::Failed:
        m_workspace.fly(m_playback->rate());
        return;
    }
}

void MainWindow::showFlight()
{
    const FlightRecord& record = m_workspace.record();
    MapPicture picture = missionPicture(record, locale());
    m_plan->setSigmaFull(picture.sigmaFull_m2);
    m_map->setPicture(std::move(picture));
    m_plan->showPlan(planRows(record.now, record.scenario));
    m_tradeoff->showPlan(
        {.plan = record.now.plan, .solving = record.now.phase == RunPhase::Planning});
    m_playback->showState(record.now.phase, record.now.time_s, record.scenario.duration_s);
    m_stateLabel->setText(phaseText(record.now));
    m_playAction->setText(record.now.phase == RunPhase::Flying ? tr("Pause") : tr("Fly"));
    if (record.inFlight())
        showPlanner();
    if (!m_chartTimer.isActive())
        m_chartTimer.start();
}

void MainWindow::showCharts()
{
    const FlightRecord& record = m_workspace.record();
    m_zetaChart->setContent(zetaContent(record, locale()));
    m_sigmaChart->setContent(sigmaContent(record, locale()));
    showEvents();
}

void MainWindow::showEvents()
{
    const FlightRecord& record = m_workspace.record();
    const auto shown = static_cast<std::size_t>(m_events->count());
    if (record.now.events.size() < shown)
        m_events->clear();
    for (std::size_t i = static_cast<std::size_t>(m_events->count()); i < record.now.events.size();
         ++i)
        m_events->addItem(eventText(record.now.events[i], record.now.icebergs));
    if (record.now.events.size() > shown)
        m_events->scrollToBottom();
}

void MainWindow::showPlanner()
{
    m_tradeoff->showSettings(m_workspace.planner());
}

void MainWindow::showTitle()
{
    const ScenarioDocument& document = m_workspace.document();
    const QString name = QString::fromStdString(document.scenario().name);
    setWindowTitle(u"%1[*] - Bergwatch"_s.arg(name.isEmpty() ? tr("Untitled") : name));
    setWindowFilePath(document.filePath());
    setWindowModified(!document.isClean());
}

void MainWindow::showCursor(const Point& position_m)
{
    const LatLon place =
        LocalFrame(m_workspace.document().scenario().origin).toGeographic(position_m);
    m_cursorLabel->setText(tr("%1  %2   %3 m E  %4 m N")
                               .arg(latitudeText(place.latitude_deg, 2, locale()),
                                    longitudeText(place.longitude_deg, 2, locale()),
                                    fixedText(position_m.x(), 0, locale()),
                                    fixedText(position_m.y(), 0, locale())));
}

void MainWindow::setInFlight(bool inFlight)
{
    m_map->setLocked(inFlight);
    m_inspector->setLocked(inFlight);
    m_tradeoff->setInFlight(inFlight);
    if (inFlight)
        m_map->setTool(MapToolKind::Select);
    else
        showPlanner();
    updateActions();
}

void MainWindow::setAppearance(Appearance appearance)
{
    m_settings.setValue("view/appearance", static_cast<int>(appearance));
    const bool dark =
        appearance == Appearance::Dark || (appearance == Appearance::System && systemIsDark());
    applyTheme(dark ? Theme::dark() : Theme::light());
}

void MainWindow::applyTheme(const Theme& theme)
{
    m_theme = theme;
    QApplication::setPalette(paletteOf(theme));
    m_map->setTheme(theme);
    m_tradeoff->setTheme(theme);
    m_plan->setTheme(theme);
    m_inspector->setTheme(theme);
    m_playback->setTheme(theme);
    m_zetaChart->setTheme(theme);
    m_sigmaChart->setTheme(theme);
    refreshIcons();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!maySettleChanges()) {
        event->ignore();
        return;
    }
    m_settings.setValue("window/geometry", saveGeometry());
    m_settings.setValue("window/state", saveState(kLayoutVersion));
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty())
        openFile(urls.front().toLocalFile());
}

} // namespace berg
