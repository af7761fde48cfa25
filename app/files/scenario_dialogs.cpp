#include "app/files/scenario_dialogs.h"

#include "app/dialogs/generate_dialog.h"
#include "app/dialogs/interaction.h"
#include "app/dialogs/screen_fit.h"
#include "app/files/scenario_files.h"
#include "app/files/start_page_controller.h"
#include "app/layout/command.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/document/wind.h"
#include "widgets/map/view/map_view.h"
#include "widgets/map/view/place_mark.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/map/find_box.h"
#include "widgets/workspace/workspace.h"

#include <QAction>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kDialogEdge_px = 12;
constexpr const char* kFavouritesKey = "find/favourites";

} // namespace

ScenarioDialogs::ScenarioDialogs(WindowContext& context, ScenarioFiles& files, const Docks& docks,
                                 const StartPageController& start)
    : WindowPart(context), m_files(files)
{
    const FindBox* box = panels().findBox;
    connect(box, &FindBox::closed, panels().map, qOverload<>(&QWidget::setFocus));
    connect(box, &FindBox::placeChosen, this, &ScenarioDialogs::showPlace);
    connect(box, &FindBox::objectChosen, this, &ScenarioDialogs::showObject);
    connect(box, &FindBox::commandChosen, this,
            [this](const QString& name) { commandAction(window(), qPrintable(name))->trigger(); });
    connect(box, &FindBox::fieldChosen, this, [this, &docks](const QString& key) {
        docks.openInspector();
        panels().inspector->goToField(key);
    });
    connect(box, &FindBox::moveRequested, this, &ScenarioDialogs::moveScenario);
    connect(box, &FindBox::newRequested, this, [this](const LatLon& place) {
        if (m_files.newScenario())
            placeNewScenario(place);
    });
    connect(box, &FindBox::whereChosen, this, &ScenarioDialogs::placeNewScenario);
    connect(&start, &StartPageController::newRequested, this, &ScenarioDialogs::newScenario);
    connect(box, &FindBox::favouriteChanged, this, &ScenarioDialogs::setFavourite);
    // The list and its targets belong to the scenario for which it was opened.
    connect(&workspace().document(), &ScenarioDocument::replaced, box, &FindBox::dismiss);
    connect(&workspace(), &Workspace::inFlightChanged, box, &FindBox::dismiss);
}

void ScenarioDialogs::generateIcebergs()
{
    panels().finishTyping();
    auto* dialog =
        new GenerateDialog(workspace().document().scenario(),
                           panels().map->view().visible(panels().map->rect()), &window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto preview = [this, dialog] {
        panels().map->setPreview(dialog->count() > 0 ? &dialog->result() : nullptr);
    };
    connect(dialog, &GenerateDialog::drawn, this, preview);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        if (!m_files.mayAnswer(false))
            return;
        const int count = dialog->count();
        workspace().document().edit(tr("Generate %n icebergs", nullptr, count),
                                    [dialog](Scenario& scenario) {
                                        scenario.icebergs = dialog->result().icebergs;
                                        scenario.observer = dialog->result().observer;
                                    });
    });
    connect(dialog, &QDialog::finished, this, [this] { panels().map->setPreview(nullptr); });
    preview();
    boundToScreen(*dialog);
    dialog->open();
    // Beside the sea that the preview is on.
    dialog->move(window().geometry().right() - dialog->width() - kDialogEdge_px,
                 panels().map->mapToGlobal(QPoint(0, kDialogEdge_px)).y());
}

void ScenarioDialogs::askWind()
{
    const double airspeed_mps = slowestAirspeed_mps(workspace().document().scenario());
    if (airspeed_mps <= 0)
        return;
    const bool wasInFlight = workspace().inFlight();
    if (wasInFlight && workspace().refuseIntervention())
        return;
    const std::optional<Point> wind_mps =
        interaction().askWind(&window(), workspace().wind_mps(), airspeed_mps);
    if (wind_mps && *wind_mps != workspace().wind_mps() && m_files.mayAnswer(wasInFlight))
        workspace().setWind(*wind_mps);
}

void ScenarioDialogs::askForecast()
{
    if (workspace().inFlight()) {
        showMessage(
            tr("A forecast cannot be imported in flight. Stop the flight before importing."),
            kMessage_ms);
        return;
    }
    panels().finishTyping();
    const QString filter =
        tr("Forecasts: NetCDF, GRIB, JSON (*.nc *.nc4 *.cdf *.grib *.grib2 *.grb "
           "*.grb2 *.json);;All files (*)");
    const std::optional<ForecastChoice> choice = interaction().askForecast(
        &window(), {.scenario = std::make_shared<const Scenario>(workspace().document().scenario()),
                    .openPath = [this, filter](QWidget* parent) {
                        return interaction().openPath(parent, filter);
                    }});
    if (!choice || !m_files.mayAnswer(false))
        return;
    workspace().document().edit(choice->forecast ? tr("Import forecast") : tr("Remove forecast"),
                                [&](Scenario& scenario) { scenario.forecast = choice->forecast; });
}

void ScenarioDialogs::newScenario()
{
    if (m_files.newScenario())
        openFind(true);
}

void ScenarioDialogs::openFind(bool asksWhere)
{
    Scenario shown = workspace().document().scenario();
    if (workspace().inFlight())
        shown.icebergs = workspace().record().now.icebergs;
    std::vector<FindItem> items = findableItems(shown);
    for (FindItem& field : fields())
        items.push_back(std::move(field));
    for (FindItem& command : commands())
        items.push_back(std::move(command));
    markFavourites(items, settings().value(kFavouritesKey).toStringList());
    panels().findBox->open({.items = std::move(items),
                            .origin = workspace().document().scenario().origin,
                            .mayMove = !workspace().inFlight(),
                            .asksWhere = asksWhere});
}

/** Returns the menu commands that are possible now, with the switches last. */
std::vector<FindItem> ScenarioDialogs::commands() const
{
    std::vector<MenuCommand> commands = menuCommands(*window().menuBar());
    std::stable_partition(commands.begin(), commands.end(), [](const MenuCommand& command) {
        return !command.action->isCheckable();
    });
    std::vector<FindItem> items;
    for (const auto& [action, text, path] : commands) {
        if (action->objectName().isEmpty() || !action->isEnabled() || !action->isVisible())
            continue;
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        items.push_back({.kind = FindKind::Command,
                         .key = action->objectName(),
                         .text = text,
                         .other = action->statusTip(),
                         .hint = keys.isEmpty() ? path : path + u", "_s + keys,
                         .at = {}});
    }
    return items;
}

/** The numbers that the Inspector can show now. */
std::vector<FindItem> ScenarioDialogs::fields() const
{
    std::vector<FindItem> items;
    for (const InspectorPanel::Field& field : panels().inspector->fields())
        items.push_back({.kind = FindKind::Field,
                         .key = field.key,
                         .text = field.label,
                         .other = field.of + u' ' + field.label,
                         .hint = field.of,
                         .at = {}});
    return items;
}

void ScenarioDialogs::showObject(const std::string& id)
{
    workspace().selection().set({id});
    panels().map->camera().showObjects({id});
}

void ScenarioDialogs::setFavourite(const QString& key, bool isFavourite)
{
    QStringList keys = settings().value(kFavouritesKey).toStringList();
    keys.removeAll(key);
    if (isFavourite)
        keys << key;
    settings().setValue(kFavouritesKey, keys);
}

/** Asks for the place of the new, empty scenario. */
void ScenarioDialogs::placeNewScenario(const LatLon& origin)
{
    ScenarioDocument& document = workspace().document();
    attempt([&] {
        const Scenario placed = movedTo(document.scenario(), origin, MoveMode::KeepLayout);
        if (document.isClean() && document.filePath().isEmpty() && placed.icebergs.empty())
            document.reset(placed); // it is still new: nothing of it is unsaved
        else
            document.edit(tr("Place the new scenario"),
                          [&](Scenario& scenario) { scenario = placed; });
        panels().map->camera().fit();
    });
}

void ScenarioDialogs::showPlace(const LatLon& place, const QString& name)
{
    panels().map->camera().centreOn(place);
    panels().placeMark->showAt(LocalFrame(workspace().document().scenario().origin).toPlane(place),
                               name);
}

void ScenarioDialogs::moveScenario(const LatLon& suggested)
{
    panels().finishTyping();
    ScenarioDocument& document = workspace().document();
    const std::optional<OriginChoice> choice =
        interaction().askOrigin(&window(), document.scenario(), suggested, theme());
    if (!choice || !m_files.mayAnswer(false))
        return;
    document.endGesture();
    document.edit(tr("Move scenario"), [&](Scenario& scenario) {
        scenario = movedTo(scenario, choice->origin, choice->mode);
    });
    panels().map->camera().fit();
}

} // namespace berg
