// Places on the Earth: going to one, and moving the scenario to another.

#include "app/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/map/place_mark.h"
#include "widgets/panels/dialogs/goto_bar.h"
#include "widgets/theme/unit_settings.h"

#include <QMenu>

using namespace Qt::StringLiterals;

namespace berg {

void MainWindow::buildPlaces()
{
    m_placeMark = new PlaceMark(*m_map);
    m_goto = new GotoBar(m_map);
    connect(m_goto, &GotoBar::closed, m_map, qOverload<>(&QWidget::setFocus));
    connect(m_goto, &GotoBar::placeChosen, this, &MainWindow::showPlace);
    connect(m_goto, &GotoBar::moveRequested, this, &MainWindow::moveScenario);
}

void MainWindow::buildUnitMenu(QMenu& menu)
{
    const auto choices = [&](const QString& title, const char* key,
                             const std::vector<std::pair<QString, QString>>& values) {
        QMenu& choice = *menu.addMenu(title);
        for (const auto& [value, text] : values)
            addChoice(choice, text, QLatin1String(key), value);
        connect(&choice, &QMenu::triggered, this, [this, key](QAction* action) {
            m_settings.setValue(key, action->data());
            if (readUnits(m_settings) != shownUnits())
                emit unitsChosen();
        });
    };
    choices(tr("&Distances"), kDistanceUnitKey,
            {{u"metric"_s, tr("Metres and kilometres")}, {u"nautical"_s, tr("Nautical miles")}});
    choices(tr("&Speeds"), kSpeedUnitKey,
            {{u"mps"_s, tr("Metres per second")}, {u"knots"_s, tr("Knots")}});
    constexpr double kExample_deg = 47.05;
    const auto form = [&](CoordinateForm one) {
        return QString::fromStdString(angleText(kExample_deg, one, 2))
            .replace(u'.', locale().decimalPoint());
    };
    choices(
        tr("&Coordinates"), kCoordinateFormKey,
        {{u"minutes"_s, tr("Degrees and minutes, %1").arg(form(CoordinateForm::DegreesMinutes))},
         {u"decimal"_s, tr("Decimal degrees, %1").arg(form(CoordinateForm::DecimalDegrees))},
         {u"seconds"_s,
          tr("Degrees, minutes, seconds, %1").arg(form(CoordinateForm::DegreesMinutesSeconds))}});
}

void MainWindow::openGoto()
{
    m_goto->open(m_workspace.document().scenario().origin, !m_workspace.inFlight());
}

void MainWindow::showPlace(const LatLon& place, const QString& name)
{
    m_map->centreOn(place);
    m_placeMark->showAt(LocalFrame(m_workspace.document().scenario().origin).toPlane(place), name);
}

void MainWindow::moveScenario(const LatLon& suggested)
{
    finishTyping();
    ScenarioDocument& document = m_workspace.document();
    const std::optional<OriginChoice> choice =
        m_interaction.askOrigin(this, document.scenario(), suggested, m_theme);
    if (!choice || !mayAnswer(false))
        return;
    document.endGesture();
    document.edit(tr("Move scenario"), [&](Scenario& scenario) {
        scenario = movedTo(scenario, choice->origin, choice->mode);
    });
    m_map->fit();
}

} // namespace berg
