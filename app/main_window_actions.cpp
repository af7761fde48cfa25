#include "app/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/map/overview_inset.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/solve_time_panel.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace berg {

template <class Slot>
QAction* MainWindow::addAction(QMenu& menu, const ActionSpec& spec, const Slot& slot)
{
    QAction* action = menu.addAction(spec.text);
    action->setObjectName(QLatin1String(spec.name));
    action->setShortcut(spec.shortcut);
    action->setStatusTip(QString(spec.text).remove(u'&'));
    if (spec.icon)
        m_icons.emplace_back(action, *spec.icon);
    connect(action, &QAction::triggered, this, slot);
    return action;
}

void MainWindow::buildActions()
{
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildFlightMenu();
    buildToolBar();
    buildHelpMenu();
}

void MainWindow::buildFileMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&File"));
    addAction(menu, {"newAction", tr("&New scenario"), QKeySequence::New, IconName::NewFile},
              [this] { newScenario(); });
    addAction(menu, {"openAction", tr("&Open..."), QKeySequence::Open, IconName::Open},
              [this] { openScenario(); });
    addAction(menu, {"startPageAction", tr("S&tart page"), {}, std::nullopt},
              [this] { showStartPage(); });
    m_recentMenu = menu.addMenu(tr("Open &recent"));
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    addAction(menu,
              {"importAction", tr("&Import sightings..."), QKeySequence(Qt::CTRL | Qt::Key_I),
               std::nullopt},
              [this] { chooseSightings(); });
    menu.addSeparator();
    addAction(menu, {"saveAction", tr("&Save"), QKeySequence::Save, IconName::Save},
              [this] { saveScenario(); });
    addAction(menu,
              {"saveAsAction", tr("Save &as..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
               std::nullopt},
              [this] { saveScenarioAs(); });
    QAction* keepOld =
        addAction(menu, {"keepOldAction", tr("Keep a &backup copy"), {}, std::nullopt},
                  [this](bool on) { m_settings.setValue(kKeepOldKey, on); });
    keepOld->setCheckable(true);
    keepOld->setChecked(m_settings.value(kKeepOldKey, true).toBool());
    keepOld->setStatusTip(tr("Before a file is first overwritten, a copy is kept as NAME.berg~"));
    addAction(menu, {"recoverAction", tr("Reco&ver unsaved work..."), {}, std::nullopt}, [this] {
        if (!offerRecoveries())
            statusBar()->showMessage(tr("No unsaved work is left to recover"), 4000);
    });
    addAction(
        menu,
        {"saveRunAction", tr("Save r&un..."), QKeySequence(Qt::CTRL | Qt::Key_R), std::nullopt},
        [this] { saveRun(); });
    addAction(menu,
              {"exportAction", tr("&Export plan..."), QKeySequence(Qt::CTRL | Qt::Key_E),
               IconName::ExportPlan},
              [this] { exportPlan(); });
    menu.addSeparator();
    addAction(menu, {"quitAction", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), std::nullopt},
              [this] { close(); });
}

void MainWindow::buildEditMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
    QUndoStack* history = m_workspace.document().undoStack();
    QAction* undo = history->createUndoAction(this, tr("&Undo"));
    QAction* redo = history->createRedoAction(this, tr("&Redo"));
    undo->setIconText(tr("Undo")); // what would be undone is in the menu; the tool bar stands still
    redo->setIconText(tr("Redo"));
    undo->setObjectName(u"undoAction"_s);
    redo->setObjectName(u"redoAction"_s);
    undo->setShortcut(QKeySequence::Undo);
    redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    m_icons.emplace_back(undo, IconName::Undo);
    m_icons.emplace_back(redo, IconName::Redo);
    menu.addActions({undo, redo});
    // While something is drawn on the map, what is undone is its last point.
    disconnect(undo, &QAction::triggered, history, nullptr);
    connect(undo, &QAction::triggered, this, [this] {
        if (m_map->isDrawing())
            m_map->takeLastBack();
        else
            m_workspace.document().undo();
    });
    disconnect(redo, &QAction::triggered, history, nullptr);
    connect(redo, &QAction::triggered, &m_workspace.document(), &ScenarioDocument::redo);
    connect(history, &QUndoStack::indexChanged, this, &MainWindow::updateActions,
            Qt::QueuedConnection);
    menu.addSeparator();
    QAction* cut = addAction(menu, {"cutAction", tr("Cu&t"), QKeySequence::Cut, std::nullopt},
                             [this] { m_map->cutSelected(); });
    addAction(menu, {"copyAction", tr("&Copy"), QKeySequence::Copy, std::nullopt},
              [this] { m_map->copySelected(); });
    QAction* paste =
        addAction(menu, {"pasteAction", tr("&Paste"), QKeySequence::Paste, std::nullopt},
                  [this] { m_map->paste(); });
    QAction* duplicate = addAction(
        menu,
        {"duplicateAction", tr("Dup&licate"), QKeySequence(Qt::CTRL | Qt::Key_D), std::nullopt},
        [this] { m_map->duplicateSelected(); });
    QAction* remove =
        addAction(menu, {"deleteAction", tr("&Delete"), QKeySequence::Delete, std::nullopt},
                  [this] { m_map->deleteSelected(); });
    m_editActions = {undo, redo, cut, paste, duplicate, remove};
    m_editActions.push_back(addAction(
        menu, {"addUavAction", tr("Add UA&V"), QKeySequence(Qt::CTRL | Qt::Key_U), std::nullopt},
        [this] { m_map->addUav(); }));
    m_editActions.push_back(
        addAction(menu, {"generateAction", tr("&Generate icebergs..."), {}, std::nullopt},
                  [this] { generateIcebergs(); }));
    addAction(
        menu,
        {"selectAllAction", tr("Select &all icebergs"), QKeySequence::SelectAll, std::nullopt},
        [this] { m_map->selectAll(); });
    menu.addSeparator();
    m_editActions.push_back(
        addAction(menu, {"moveScenarioAction", tr("&Move the scenario…"), {}, std::nullopt},
                  [this] { moveScenario(m_workspace.document().scenario().origin); }));
}

void MainWindow::addChoice(QMenu& menu, const QString& text, const QString& key,
                           const QString& value)
{
    auto* group = menu.findChild<QActionGroup*>();
    if (group == nullptr)
        group = new QActionGroup(&menu);
    QAction* action = group->addAction(text);
    action->setCheckable(true);
    action->setData(value);
    action->setObjectName(key + u'-' + value);
    const QString first = group->actions().front()->data().toString();
    action->setChecked(value == m_settings.value(key, first).toString());
    menu.addAction(action);
}

void MainWindow::buildViewMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&View"));
    addAction(menu, {"fitAction", tr("&Fit everything"), Qt::Key_F, IconName::Fit},
              [this] { m_map->fit(); });
    m_followAction =
        addAction(menu, {"followAction", tr("Follo&w the UAV"), Qt::Key_L, IconName::Follow},
                  [this](bool on) { m_map->setFollowUav(on); });
    m_followAction->setCheckable(true);
    addAction(menu, {"zoomInAction", tr("Zoom &in"), QKeySequence::ZoomIn, std::nullopt},
              [this] { m_map->zoomBy(1.25, QRectF(m_map->rect()).center()); });
    addAction(menu, {"zoomOutAction", tr("Zoom &out"), QKeySequence::ZoomOut, std::nullopt},
              [this] { m_map->zoomBy(0.8, QRectF(m_map->rect()).center()); });
    addAction(
        menu,
        {"gotoAction", tr("&Go to a place"), QKeySequence(Qt::CTRL | Qt::Key_G), std::nullopt},
        [this] { openGoto(); });
    QAction* overview = addAction(
        menu, {"overviewAction", tr("O&verview"), Qt::Key_O, std::nullopt}, [this](bool on) {
            m_settings.setValue("view/overview", on);
            m_map->setInset(on ? m_overview : nullptr);
            showOverview();
        });
    overview->setCheckable(true);
    overview->setChecked(m_settings.value("view/overview", false).toBool());
    m_map->setInset(overview->isChecked() ? m_overview : nullptr);
    m_sweptAction =
        addAction(menu, {"sweptAction", tr("Swept ar&ea"), {}, std::nullopt}, [this](bool on) {
            m_settings.setValue("view/swept", on);
            showFlight();
        });
    m_sweptAction->setCheckable(true);
    m_sweptAction->setChecked(m_settings.value("view/swept", true).toBool());
    m_truthAction = addAction(menu, {"truthAction", tr("S&how true positions"), {}, std::nullopt},
                              [this](bool on) {
                                  m_settings.setValue("view/truth", on);
                                  showFlight();
                              });
    m_truthAction->setCheckable(true);
    m_truthAction->setChecked(m_settings.value("view/truth", true).toBool());
    m_truthAction->setStatusTip(tr("Where the icebergs are in truth, beside where the observer "
                                   "believes them to be; off: only what an operator would see"));
    addAction(menu, {"checksAction", tr("Chec&ks"), Qt::Key_F7, std::nullopt},
              [this] { openChecks(); });
    addAction(menu, {"studyAction", tr("S&tudy of τ and policies"), {}, std::nullopt},
              [this] { showStudy(); });
    addAction(menu, {"solveTimeAction", tr("&Solve time study"), {}, std::nullopt},
              [this] { openStudyDock(u"solveTimeDock"_s, m_solveTime->sizeHint()); });
    menu.addSeparator();
    QMenu& panels = *menu.addMenu(tr("&Panels"));
    for (QDockWidget* dock : m_docks)
        panels.addAction(dock->toggleViewAction());
    addAction(menu, {"resetLayoutAction", tr("&Reset layout"), {}, std::nullopt},
              [this] { restoreState(m_defaultLayout, kLayoutVersion); });
    QAction* fullScreen =
        addAction(menu, {"fullScreenAction", tr("F&ull screen"), Qt::Key_F11, std::nullopt},
                  [this](bool on) { on ? showFullScreen() : showNormal(); });
    fullScreen->setCheckable(true);
    menu.addSeparator();
    QMenu& appearance = *menu.addMenu(tr("&Appearance"));
    const QStringList words{tr("Follow system"), tr("Light"), tr("Dark")};
    for (qsizetype i = 0; i < words.size(); ++i)
        addChoice(appearance, words[i], u"view/appearance"_s, QString::number(i));
    connect(&appearance, &QMenu::triggered, this, [this](QAction* action) {
        setAppearance(static_cast<Appearance>(action->data().toInt()));
    });
    buildUnitMenu(*menu.addMenu(tr("U&nits")));
    QMenu& language = *menu.addMenu(tr("&Language"));
    addChoice(language, tr("Follow system"), u"view/language"_s, u""_s);
    addChoice(language, u"English"_s, u"view/language"_s, u"en"_s);
    addChoice(language, u"Norsk bokmål"_s, u"view/language"_s, u"nb"_s);
    connect(&language, &QMenu::triggered, this, [this](QAction* action) {
        m_settings.setValue("view/language", action->data());
        emit languageChosen(action->data().toString());
    });
}

void MainWindow::buildFlightMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("F&light"));
    m_playAction = addAction(menu, {"playAction", tr("Fly"), Qt::Key_Space, std::nullopt},
                             [this] { togglePlay(); });
    addAction(menu, {"stepAction", tr("&Step one second"), Qt::Key_Period, std::nullopt},
              [this] { m_workspace.step(); });
    addAction(
        menu,
        {"resetAction", tr("Stop and &edit"), QKeySequence(Qt::CTRL | Qt::Key_Home), std::nullopt},
        [this] { m_workspace.reset(); });
    addAction(menu,
              {"bringBackAction", tr("Bring the flight b&ack"),
               QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Home), std::nullopt},
              [this] { m_workspace.bringBackFlight(); });
    menu.addSeparator();
    addAction(menu,
              {"shorterPlanAction", tr("Prefer s&horter route"),
               QKeySequence(Qt::ALT | Qt::Key_Right), std::nullopt},
              [this] { m_tradeoff->stepPlan(+1); });
    addAction(menu,
              {"uncertainPlanAction", tr("Prefer more un&certain first"),
               QKeySequence(Qt::ALT | Qt::Key_Left), std::nullopt},
              [this] { m_tradeoff->stepPlan(-1); });
    menu.addSeparator();
    addAction(menu, {"seenAction", tr("Report as seen no&w"), Qt::Key_N, std::nullopt},
              [this] { m_workspace.reportSeen(m_workspace.selection().ids()); });
    addAction(menu, {"windAction", tr("Win&d..."), Qt::Key_W, std::nullopt}, [this] { askWind(); });
    menu.addSeparator();
    addAction(menu, {"stepBackAction", tr("Step &back one second"), Qt::Key_Comma, std::nullopt},
              [this] { m_workspace.stepBack(); });
    addAction(
        menu,
        {"tickAction", tr("Step one &tick"), QKeySequence(Qt::CTRL | Qt::Key_Period), std::nullopt},
        [this] { m_workspace.stepTicks(+1); });
    addAction(menu,
              {"tickBackAction", tr("Step back one t&ick"), QKeySequence(Qt::CTRL | Qt::Key_Comma),
               std::nullopt},
              [this] { m_workspace.stepTicks(-1); });
    addAction(menu,
              {"nextEventAction", tr("&Next event"), QKeySequence(Qt::CTRL | Qt::Key_Right),
               std::nullopt},
              [this] { m_workspace.stepToEvent(+1); });
    addAction(menu,
              {"previousEventAction", tr("&Previous event"), QKeySequence(Qt::CTRL | Qt::Key_Left),
               std::nullopt},
              [this] { m_workspace.stepToEvent(-1); });
    addAction(
        menu,
        {"goToTimeAction", tr("&Go to time"), QKeySequence(Qt::CTRL | Qt::Key_T), std::nullopt},
        [this] { m_playback->editTime(); });
    addAction(
        menu,
        {"newestAction", tr("Newest pict&ure"), QKeySequence(Qt::CTRL | Qt::Key_End), std::nullopt},
        [this] { m_workspace.lookAtNewest(); });
    menu.addSeparator();
    addAction(menu, {"fasterAction", tr("&Faster"), Qt::Key_BracketRight, std::nullopt},
              [this] { m_playback->stepRate(+1); });
    addAction(menu, {"slowerAction", tr("S&lower"), Qt::Key_BracketLeft, std::nullopt},
              [this] { m_playback->stepRate(-1); });
}

void MainWindow::buildHelpMenu()
{
    QMenu& menu = *menuBar()->addMenu(tr("&Help"));
    addAction(menu, {"shortcutsAction", tr("&Shortcuts"), Qt::Key_Question, std::nullopt},
              [this] { showShortcuts(); });
    addAction(menu, {"tourAction", tr("&Tour"), {}, std::nullopt}, [this] { startTour(); });
    addAction(menu, {"aboutAction", tr("&About Bergwatch"), {}, std::nullopt},
              [this] { showAbout(); });
}

void MainWindow::addTool(MapToolKind kind, const ActionSpec& spec)
{
    QAction* action = m_tools->addAction(spec.text);
    action->setObjectName(QLatin1String(spec.name));
    action->setShortcut(spec.shortcut);
    action->setCheckable(true);
    action->setToolTip(u"%1 (%2)"_s.arg(spec.text, spec.shortcut.toString()));
    action->setData(static_cast<int>(kind));
    m_icons.emplace_back(action, *spec.icon);
    if (isLockedInFlight(kind))
        m_editActions.push_back(action);
    connect(action, &QAction::triggered, this, [this, kind] { m_map->setTool(kind); });
}

void MainWindow::buildToolBar()
{
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(u"toolBar"_s);
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_tools = new QActionGroup(this);
    addTool(MapToolKind::Select, {"selectTool", tr("Select"), Qt::Key_S, IconName::Select});
    addTool(MapToolKind::Iceberg, {"icebergTool", tr("Iceberg"), Qt::Key_I, IconName::Iceberg});
    addTool(MapToolKind::Uav, {"uavTool", tr("UAV"), Qt::Key_U, IconName::Uav});
    addTool(MapToolKind::Asset, {"assetTool", tr("Asset"), Qt::Key_A, IconName::Asset});
    addTool(MapToolKind::Area, {"areaTool", tr("Area"), Qt::Key_R, IconName::Area});
    addTool(MapToolKind::Measure, {"measureTool", tr("Measure"), Qt::Key_M, IconName::Measure});
    addTool(MapToolKind::Pan, {"panTool", tr("Pan"), Qt::Key_H, IconName::Pan});
    m_tools->actions().front()->setChecked(true);
    connect(m_map, &MapView::toolChanged, this, [this](MapToolKind kind) {
        for (QAction* action : m_tools->actions())
            if (action->data().toInt() == static_cast<int>(kind))
                action->setChecked(true);
    });
    bar->addActions(m_tools->actions());
    const QStringList groups[] = {{u"undoAction"_s, u"redoAction"_s},
                                  {u"fitAction"_s, u"followAction"_s},
                                  {u"exportAction"_s}};
    for (const QStringList& group : groups) {
        bar->addSeparator();
        for (const QString& name : group) {
            auto* action = findChild<QAction*>(name);
            bar->addAction(action);
            // There is room for the names of the tools; those of commands are in the menus.
            if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
                button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        }
    }
    QMenu& edit = *menuBar()->addMenu(tr("&Tools"));
    edit.addActions(m_tools->actions());
}

void MainWindow::refreshIcons()
{
    for (const auto& [action, name] : m_icons)
        action->setIcon(icon(name, m_theme));
}

void MainWindow::updateActions()
{
    const bool locked = m_workspace.inFlight();
    const QUndoStack* history = m_workspace.document().undoStack();
    for (QAction* action : m_editActions)
        action->setEnabled(!locked);
    findChild<QAction*>(u"undoAction"_s)
        ->setEnabled(m_map->isDrawing() || (!locked && history->canUndo()));
    findChild<QAction*>(u"redoAction"_s)->setEnabled(!locked && history->canRedo());
    findChild<QAction*>(u"deleteAction"_s)
        ->setEnabled(!locked && !m_workspace.selection().isEmpty());
    const std::vector<std::string>& ids = m_workspace.selection().ids();
    const Scenario& scenario = m_workspace.document().scenario();
    const bool hasIcebergs = !icebergsOf(scenario, ids).empty();
    findChild<QAction*>(u"copyAction"_s)->setEnabled(hasIcebergs);
    findChild<QAction*>(u"seenAction"_s)
        ->setEnabled(locked && !m_workspace.flownAmong(ids).empty());
    findChild<QAction*>(u"cutAction"_s)->setEnabled(!locked && hasIcebergs);
    findChild<QAction*>(u"duplicateAction"_s)
        ->setEnabled(!locked && (hasIcebergs || !uavsOf(scenario, ids).empty()));
}

void MainWindow::showShortcuts()
{
    QString rows;
    for (const QAction* action : findChildren<QAction*>())
        if (!action->shortcut().isEmpty() && !action->text().isEmpty())
            rows += u"<tr><td style='padding-right:24px'>%1</td><td><b>%2</b></td></tr>"_s.arg(
                QString(action->text()).remove(u'&').toHtmlEscaped(),
                action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped());
    const auto row = [](const QString& what, const QString& how) {
        return u"<tr><td style='padding-right:24px'>%1</td><td><b>%2</b></td></tr>"_s.arg(what,
                                                                                          how);
    };
    rows += row(tr("Zoom at the cursor"), tr("wheel"));
    rows += row(tr("Pan"), tr("middle button, or arrow keys"));
    rows += row(tr("Nudge what is selected"), tr("arrow keys"));
    rows += row(tr("Close what is drawn, take its last point back"), tr("Enter, Backspace"));
    rows += row(tr("Steps of 15° while an arrow is drawn"), tr("Shift"));
    rows += row(tr("Leave what is drawn, the tool, the selection"), tr("Esc"));
    m_interaction.showInformation(this, tr("Shortcuts"), u"<table>%1</table>"_s.arg(rows));
}

void MainWindow::showAbout()
{
    m_interaction.showInformation(
        this, tr("About Bergwatch"),
        tr("<h3>Bergwatch %1</h3><p>Plans, flies and measures UAV missions that keep watch over "
           "drifting icebergs.</p><p>Own code: MIT licence. Qt Charts: GPL 3. COIN-OR CBC: "
           "EPL. Land made with Natural Earth.</p>")
            .arg(QApplication::applicationVersion()));
}

} // namespace berg
