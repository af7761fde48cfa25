#include "app/window/main_window.h"

#include "app/flight/flight_connections.h"
#include "app/layout/tab_order.h"
#include "app/study/comparison_view.h"
#include "app/window/checks_view.h"
#include "app/window/window_parts.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/flight/message_list.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/study/solve_time_panel.h"
#include "widgets/workspace/workspace.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

/** Returns true for Shift+F10, which replaces the menu key; Qt itself does so only on Windows. */
bool opensMenu(const QKeyEvent& key)
{
    return key.key() == Qt::Key_F10 && key.modifiers() == Qt::ShiftModifier;
}

/** A key that writes a character: a field with the focus has it, whether or not it takes it. */
bool isPrintable(const QKeyEvent& key)
{
    const Qt::KeyboardModifiers others =
        key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    return (others == Qt::NoModifier || others == Qt::GroupSwitchModifier) &&
           !key.text().isEmpty() && key.text().front().isPrint();
}

bool isField(const QObject& watched)
{
    const auto* combo = qobject_cast<const QComboBox*>(&watched);
    return qobject_cast<const QLineEdit*>(&watched) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&watched) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(&watched) != nullptr ||
           (combo != nullptr && combo->isEditable());
}

/** Whether Delete in this widget means what is selected: on the map and in the lists of icebergs.
 */
bool showsSelection(const Panels& panels, const QWidget& widget)
{
    const auto isIn = [&](const QWidget* panel) {
        return panel == &widget || panel->isAncestorOf(&widget);
    };
    return &widget == widget.window() || isIn(panels.map) || isIn(panels.icebergs) ||
           isIn(panels.plan);
}

/** The line that is typed in; null where the widget has none. */
const QLineEdit* lineOf(QObject& widget)
{
    const auto* box = qobject_cast<QAbstractSpinBox*>(&widget);
    return box != nullptr ? box->findChild<QLineEdit*>() : qobject_cast<QLineEdit*>(&widget);
}

/**
 * Whether the window is asked, not the field that is typed in: there is nothing typed to take back,
 * and Ctrl+E would be the end of the line.
 */
bool goesToWindow(const QKeyEvent& key, QObject& watched)
{
    const bool isRedo = key.matches(QKeySequence::Redo);
    const bool isHistory = isRedo || key.matches(QKeySequence::Undo);
    if (const auto* page = qobject_cast<QPlainTextEdit*>(&watched))
        return isHistory && !page->document()->isUndoAvailable() &&
               !(isRedo && page->document()->isRedoAvailable());
    const QLineEdit* field = lineOf(watched);
    if (field == nullptr)
        return false;
    if (key.modifiers() == Qt::ControlModifier && key.key() == Qt::Key_E)
        return true;
    return isHistory && !field->isModified() && !(isRedo && field->isRedoAvailable());
}

} // namespace

WindowParts::WindowParts(WindowContext& context)
    : status(context)
    , docks(context)
    , files(context)
    , results(context)
    , start(context, files, docks)
    , sightings(context, files, start)
    , dialogs(context, files, docks, start)
    , study(context, docks)
    , solveTimes(context, docks)
    , studyFlights(context, files, docks)
    , safety(context,
             {.files = files, .results = results, .study = study, .solveTimes = solveTimes}, status)
    , flightPanels(context, docks)
    , flightView(context, flightPanels, status)
    , sound(context)
    , runEnd(context, docks, results)
    , aircraft(context, flightView)
    , mapLinks(context, docks)
    , backdrop(context, mapLinks)
    , appearance(context)
    , preferences(context, appearance)
    , manual(context)
    , menus(context, *this)
    , contextMenus(context, docks)
{
    connectChecks(context, docks, status);
    connectComparison(context, docks);
    connectPlanner(context);
    connectPlayback(context);
}

MainWindow::MainWindow(Workspace& workspace, Interaction& interaction, QSettings& settings)
    : m_panels(workspace, Theme::light())
    , m_context{.window = *this,
                .workspace = workspace,
                .interaction = interaction,
                .settings = settings,
                .panels = m_panels,
                .theme = Theme::light()}
{
    setObjectName(u"mainWindow"_s);
    setAttribute(Qt::WA_DeleteOnClose, false);
    setCentralWidget(m_panels.makeCentre());
    m_panels.map->setFocus(); // else the window gives it to an alarm, which takes the space key
    m_parts = std::make_unique<WindowParts>(m_context);
    connect(&m_parts->files, &ScenarioFiles::telemetryLogChosen, this, [this](const QString& path) {
        m_parts->docks.raise(Dock::Aircraft);
        m_parts->aircraft.replay(path);
    });
    connect(&m_parts->appearance, &AppearanceChoice::themeChanged, this, &MainWindow::showTheme);
    connect(&m_parts->preferences, &PreferenceMenus::languageChosen, this,
            &MainWindow::languageChosen);
    connect(&m_parts->preferences, &PreferenceMenus::unitsChosen, this, &MainWindow::unitsChosen);
    connect(&m_parts->preferences, &PreferenceMenus::sigmaEndChosen, &m_parts->flightView,
            &FlightView::showFlight);
    const ScenarioDocument& document = workspace.document();
    connect(&document, &ScenarioDocument::scenarioChanged, this, &MainWindow::showTitle);
    connect(&document, &ScenarioDocument::filePathChanged, this, &MainWindow::showTitle);
    connect(&document, &ScenarioDocument::cleanChanged, this, &MainWindow::showTitle);
    qApp->installEventFilter(this);
    resize(1280, 800);
    m_parts->docks.noteDefault();
    m_parts->docks.restore();
    m_parts->appearance.setAppearance(
        static_cast<Appearance>(settings.value("view/appearance", 0).toInt()));
    m_parts->flightView.setInFlight(workspace.inFlight());
    showTitle();
    m_parts->flightView.showFlight();
    m_parts->flightPanels.showCharts();
}

MainWindow::~MainWindow()
{
    hide(); // fields commit what is being typed while there still is a window to take it
}

void MainWindow::showTheme(const Theme& theme)
{
    m_panels.setTheme(theme);
    m_parts->status.setTheme(theme);
    m_parts->start.setTheme(theme);
    m_parts->runEnd.setTheme(theme);
    m_parts->menus.refreshIcons();
}

void MainWindow::showAs(MainWindow& other)
{
    if (other.m_parts->start.pageIsShown())
        m_parts->start.showPage();
    m_panels.map->camera().showAs(other.m_panels.map->camera());
}

void MainWindow::takeOver(MainWindow& other)
{
    m_parts->results.takeOver(other.m_parts->results);
    m_parts->study.takeOver(other.m_parts->study);
    m_parts->studyFlights.takeOver(other.m_parts->studyFlights);
    m_parts->safety.takeOver(other.m_parts->safety);
    m_parts->runEnd.takeOver(other.m_parts->runEnd);
    m_parts->aircraft.takeOver(other.m_parts->aircraft);
    const Panels& shown = other.m_panels;
    m_panels.messages->takeOver(*shown.messages);
    m_panels.alarms->takeOver(*shown.alarms);
    m_panels.solveTime->showSpec(shown.solveTime->spec());
    m_panels.playback->setRate(shown.playback->rate());
    for (std::size_t i = 0; i < shown.charts.size(); ++i)
        m_panels.charts[i]->setKind(shown.charts[i]->kind());
}

void MainWindow::showTitle()
{
    const ScenarioDocument& document = m_context.workspace.document();
    const auto asText = [](QString text) { // a place for the mark of changes it would be
        return text.replace(u"[*]"_s, u"[*][*]"_s);
    };
    const QString name = asText(QString::fromStdString(document.scenario().name));
    const QString path = document.filePath();
    QStringList parts{(path.isEmpty() ? tr("Untitled") : asText(QFileInfo(path).fileName())) +
                      u"[*]"_s};
    if (!name.isEmpty())
        parts << name;
    setWindowTitle((parts << u"Bergwatch"_s).join(u" - "_s));
    setWindowFilePath(document.filePath());
    setWindowModified(!document.isClean());
}

void MainWindow::finishLand() const
{
    m_panels.map->finishLand();
    if (m_panels.overview->isVisible())
        m_panels.overview->finishLand();
}

/** However it became one: by the menu, by the desktop, or as it was left. */
void MainWindow::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::WindowStateChange && m_parts)
        m_parts->menus.update();
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    event->setAccepted(m_parts->safety.mayClose());
    if (event->isAccepted())
        m_parts->docks.save();
}

/** Keys without a modifier belong to what has the focus, where they mean something to it. */
bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (goesToWindow(key, *watched)) {
            event->ignore();
            return true;
        }
        if (isPrintable(key) && isField(*watched)) {
            event->accept();
            return true;
        }
        const bool plain = key.modifiers() == Qt::NoModifier;
        const QWidget* focused = QApplication::focusWidget(); // its parents are asked after it
        if (key.matches(QKeySequence::Delete) && watched == focused && focused->window() == this &&
            !showsSelection(m_panels, *focused)) {
            event->accept();
            return true;
        }
        const bool isButton = qobject_cast<QAbstractButton*>(watched) != nullptr;
        const bool isList = qobject_cast<QComboBox*>(watched) != nullptr;
        if (plain && ((key.key() == Qt::Key_Space && (isButton || isList)) ||
                      (isList && key.text().size() == 1 && key.text().front().isLetter()))) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && opensMenu(static_cast<const QKeyEvent&>(*event)))
        if (auto* widget = qobject_cast<QWidget*>(watched)) {
            const QPoint middle = widget->rect().center();
            QContextMenuEvent menu(QContextMenuEvent::Keyboard, middle,
                                   widget->mapToGlobal(middle));
            QCoreApplication::sendEvent(widget, &menu);
            return true;
        }
    return QMainWindow::eventFilter(watched, event);
}

/** Esc that nothing else has a use for leaves the tool, whatever has the focus. */
void MainWindow::keyPressEvent(QKeyEvent* event)
{
    const QLineEdit* line = focusWidget() != nullptr ? lineOf(*focusWidget()) : nullptr;
    const bool isTyping = line != nullptr && line->isModified();
    if (event->key() != Qt::Key_Escape || event->modifiers() != Qt::NoModifier || isTyping)
        return QMainWindow::keyPressEvent(event);
    m_panels.map->setFocus();
    QCoreApplication::sendEvent(m_panels.map, event);
}

/** The next one that can be seen: a field behind another tab would be changed unseen. */
bool MainWindow::focusNextPrevChild(bool next)
{
    QWidget* to = nextInSight(*this, next);
    if (to != nullptr)
        to->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    return to != nullptr;
}

} // namespace berg
