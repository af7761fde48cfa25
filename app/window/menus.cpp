#include "app/window/menus.h"

#include "app/dialogs/interaction.h"
#include "app/layout/panels.h"
#include "app/window/window_parts.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/workspace/workspace.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace berg {

template <class Slot>
QAction* Menus::add(QMenu& menu, const ActionSpec& spec, const Slot& slot)
{
    return m_maker.add(menu, spec, this, slot);
}

template <class Slot>
QAction* Menus::addSwitch(QMenu& menu, const ActionSpec& spec, bool isOn, const Slot& slot)
{
    QAction* action = add(menu, spec, slot);
    action->setCheckable(true);
    action->setChecked(isOn);
    return action;
}

Menus::Menus(WindowContext& context, WindowParts& parts) : WindowPart(context), m_parts(parts)
{
    buildFileMenu();
    buildEditMenu();
    buildViewMenu();
    buildFlightMenu();
    buildToolBar();
    buildHelpMenu();
    connect(&workspace(), &Workspace::inFlightChanged, this, &Menus::updateActions);
    connect(&workspace().selection(), &Selection::changed, this, &Menus::updateActions);
    updateActions();
}

QMenu& Menus::addMenu(const QString& title)
{
    return *window().menuBar()->addMenu(title);
}

void Menus::buildFileMenu()
{
    QMenu& menu = addMenu(tr("&File"));
    add(menu, {"newAction", tr("&New scenario"), QKeySequence::New, IconName::NewFile},
        [this] { m_parts.dialogs.newScenario(); });
    add(menu, {"openAction", tr("&Open..."), QKeySequence::Open, IconName::Open},
        [this] { m_parts.files.openScenario(); });
    add(menu, {"startPageAction", tr("S&tart page")}, [this] { m_parts.start.showPage(); });
    QMenu& recent = *menu.addMenu(tr("Open &recent"));
    connect(&recent, &QMenu::aboutToShow, this,
            [this, &recent] { m_parts.files.fillRecentMenu(recent); });
    add(menu, {"importAction", tr("&Import sightings..."), QKeySequence(Qt::CTRL | Qt::Key_I)},
        [this] { m_parts.sightings.chooseSightings(); });
    add(menu, {"airspaceAction", tr("Import airspa&ce...")},
        [this] { m_parts.sightings.chooseAirspace(); });
    menu.addSeparator();
    add(menu, {"saveAction", tr("&Save"), QKeySequence::Save, IconName::Save},
        [this] { m_parts.files.saveScenario(); });
    add(menu, {"saveAsAction", tr("Save &as..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
        [this] { m_parts.files.saveScenarioAs(); });
    addSwitch(menu, {"keepOldAction", tr("Keep a &backup copy")}, m_parts.files.keepsOld(),
              [this](bool on) { m_parts.files.setKeepsOld(on); })
        ->setStatusTip(tr("Before the first overwrite of a file, a copy is kept as NAME.berg~"));
    add(menu, {"recoverAction", tr("Reco&ver unsaved work...")}, [this] {
        if (!m_parts.safety.offerRecoveries())
            showMessage(tr("There is no unsaved work to recover"), kMessage_ms);
    });
    add(menu, {"saveRunAction", tr("Save r&un..."), QKeySequence(Qt::CTRL | Qt::Key_R)},
        [this] { m_parts.results.saveRun(); });
    m_shared.exportPlan = add(menu,
                              {"exportAction", tr("&Export plan..."),
                               QKeySequence(Qt::CTRL | Qt::Key_E), IconName::ExportPlan},
                              [this] { m_parts.results.exportPlan(); });
    add(menu, {"briefAction", tr("Flight brie&f..."), QKeySequence::Print},
        [this] { m_parts.results.chooseExport("brief"); });
    m_shared.log = add(menu, {"logAction", tr("Flight &log...")},
                       [this] { m_parts.results.chooseExport("log"); });
    menu.addSeparator();
    add(menu, {"quitAction", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q)},
        [this] { window().close(); });
}

void Menus::buildEditMenu()
{
    QMenu& menu = addMenu(tr("&Edit"));
    m_shared.undo = m_parts.history.undo();
    m_shared.redo = m_parts.history.redo();
    m_maker.addIcon(m_shared.undo, IconName::Undo);
    m_maker.addIcon(m_shared.redo, IconName::Redo);
    menu.addActions({m_shared.undo, m_shared.redo});
    MapView* map = panels().map;
    menu.addSeparator();
    m_shared.cut = add(menu, {"cutAction", tr("Cu&t"), QKeySequence::Cut},
                       [map] { map->edits().cutSelected(); });
    m_shared.copy = add(menu, {"copyAction", tr("&Copy"), QKeySequence::Copy},
                        [map] { map->edits().copySelected(); });
    add(menu, {"pasteAction", tr("&Paste"), QKeySequence::Paste},
        [this] { m_parts.sightings.paste(); });
    add(menu,
        {"copyPictureAction", tr("Copy p&icture of the map"),
         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C)},
        [this] { m_parts.results.copyPicture(); });
    m_shared.duplicate =
        add(menu, {"duplicateAction", tr("Dup&licate"), QKeySequence(Qt::CTRL | Qt::Key_D)},
            [map] { map->edits().duplicateSelected(); });
    m_shared.remove = add(menu, {"deleteAction", tr("&Delete"), QKeySequence::Delete},
                          [map] { map->edits().deleteSelected(); });
    QAction* addUav =
        add(menu, {"addUavAction", tr("Add UA&V"), QKeySequence(Qt::CTRL | Qt::Key_U)},
            [map] { map->edits().addUav(); });
    m_shared.generate = add(menu, {"generateAction", tr("&Generate icebergs...")},
                            [this] { m_parts.dialogs.generateIcebergs(); });
    m_shared.selectAll =
        add(menu, {"selectAllAction", tr("Select &all icebergs"), QKeySequence::SelectAll},
            [map] { map->edits().selectAll(); });
    menu.addSeparator();
    QAction* move = add(menu, {"moveScenarioAction", tr("&Move the scenario…")}, [this] {
        m_parts.dialogs.moveScenario(workspace().document().scenario().origin);
    });
    m_editActions = {m_shared.cut, m_shared.duplicate, m_shared.remove,
                     addUav,       m_shared.generate,  move};
}

void Menus::buildViewMenu()
{
    QMenu& menu = addMenu(tr("&View"));
    buildMapActions(menu);
    add(menu, {"checksAction", tr("Chec&ks"), Qt::Key_F7},
        [this] { m_parts.checks.toggleChecks(); });
    add(menu, {"studyAction", tr("S&tudy")}, [this] { m_parts.study.showStudy(); });
    add(menu, {"solveTimeAction", tr("&Solve time")}, [this] { m_parts.solveTimes.show(); });
    menu.addSeparator();
    addLayouts(*menu.addMenu(tr("La&youts")));
    QMenu& docks = *menu.addMenu(tr("&Panels"));
    for (const QDockWidget* dock : m_parts.docks.all())
        docks.addAction(dock->toggleViewAction());
    add(menu, {"resetLayoutAction", tr("&Reset layout")}, [this] { m_parts.docks.reset(); });
    m_shared.fullScreen =
        addSwitch(menu, {"fullScreenAction", tr("F&ull screen"), Qt::Key_F11}, false, [this] {
            window().setWindowState(window().windowState() ^ Qt::WindowFullScreen);
        });
    menu.addSeparator();
    m_parts.preferences.build(menu);
}

void Menus::buildMapActions(QMenu& menu)
{
    MapView* map = panels().map;
    m_shared.fit = add(menu, {"fitAction", tr("&Fit everything"), Qt::Key_F, IconName::Fit},
                       [map] { map->fit(); });
    m_shared.follow =
        addSwitch(menu, {"followAction", tr("Follo&w the UAV"), Qt::Key_L, IconName::Follow}, false,
                  [map](bool on) { map->setFollowUav(on); });
    connect(map, &MapView::followUavChanged, m_shared.follow, &QAction::setChecked);
    add(menu, {"zoomInAction", tr("Zoom &in"), QKeySequence::ZoomIn},
        [map] { map->zoomBy(1.25, QRectF(map->rect()).center()); });
    add(menu, {"zoomOutAction", tr("Zoom &out"), QKeySequence::ZoomOut},
        [map] { map->zoomBy(0.8, QRectF(map->rect()).center()); });
    add(menu, {"findAction", tr("Find or &go to…"), QKeySequence::Find}, [this] {
        m_parts.dialogs.openFind();
    })->setShortcuts({QKeySequence::Find, QKeySequence(Qt::CTRL | Qt::Key_G)});
    addSwitch(menu, {"overviewAction", tr("O&verview"), Qt::Key_O},
              m_parts.mapLinks.overviewIsShown(),
              [this](bool on) { m_parts.mapLinks.setOverviewShown(on); });
    addPanelMenu(*menu.addMenu(tr("Panels on the map")));
    m_shared.sigmaEnd = menu.addMenu(tr("Colour scale of σ"));
    m_parts.preferences.buildSigmaEnd(*m_shared.sigmaEnd);
    add(menu, {"backdropAction", tr("&Background map…")}, [this] { m_parts.backdrop.choose(); });
    FlightView& flight = m_parts.flightView;
    MapController& links = m_parts.mapLinks;
    const auto addLayer = [&](const char* name, const QString& text, MapLayer layer) {
        QAction* action = addSwitch(menu, {name, text}, links.layerIsShown(layer),
                                    [&links, layer](bool on) { links.setLayerShown(layer, on); });
        connect(&links, &MapController::layersChanged, action,
                [&links, action, layer] { action->setChecked(links.layerIsShown(layer)); });
    };
    addLayer("sweptAction", tr("Swept ar&ea"), MapLayer::Swept);
    addLayer("placesAction", tr("Place names"), MapLayer::Places);
    addSwitch(menu, {"truthAction", tr("S&how true positions")}, flight.truthIsShown(),
              [&flight](bool on) { flight.setTruthShown(on); })
        ->setStatusTip(tr("Shows the true positions of the icebergs beside the estimates. When "
                          "off, the map shows only what an operator would see."));
}

void Menus::addLayouts(QMenu& menu)
{
    auto* layouts = new QActionGroup(&menu);
    const auto addLayout = [&](const char* name, const QString& text, Qt::Key key, Layout layout) {
        QAction* action = addSwitch(menu, {name, text, QKeySequence(Qt::CTRL | key)},
                                    m_parts.docks.layout() == layout,
                                    [this, layout] { m_parts.docks.showLayout(layout); });
        layouts->addAction(action);
        connect(&m_parts.docks, &Docks::layoutChanged, action,
                [action, layout](Layout shown) { action->setChecked(shown == layout); });
    };
    addLayout("planLayoutAction", tr("&Plan"), Qt::Key_1, Layout::Plan);
    addLayout("flyLayoutAction", tr("&Fly"), Qt::Key_2, Layout::Fly);
    addLayout("analyseLayoutAction", tr("&Analyse"), Qt::Key_3, Layout::Analyse);
}

void Menus::addPanelMenu(QMenu& menu)
{
    const auto add = [&](const char* name, const QString& text, MapPanel panel) {
        m_shared.panels[static_cast<std::size_t>(panel)] =
            addSwitch(menu, {name, text}, m_parts.mapLinks.panelIsShown(panel),
                      [this, panel](bool on) { m_parts.mapLinks.setPanelShown(panel, on); });
    };
    add("titlePanelAction", tr("&Title and figures"), MapPanel::Title);
    add("legendPanelAction", tr("&Legend"), MapPanel::Legend);
    add("scalePanelAction", tr("&Scale bar"), MapPanel::ScaleBar);
    add("northPanelAction", tr("&North arrow"), MapPanel::North);
    add("windPanelAction", tr("&Wind"), MapPanel::Wind);
}

void Menus::buildFlightMenu()
{
    QMenu& menu = addMenu(tr("F&light"));
    QAction* play = add(menu, {"playAction", tr("Fly"), Qt::Key_Space},
                        [this] { m_parts.flight.togglePlay(); });
    add(menu, {"stepAction", tr("&Step one second"), Qt::Key_Period},
        [this] { workspace().step(); });
    add(menu, {"resetAction", tr("Stop and &edit"), QKeySequence(Qt::CTRL | Qt::Key_Home)},
        [this] { workspace().reset(); });
    QAction* bringBack = add(menu,
                             {"bringBackAction", tr("Restore disc&arded flight"),
                              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Home)},
                             [this] { workspace().restoreFlight(); });
    menu.addSeparator();
    add(menu,
        {"shorterPlanAction", tr("Prefer s&horter route"), QKeySequence(Qt::ALT | Qt::Key_Right)},
        [this] { panels().tradeoff->stepPlan(+1); });
    add(menu,
        {"uncertainPlanAction", tr("Prefer more un&certain first"),
         QKeySequence(Qt::ALT | Qt::Key_Left)},
        [this] { panels().tradeoff->stepPlan(-1); });
    menu.addSeparator();
    m_shared.seen = add(menu, {"seenAction", tr("Report as seen no&w"), Qt::Key_N},
                        [this] { workspace().reportSeen(workspace().selection().ids()); });
    const auto addOrder = [&](const char* name, const QString& text, FlightOrder order) {
        m_shared.orders[order] =
            add(menu, {name, text}, [this, order] { workspace().order(orderedUavs(), order); });
    };
    addOrder("returnAction", tr("&Return home now"), FlightOrder::ReturnNow);
    addOrder("holdAction", tr("Hold here"), FlightOrder::HoldHere);
    addOrder("resumeAction", tr("Res&ume"), FlightOrder::None);
    m_shared.wind =
        add(menu, {"windAction", tr("Win&d..."), Qt::Key_W}, [this] { m_parts.dialogs.askWind(); });
    menu.addSeparator();
    buildLookBackActions(menu);
    menu.addSeparator();
    add(menu, {"fasterAction", tr("&Faster"), Qt::Key_BracketRight},
        [this] { panels().playback->stepRate(+1); });
    add(menu, {"slowerAction", tr("S&lower"), Qt::Key_BracketLeft},
        [this] { panels().playback->stepRate(-1); });

    menu.addSeparator();
    addSwitch(menu, {"alarmSoundAction", tr("S&ound alarms")}, m_parts.sound.isOn(),
              [this](bool on) { m_parts.sound.setOn(on); })
        ->setStatusTip(tr("A sound at each new alarm, until it is acknowledged"));

    const auto showPlaying = [this, play] {
        play->setText(workspace().isPlaying() ? tr("Pause") : tr("Fly"));
    };
    connect(&workspace(), &Workspace::flightChanged, this, showPlaying);
    showPlaying();
    const auto showDiscardedFlight = [this, bringBack] {
        bringBack->setEnabled(workspace().discardedFlight_s().has_value());
    };
    connect(&workspace(), &Workspace::discardedFlightChanged, this, showDiscardedFlight);
    showDiscardedFlight();
}

void Menus::buildLookBackActions(QMenu& menu)
{
    add(menu, {"stepBackAction", tr("Step &back one second"), Qt::Key_Comma},
        [this] { workspace().stepBack(); });
    add(menu, {"tickAction", tr("Step one &tick"), QKeySequence(Qt::CTRL | Qt::Key_Period)},
        [this] { workspace().stepTicks(+1); });
    add(menu, {"tickBackAction", tr("Step back one t&ick"), QKeySequence(Qt::CTRL | Qt::Key_Comma)},
        [this] { workspace().stepTicks(-1); });
    add(menu, {"nextEventAction", tr("&Next event"), QKeySequence(Qt::CTRL | Qt::Key_Right)},
        [this] { workspace().stepToEvent(+1); });
    add(menu, {"previousEventAction", tr("&Previous event"), QKeySequence(Qt::CTRL | Qt::Key_Left)},
        [this] { workspace().stepToEvent(-1); });
    add(menu, {"goToTimeAction", tr("&Go to time"), QKeySequence(Qt::CTRL | Qt::Key_T)},
        [this] { panels().playback->editTime(); });
    add(menu, {"newestAction", tr("Bac&k to latest"), QKeySequence(Qt::CTRL | Qt::Key_End)},
        [this] { workspace().seekLatest(); });
}

void Menus::buildHelpMenu()
{
    QMenu& menu = addMenu(tr("&Help"));
    add(menu, {"manualAction", tr("&Manual"), QKeySequence::HelpContents},
        [this] { m_parts.manual.open(); });
    add(menu, {"shortcutsAction", tr("Keyboard &shortcuts"), Qt::Key_Question},
        [this] { showShortcuts(); });
    add(menu, {"tourAction", tr("&Tour")}, [this] { m_parts.start.startTour(); });
    add(menu, {"aboutAction", tr("&About Bergwatch")}, [this] { showAbout(); });
}

void Menus::addTool(QActionGroup& tools, MapToolKind kind, const ActionSpec& spec)
{
    QAction* action = tools.addAction(spec.text);
    action->setObjectName(QLatin1String(spec.name));
    action->setShortcut(spec.shortcut);
    action->setCheckable(true);
    action->setToolTip(u"%1 (%2)"_s.arg(spec.text, spec.shortcut.toString()));
    action->setData(static_cast<int>(kind));
    m_maker.addIcon(action, *spec.icon);
    if (isLockedInFlight(kind))
        m_editActions.push_back(action);
    connect(action, &QAction::triggered, this, [this, kind] { panels().map->setTool(kind); });
}

void Menus::buildToolBar()
{
    QToolBar* bar = window().addToolBar(tr("Tools"));
    bar->setObjectName(u"toolBar"_s);
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* tools = new QActionGroup(&window());
    addTool(*tools, MapToolKind::Select, {"selectTool", tr("Select"), Qt::Key_S, IconName::Select});
    addTool(*tools, MapToolKind::Iceberg,
            {"icebergTool", tr("Iceberg"), Qt::Key_I, IconName::Iceberg});
    addTool(*tools, MapToolKind::Uav, {"uavTool", tr("UAV"), Qt::Key_U, IconName::Uav});
    addTool(*tools, MapToolKind::Asset, {"assetTool", tr("Asset"), Qt::Key_A, IconName::Asset});
    addTool(*tools, MapToolKind::Area, {"areaTool", tr("Area"), Qt::Key_R, IconName::Area});
    addTool(*tools, MapToolKind::NoFly,
            {"noFlyTool", tr("No-fly area"), Qt::Key_X, IconName::NoFly});
    addTool(*tools, MapToolKind::Measure,
            {"measureTool", tr("Measure"), Qt::Key_M, IconName::Measure});
    addTool(*tools, MapToolKind::Pan, {"panTool", tr("Pan"), Qt::Key_H, IconName::Pan});
    tools->actions().front()->setChecked(true);
    connect(panels().map, &MapView::toolChanged, tools, [tools](MapToolKind kind) {
        for (QAction* action : tools->actions())
            action->setChecked(action->data().toInt() == static_cast<int>(kind));
    });
    bar->addActions(tools->actions());
    for (const auto& group : {std::vector{m_shared.undo, m_shared.redo},
                              {m_shared.fit, m_shared.follow},
                              {m_shared.exportPlan}}) {
        bar->addSeparator();
        for (QAction* action : group) {
            bar->addAction(action);
            // There is room for the names of the tools; those of commands are in the menus.
            if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
                button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        }
    }
    QMenu& menu = addMenu(tr("&Tools"));
    menu.addActions(tools->actions());
    menu.addSeparator();
    m_parts.preferences.buildSources(*menu.addMenu(tr("&New icebergs seen by")));
}

void Menus::updateActions()
{
    const bool locked = workspace().inFlight();
    for (QAction* action : m_editActions)
        action->setEnabled(!locked);
    m_shared.log->setEnabled(locked);
    const std::vector<std::string>& ids = workspace().selection().ids();
    m_shared.remove->setEnabled(locked ? !workspace().icebergsInFlight(ids).empty() : !ids.empty());
    const Scenario& scenario = workspace().document().scenario();
    const bool hasIcebergs = !icebergsOf(scenario, ids).empty();
    m_shared.copy->setEnabled(hasIcebergs);
    m_shared.seen->setEnabled(locked && !workspace().icebergsInFlight(ids).empty());
    for (const auto& [order, action] : m_shared.orders)
        action->setEnabled(locked && !orderedUavs().empty());
    m_shared.cut->setEnabled(!locked && hasIcebergs);
    m_shared.duplicate->setEnabled(!locked && (hasIcebergs || !uavsOf(scenario, ids).empty()));
}

/** The selected ones; the only one there is needs no selection. */
std::vector<std::string> Menus::orderedUavs() const
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    if (uavs.size() == 1)
        return {uavs.front().id};
    std::vector<std::string> ids;
    for (const Uav& uav : uavs)
        if (workspace().selection().contains(uav.id))
            ids.push_back(uav.id);
    return ids;
}

void Menus::showShortcuts()
{
    QStringList cells;
    const auto add = [&](const QString& what, const QString& how) {
        cells << u"<td>%1</td><td style='padding-left:16px; padding-right:32px'><b>%2</b></td>"_s
                     .arg(what.toHtmlEscaped(), how.toHtmlEscaped());
    };
    for (const MenuCommand& command : menuCommands(*window().menuBar()))
        if (const auto keys = command.action->shortcuts(); !keys.isEmpty())
            add(nameInGroup(command), QKeySequence::listToString(keys, QKeySequence::NativeText));
    add(tr("Values of a chart as a table"), u"V"_s);
    add(tr("Zoom at the cursor"), tr("wheel"));
    add(tr("Pan"), tr("middle button, or arrow keys"));
    add(tr("Nudge what is selected"), tr("arrow keys"));
    add(tr("Finish drawing, undo last point"), tr("Enter, Backspace"));
    add(tr("Steps of 15° while an arrow is drawn"), tr("Shift"));
    add(tr("Cancel drawing, leave tool, clear selection"), tr("Esc"));
    const qsizetype half = (cells.size() + 1) / 2; // two beside each other
    QString rows;
    for (qsizetype row = 0; row < half; ++row)
        rows += u"<tr>%1%2</tr>"_s.arg(cells[row], cells.value(row + half));
    interaction().showInformation(&window(), tr("Shortcuts"), u"<table>%1</table>"_s.arg(rows));
}

void Menus::showAbout()
{
    interaction().showInformation(
        &window(), tr("About Bergwatch"),
        tr("<h3>Bergwatch %1</h3><p>Plans and simulates UAV missions that monitor drifting "
           "icebergs.</p><p>Own code: MIT licence. Qt Charts: GPL 3. COIN-OR CBC: EPL. Land made "
           "with Natural Earth.</p>")
            .arg(QApplication::applicationVersion()));
}

void Menus::refreshIcons() const
{
    m_maker.refreshIcons(theme());
    // Qt's own drawing is near black in every appearance.
    if (auto* more = window().findChild<QToolButton*>(u"qt_toolbar_ext_button"_s))
        more->setIcon(icon(IconName::More, theme()));
}

} // namespace berg
