#include "app/window/menus.h"

#include "app/dialogs/interaction.h"
#include "app/flight/flight_connections.h"
#include "app/layout/panels.h"
#include "app/window/checks_view.h"
#include "app/window/window_parts.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/panels/study/start_panel.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/words/intervention_text.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

using Key = QKeySequence;
const Command kLine;

} // namespace

Menus::Menus(WindowContext& context, WindowParts& parts)
    : WindowPart(context), m_parts(parts), m_actions(window())
{
    const auto add = [this](const QString& title, const std::vector<Command>& commands) -> QMenu& {
        QMenu& menu = *window().menuBar()->addMenu(title);
        m_actions.add(menu, commands);
        return menu;
    };
    add(tr("&File"), fileCommands());
    add(tr("&Edit"), editCommands());
    QMenu& view = add(tr("&View"), mapCommands());
    m_actions.add(view, viewCommands());
    m_parts.preferences.build(view);
    add(tr("F&light"), flightCommands());
    add(tr("&Tools"), tools());
    add(tr("&Help"), helpCommands());
    buildToolBar();
    followState();
}

std::vector<Command> Menus::fileCommands()
{
    WindowParts& p = m_parts;
    const auto recover = [this] {
        if (!m_parts.safety.offerRecoveries())
            showMessage(tr("There is no unsaved work to recover"), kMessage_ms);
    };
    return {
        {"newAction", tr("&New scenario"), [&p] { p.dialogs.newScenario(); }, Key::New,
         IconName::NewFile},
        {"openAction", tr("&Open..."), [&p] { p.files.openScenario(); }, Key::Open, IconName::Open},
        {"startPageAction", tr("S&tart page"), [&p] { p.start.showPage(); }},
        {tr("Open &recent"),
         [this](QMenu& menu) {
             connect(&menu, &QMenu::aboutToShow, this,
                     [this, &menu] { m_parts.files.fillRecentMenu(menu); });
         }},
        {"importAction", tr("&Import sightings..."), [&p] { p.sightings.chooseSightings(); },
         "Ctrl+I"},
        {"airspaceAction", tr("Import airspa&ce..."), [&p] { p.sightings.chooseAirspace(); }},
        {"forecastAction", tr("I&mport forecast..."), [&p] { p.dialogs.askForecast(); }},
        {"iceChartAction", tr("Import ice c&hart..."), [&p] { p.sightings.chooseIceChart(); }},
        kLine,
        {"saveAction", tr("&Save"), [&p] { p.files.saveScenario(); }, Key::Save, IconName::Save},
        {"saveAsAction", tr("Save &as..."), [&p] { p.files.saveScenarioAs(); }, "Ctrl+Shift+S"},
        {"keepOldAction", tr("Keep a &backup copy"),
         tr("Before the first overwrite of a file, a copy is kept as NAME.berg~"),
         switchOf(p.files, &ScenarioFiles::keepsOld, &ScenarioFiles::setKeepsOld)},
        {"recoverAction", tr("Reco&ver unsaved work..."), recover},
        {"saveRunAction", tr("Save r&un..."), [&p] { p.results.saveRun(); }, "Ctrl+R"},
        {"exportAction", tr("&Export plan..."), [&p] { p.results.exportPlan(); }, "Ctrl+E",
         IconName::ExportPlan},
        {"briefAction", tr("Flight brie&f..."), [&p] { p.results.chooseExport("brief"); },
         Key::Print},
        {"logAction", tr("Flight &log..."), [&p] { p.results.chooseExport("log"); },
         When::InFlight},
        kLine,
        {"quitAction", tr("&Quit"), [this] { window().close(); }, "Ctrl+Q"},
    };
}

std::vector<Command> Menus::editCommands()
{
    WindowParts& p = m_parts;
    MapEdits& edits = panels().map->edits();
    const auto redo = [this] {
        panels().finishTyping();
        workspace().document().redo();
    };
    return {
        {"undoAction", tr("&Undo"), [this] { undo(); }, When::Undoable, Key::Undo, IconName::Undo},
        {"redoAction", tr("&Redo"), redo, When::Redoable, "Ctrl+Shift+Z; Ctrl+Y", IconName::Redo},
        kLine,
        {"cutAction", tr("Cu&t"), [&edits] { edits.cutSelected(); },
         When::Unlocked | When::IcebergsSelected, Key::Cut},
        {"copyAction", tr("&Copy"), [&edits] { edits.copySelected(); }, When::IcebergsSelected,
         Key::Copy},
        {"pasteAction", tr("&Paste"), [&p] { p.sightings.paste(); }, Key::Paste},
        {"copyPictureAction", tr("Copy p&icture of the map"), [&p] { p.results.copyPicture(); },
         "Ctrl+Shift+C"},
        {"duplicateAction", tr("Dup&licate"), [&edits] { edits.duplicateSelected(); },
         When::Unlocked | When::CopiesSelected, "Ctrl+D"},
        {"deleteAction", tr("&Delete"), [&edits] { edits.deleteSelected(); }, When::Removable,
         Key::Delete},
        {"addUavAction", tr("Add UA&V"), [&edits] { edits.addUav(); }, When::Unlocked, "Ctrl+U"},
        {"generateAction", tr("&Generate icebergs..."), [&p] { p.dialogs.generateIcebergs(); },
         When::Unlocked},
        {"selectAllAction", tr("Select &all icebergs"), [&edits] { edits.selectAll(); },
         Key::SelectAll},
        kLine,
        {"moveScenarioAction", tr("&Move the scenario…"),
         [this] { m_parts.dialogs.moveScenario(workspace().document().scenario().origin); },
         When::Unlocked},
    };
}

std::vector<Command> Menus::mapCommands()
{
    WindowParts& p = m_parts;
    const MapView* map = panels().map;
    MapCamera& camera = panels().map->camera();
    const auto zoom = [&camera, map](double factor) {
        camera.zoomBy(factor, QRectF(map->rect()).center());
    };
    const auto layer = [&p](MapLayer layer) {
        return Switch{[&p, layer] { return p.mapLinks.layerIsShown(layer); },
                      [&p, layer](bool on) { p.mapLinks.setLayerShown(layer, on); }};
    };
    return {
        {"fitAction", tr("&Fit everything"), [&camera] { camera.fit(); }, "F", IconName::Fit},
        {"followAction", tr("Follo&w the UAV"),
         switchOf(camera, &MapCamera::followsUav, &MapCamera::setFollowUav), "L", IconName::Follow},
        {"zoomInAction", tr("Zoom &in"), [zoom] { zoom(1.25); }, Key::ZoomIn},
        {"zoomOutAction", tr("Zoom &out"), [zoom] { zoom(0.8); }, Key::ZoomOut},
        {"findAction", tr("Find or &go to…"), [&p] { p.dialogs.openFind(); }, "Ctrl+F; Ctrl+G"},
        {"overviewAction", tr("O&verview"),
         switchOf(p.mapLinks, &MapController::overviewIsShown, &MapController::setOverviewShown),
         "O"},
        {tr("Panels on the map"), [this](QMenu& menu) { m_actions.add(menu, mapPanels()); }},
        {tr("Colour scale of σ"), [&p](QMenu& menu) { p.preferences.buildSigmaEnd(menu); }},
        {"backdropAction", tr("&Background map…"), [&p] { p.backdrop.choose(); }},
        {"sweptAction", tr("Swept ar&ea"), layer(MapLayer::Swept)},
        {"placesAction", tr("Place names"), layer(MapLayer::Places)},
        {"iceChartLayerAction", tr("Ice chart"), layer(MapLayer::IceChart)},
        {"windLayerAction", tr("Forecast wind"), layer(MapLayer::Wind)},
        {"currentLayerAction", tr("Forecast current"), layer(MapLayer::Current)},
        {"driftTracksAction", tr("Predicted drift"), layer(MapLayer::Tracks)},
        {"truthAction", tr("S&how true positions"),
         tr("Shows the true positions of the icebergs beside the estimates. When "
            "off, the map shows only what an operator would see."),
         switchOf(p.flightView, &FlightView::truthIsShown, &FlightView::setTruthShown)},
    };
}

std::vector<Command> Menus::mapPanels()
{
    const auto shown = [&links = m_parts.mapLinks](MapPanel panel) {
        return Switch{[&links, panel] { return links.panelIsShown(panel); },
                      [&links, panel](bool on) { links.setPanelShown(panel, on); }};
    };
    return {{"titlePanelAction", tr("&Title and figures"), shown(MapPanel::Title)},
            {"legendPanelAction", tr("&Legend"), shown(MapPanel::Legend)},
            {"scalePanelAction", tr("&Scale bar"), shown(MapPanel::ScaleBar)},
            {"northPanelAction", tr("&North arrow"), shown(MapPanel::North)},
            {"windPanelAction", tr("&Wind"), shown(MapPanel::Wind)}};
}

std::vector<Command> Menus::viewCommands()
{
    WindowParts& p = m_parts;
    const Switch fullScreen{
        [this] { return window().isFullScreen(); },
        [this](bool) { window().setWindowState(window().windowState() ^ Qt::WindowFullScreen); }};
    return {
        {"checksAction", tr("Chec&ks"), [this] { toggleChecks(context(), m_parts.docks); }, "F7"},
        {"studyAction", tr("S&tudy"), [&p] { p.study.showStudy(); }},
        {"startsAction", tr("Start times"),
         [this, &p] { p.docks.openFloating(Dock::Starts, panels().starts->sizeHint()); }},
        {"solveTimeAction", tr("&Solve time"), [&p] { p.solveTimes.show(); }},
        kLine,
        {tr("La&youts"), [this](QMenu& menu) { m_actions.add(menu, layouts()); }},
        {tr("&Panels"),
         [&p](QMenu& menu) {
             for (const QDockWidget* dock : p.docks.all())
                 menu.addAction(dock->toggleViewAction());
         }},
        {"resetLayoutAction", tr("&Reset layout"), [&p] { p.docks.reset(); }},
        {"fullScreenAction", tr("F&ull screen"), fullScreen, "F11"},
        kLine,
    };
}

std::vector<Command> Menus::layouts()
{
    const auto shown = [&docks = m_parts.docks](Layout layout) {
        return Switch{[&docks, layout] { return docks.layout() == layout; },
                      [&docks, layout](bool) { docks.showLayout(layout); }, "layouts"};
    };
    return {{"planLayoutAction", tr("&Plan"), shown(Layout::Plan), "Ctrl+1"},
            {"flyLayoutAction", tr("&Fly"), shown(Layout::Fly), "Ctrl+2"},
            {"analyseLayoutAction", tr("&Analyse"), shown(Layout::Analyse), "Ctrl+3"}};
}

std::vector<Command> Menus::flightCommands()
{
    WindowParts& p = m_parts;
    Workspace& w = workspace();
    TradeoffPanel& tradeoff = *panels().tradeoff;
    PlaybackBar& playback = *panels().playback;
    const auto order = [this](FlightOrder order) {
        return [this, order] { workspace().order(orderedUavs(), order); };
    };
    constexpr When kOrdered = When::InFlight | When::UavOrdered;
    return {
        {"playAction", tr("Fly"), [this] { togglePlay(context()); }, "Space"},
        {"stepAction", tr("&Step one second"), [&w] { w.step(); }, "."},
        {"resetAction", tr("Stop and &edit"), [&w] { w.reset(); }, "Ctrl+Home"},
        {"bringBackAction", tr("Restore disc&arded flight"), [&w] { w.restoreFlight(); },
         When::Restorable, "Ctrl+Shift+Home"},
        kLine,
        {"shorterPlanAction", tr("Prefer s&horter route"), [&tradeoff] { tradeoff.stepPlan(+1); },
         "Alt+Right"},
        {"uncertainPlanAction", tr("Prefer more un&certain first"),
         [&tradeoff] { tradeoff.stepPlan(-1); }, "Alt+Left"},
        kLine,
        {"seenAction", tr("Report as seen no&w"), [&w] { w.reportSeen(w.selection().ids()); },
         When::InFlight | When::FlownSelected, "N"},
        {"returnAction", tr("&Return home now"), order(FlightOrder::ReturnNow), kOrdered},
        {"holdAction", tr("Hold here"), order(FlightOrder::HoldHere), kOrdered},
        {"resumeAction", tr("Res&ume"), order(FlightOrder::None), kOrdered},
        {"windAction", tr("Win&d..."), [&p] { p.dialogs.askWind(); }, "W"},
        kLine,
        {"stepBackAction", tr("Step &back one second"), [&w] { w.stepBack(); }, ","},
        {"tickAction", tr("Step one &tick"), [&w] { w.stepTicks(+1); }, "Ctrl+."},
        {"tickBackAction", tr("Step back one t&ick"), [&w] { w.stepTicks(-1); }, "Ctrl+,"},
        {"nextEventAction", tr("&Next event"), [&w] { w.stepToEvent(+1); }, "Ctrl+Right"},
        {"previousEventAction", tr("&Previous event"), [&w] { w.stepToEvent(-1); }, "Ctrl+Left"},
        {"goToTimeAction", tr("&Go to time"), [&playback] { playback.editTime(); }, "Ctrl+T"},
        {"newestAction", tr("Bac&k to latest"), [&w] { w.seekLatest(); }, "Ctrl+End"},
        kLine,
        {"fasterAction", tr("&Faster"), [&playback] { playback.stepRate(+1); }, "]"},
        {"slowerAction", tr("S&lower"), [&playback] { playback.stepRate(-1); }, "["},
        kLine,
        {"alarmSoundAction", tr("S&ound alarms"),
         tr("A sound at each new alarm, until it is acknowledged"),
         switchOf(p.sound, &AlarmSound::isOn, &AlarmSound::setOn)},
    };
}

std::vector<Command> Menus::tools()
{
    const auto tool = [map = panels().map](const char* id, const QString& text, const char* key,
                                           IconName icon, MapToolKind kind) {
        Command command(id, text,
                        Switch{[map, kind] { return map->tools().kind() == kind; },
                               [map, kind](bool) { map->tools().setKind(kind); }, "tools"},
                        key, icon);
        command.when = isLockedInFlight(kind) ? When::Unlocked : When::Always;
        return command;
    };
    return {
        tool("selectTool", tr("Select"), "S", IconName::Select, MapToolKind::Select),
        tool("icebergTool", tr("Iceberg"), "I", IconName::Iceberg, MapToolKind::Iceberg),
        tool("uavTool", tr("UAV"), "U", IconName::Uav, MapToolKind::Uav),
        tool("assetTool", tr("Asset"), "A", IconName::Asset, MapToolKind::Asset),
        tool("areaTool", tr("Area"), "R", IconName::Area, MapToolKind::Area),
        tool("noFlyTool", tr("No-fly area"), "X", IconName::NoFly, MapToolKind::NoFly),
        tool("measureTool", tr("Measure"), "M", IconName::Measure, MapToolKind::Measure),
        tool("panTool", tr("Pan"), "H", IconName::Pan, MapToolKind::Pan),
        kLine,
        {tr("&New icebergs seen by"),
         [this](QMenu& menu) { m_parts.preferences.buildSources(menu); }},
    };
}

std::vector<Command> Menus::helpCommands()
{
    WindowParts& p = m_parts;
    return {
        {"manualAction", tr("&Manual"), [&p] { p.manual.open(); }, Key::HelpContents},
        {"shortcutsAction", tr("Keyboard &shortcuts"), [this] { showShortcuts(); }, "?"},
        {"tourAction", tr("&Tour"), [&p] { p.start.startTour(); }},
        {"aboutAction", tr("&About Bergwatch"), [this] { showAbout(); }},
    };
}

void Menus::buildToolBar()
{
    QToolBar* bar = window().addToolBar(tr("Tools"));
    bar->setObjectName(u"toolBar"_s);
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (QAction* tool : m_actions.group("tools")) {
        tool->setToolTip(u"%1 (%2)"_s.arg(tool->text(), tool->shortcut().toString()));
        tool->setStatusTip({}); // the tool has its own
        bar->addAction(tool);
    }
    for (const auto& group : {std::vector{"undoAction", "redoAction"},
                              {"fitAction", "followAction"},
                              {"exportAction"}}) {
        bar->addSeparator();
        for (const char* id : group) {
            QAction* action = commandAction(window(), id);
            action->setIconText(action->iconText()); // the bar stands still when the text changes
            bar->addAction(action);
            // There is room for the names of the tools; those of commands are in the menus.
            if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
                button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        }
    }
}

/** State that decides which commands are possible, which are set, and their names. */
void Menus::followState()
{
    const auto follow = [this](const auto* sender, auto signal) {
        connect(sender, signal, this, &Menus::update);
    };
    follow(&workspace(), &Workspace::inFlightChanged);
    follow(&workspace(), &Workspace::flightChanged);
    follow(&workspace(), &Workspace::discardedFlightChanged);
    follow(&workspace().selection(), &Selection::changed);
    follow(workspace().document().undoStack(), &QUndoStack::indexChanged);
    follow(&panels().map->tools(), &MapToolbox::statusText); // drawing has begun or ended
    follow(&panels().map->tools(), &MapToolbox::kindChanged);
    follow(&panels().map->camera(), &MapCamera::followUavChanged);
    follow(&m_parts.mapLinks, &MapController::layersChanged);
    follow(&m_parts.docks, &Docks::layoutChanged);
    update();
}

void Menus::update() const
{
    const Workspace& w = workspace();
    const Scenario& scenario = workspace().document().scenario();
    const QUndoStack& edits = *workspace().document().undoStack();
    const std::vector<std::string>& ids = workspace().selection().ids();
    const std::optional<LastChange> change = w.undoableChange();
    const bool inFlight = w.inFlight();
    const bool icebergs = !icebergsOf(scenario, ids).empty();
    const bool flown = !w.icebergsInFlight(ids).empty();
    const bool isDrawing = panels().map->tools().isDrawing();
    When state = When::Always;
    const auto note = [&state](When when, bool holds) { state = holds ? state | when : state; };
    note(When::InFlight, inFlight);
    note(When::Unlocked, !inFlight);
    note(When::IcebergsSelected, icebergs);
    note(When::CopiesSelected, icebergs || !uavsOf(scenario, ids).empty());
    note(When::FlownSelected, flown);
    note(When::Removable, inFlight ? flown : !ids.empty());
    note(When::UavOrdered, !orderedUavs().empty());
    note(When::Undoable, isDrawing || (inFlight ? change.has_value() : edits.canUndo()));
    note(When::Redoable, !inFlight && edits.canRedo());
    note(When::Restorable, w.discardedFlight_s().has_value());
    m_actions.update(state);
    const auto name = [this](const char* id, const QString& text, const QString& what = {}) {
        commandAction(window(), id)->setText(what.isEmpty() ? text : text + u' ' + what);
    };
    name("playAction", w.isPlaying() ? tr("Pause") : tr("Fly"));
    name("undoAction", tr("&Undo"),
         !inFlight ? edits.undoText()
         : change  ? changeName(change->first)
                   : QString());
    name("redoAction", tr("&Redo"), edits.redoText());
}

/**
 * The last point of what is drawn on the map; else, in flight, the last change of the flight, and
 * before it the last edit of the scenario. Asks first where time was flown since the change.
 */
void Menus::undo()
{
    panels().finishTyping(); // that is what it undoes then
    if (panels().map->tools().isDrawing())
        return panels().map->tools().undoLastPoint();
    if (!workspace().inFlight())
        return workspace().document().undo();
    const std::optional<LastChange> change = workspace().undoableChange();
    const FlightRecord& record = workspace().record();
    if (change && (record.now.time_s <= change->first.time_s ||
                   interaction().askUndo(&window(), changeName(change->first),
                                         clockOf(record.scenario).text(change->first.time_s))))
        workspace().undoChange();
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
    m_actions.refreshIcons(theme());
    // Qt's own drawing is near black in every appearance.
    if (auto* more = window().findChild<QToolButton*>(u"qt_toolbar_ext_button"_s))
        more->setIcon(icon(IconName::More, theme()));
}

} // namespace berg
