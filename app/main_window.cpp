#include "app/main_window.h"

#include "app/start_page.h"
#include "app/tab_order.h"
#include "app/tour.h"
#include "widgets/charts/comparison_chart.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/map_view.h"
#include "widgets/map/mission_picture.h"
#include "widgets/map/overview_inset.h"
#include "widgets/map/place_mark.h"
#include "widgets/model/error_text.h"
#include "widgets/model/event_text.h"
#include "widgets/panels/dialogs/goto_bar.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/flight_banner.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/flight/run_time_line.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/check_panel.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/comparison_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/print/export_painter.h"
#include "widgets/theme/palette.h"
#include "widgets/theme/quantity_text.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QStatusBar>
#include <QUndoStack>
#include <QUndoView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {

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
    m_workspace.runner().setExportPaint(exportPaint());
    qApp->installEventFilter(this);
    resize(1280, 800);
    m_defaultLayout = saveState(kLayoutVersion);
    restoreGeometry(m_settings.value("window/geometry").toByteArray());
    restoreState(m_settings.value("window/state").toByteArray(), kLayoutVersion);
    setAppearance(static_cast<Appearance>(m_settings.value("view/appearance", 0).toInt()));
    setInFlight(m_workspace.inFlight());
    showGivenUp();
    showTitle();
    m_comparison->setScenario(m_workspace.document().scenario());
    m_study->setScenario(m_workspace.document().scenario());
    m_comparisonChart->setComparison(m_workspace.runs().comparison());
    showPlanner();
    showCurve();
    m_tradeoff->showForecasts(m_workspace.forecasts().forecasts());
    showFlight();
    showCharts();
}

MainWindow::~MainWindow()
{
    hide(); // fields commit what is being typed while there still is a window to take it
}

void MainWindow::showTitle()
{
    const ScenarioDocument& document = m_workspace.document();
    const QString name = QString::fromStdString(document.scenario().name);
    QString title = name.isEmpty() ? tr("Untitled") : name;
    title.replace(u"[*]"_s, u"[*][*]"_s); // once it would be the mark of changes
    setWindowTitle(title + u"[*] - Bergwatch"_s);
    setWindowFilePath(document.filePath());
    setWindowModified(!document.isClean());
}

void MainWindow::finishLand()
{
    m_map->finishLand();
    if (m_overview->isVisible())
        m_overview->finishLand();
}

void MainWindow::showOverview()
{
    if (!m_map->hasInset())
        return;
    m_overview->setPlace(m_workspace.document().scenario().origin);
    m_overview->setExtent(m_map->outline());
}

void MainWindow::showCursor(const Point& position_m)
{
    const LatLon place =
        LocalFrame(m_workspace.document().scenario().origin).toGeographic(position_m);
    m_cursorLabel->setText(tr("%1   %2 E  %3 N", "place, east and north of the origin")
                               .arg(placeText(place, 2, locale()),
                                    offsetText(position_m.x(), locale()),
                                    offsetText(position_m.y(), locale())));
}

void MainWindow::setInFlight(bool inFlight)
{
    m_map->setLocked(inFlight);
    m_banner->showState(inFlight, m_workspace.lookedAt_s(), planFault());
    m_inspector->setLocked(inFlight);
    m_icebergs->showRecord(m_workspace.record());
    m_history->setEnabled(!inFlight);
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
    m_appearance = appearance;
    if (appearance == Appearance::System)
        followSystem();
    else
        applyTheme(appearance == Appearance::Dark ? Theme::dark() : Theme::light());
}

void MainWindow::followSystem()
{
    if (m_appearance == Appearance::System)
        applyTheme(m_system.isDark() ? Theme::dark() : Theme::light());
}

void MainWindow::applyTheme(const Theme& theme)
{
    m_theme = theme;
    QApplication::setPalette(paletteOf(theme));
    m_banner->setTheme(theme);
    m_overview->setTheme(theme);
    m_goto->setTheme(theme);
    m_placeMark->setTheme(theme);
    m_map->setTheme(theme);
    m_tradeoff->setTheme(theme);
    m_plan->setTheme(theme);
    m_inspector->setTheme(theme);
    m_playback->setTheme(theme);
    for (ChartPanel* chart : m_charts)
        chart->setTheme(theme);
    m_comparison->setTheme(theme);
    m_comparisonChart->setTheme(theme);
    m_pareto->setTheme(theme);
    m_solveTime->setTheme(theme);
    m_study->setTheme(theme);
    m_events->setTheme(theme);
    m_checks->setTheme(theme);
    m_icebergs->setTheme(theme);
    m_autosaveLabel->setTheme(theme);
    if (m_startPage != nullptr)
        m_startPage->setTheme(theme);
    if (m_tour != nullptr)
        m_tour->setTheme(theme);
    m_history->setCleanIcon(icon(IconName::Save, theme));
    refreshIcons();
    showChecks();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_ends) {
        // The study first: it may take a while to be saved, and then all this is asked again.
        if (!maySettleStudy([](MainWindow& window) { window.close(); }) || !maySettleSolveTimes() ||
            !mayLeaveScene(Interaction::FlightEnd::Closing)) {
            event->ignore();
            return;
        }
        m_workspace.autosaver().discard();
    }
    m_settings.setValue("window/geometry", saveGeometry());
    m_settings.setValue("window/state", saveState(kLayoutVersion));
    event->accept();
}

void MainWindow::changeEvent(QEvent* event)
{
    // The desktop has changed its colours, e.g. at sunset.
    if (event->type() == QEvent::ThemeChange)
        followSystem();
    if (event->type() == QEvent::ActivationChange && isActiveWindow())
        QTimer::singleShot(0, this, &MainWindow::lookAtFile);
    QMainWindow::changeEvent(event);
}

/** Keys without a modifier belong to what has the focus, where they mean something to it. */
bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
    followEnd(*event);
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool plain = key.modifiers() == Qt::NoModifier;
        const bool isButton = qobject_cast<QAbstractButton*>(watched) != nullptr;
        const bool isList = qobject_cast<QComboBox*>(watched) != nullptr;
        if (plain && ((key.key() == Qt::Key_Space && (isButton || isList)) ||
                      (isList && key.text().size() == 1 && key.text().front().isLetter()))) {
            event->accept();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

/** The next one that can be seen: a field behind another tab would be changed unseen. */
bool MainWindow::focusNextPrevChild(bool next)
{
    QWidget* to = nextInSight(*this, next);
    if (to != nullptr)
        to->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return to != nullptr;
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
    if (urls.isEmpty())
        return;
    event->acceptProposedAction();
    // After the drop: the program that the file comes from waits for its end.
    QTimer::singleShot(0, this, [this, path = urls.front().toLocalFile()] { openDropped(path); });
}

} // namespace berg
