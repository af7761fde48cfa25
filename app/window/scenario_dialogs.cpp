#include "app/window/scenario_dialogs.h"

#include "app/dialogs/interaction.h"
#include "app/window/panels.h"
#include "app/window/scenario_files.h"
#include "widgets/map/view/map_view.h"
#include "widgets/map/view/place_mark.h"
#include "widgets/model/wind.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/dialogs/generate_dialog.h"
#include "widgets/panels/dialogs/goto_bar.h"

#include <QMainWindow>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kDialogEdge_px = 12;

} // namespace

ScenarioDialogs::ScenarioDialogs(WindowContext& context, ScenarioFiles& files)
    : WindowPart(context), m_files(files)
{
    connect(panels().gotoBar, &GotoBar::closed, panels().map, qOverload<>(&QWidget::setFocus));
    connect(panels().gotoBar, &GotoBar::placeChosen, this, &ScenarioDialogs::showPlace);
    connect(panels().gotoBar, &GotoBar::moveRequested, this, &ScenarioDialogs::moveScenario);
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
        workspace().document().edit(count == 1 ? tr("Generate iceberg")
                                               : tr("Generate %n icebergs", nullptr, count),
                                    [dialog](Scenario& scenario) {
                                        scenario.icebergs = dialog->result().icebergs;
                                        scenario.observer = dialog->result().observer;
                                    });
    });
    connect(dialog, &QDialog::finished, this, [this] { panels().map->setPreview(nullptr); });
    preview();
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
    const std::optional<Point> wind_mps =
        interaction().askWind(&window(), workspace().wind_mps(), airspeed_mps);
    if (wind_mps && m_files.mayAnswer(wasInFlight))
        workspace().setWind(*wind_mps);
}

void ScenarioDialogs::openGoto()
{
    panels().gotoBar->open(workspace().document().scenario().origin, !workspace().inFlight());
}

void ScenarioDialogs::showPlace(const LatLon& place, const QString& name)
{
    panels().map->centreOn(place);
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
    panels().map->fit();
}

} // namespace berg
