// Sightings of real icebergs from files of others.

#include "app/main_window.h"
#include "widgets/map/map_view.h"

#include <QFileInfo>
#include <QStatusBar>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kMessage_ms = 4000;

/** Files that hold sightings rather than a scenario or a run, by their endings. */
const QStringList& sightingEndings()
{
    static const QStringList kEndings{u"csv"_s, u"geojson"_s, u"json"_s,     u"kml"_s,
                                      u"gpx"_s, u"plan"_s,    u"waypoints"_s};
    return kEndings;
}

} // namespace

bool MainWindow::mayImport()
{
    if (!m_workspace.inFlight())
        return true;
    statusBar()->showMessage(
        tr("In flight no sightings can be imported. Stop the flight to import them."), kMessage_ms);
    return false;
}

void MainWindow::chooseSightings()
{
    if (!mayImport())
        return;
    const QString path = m_interaction.openPath(
        this, tr("Sightings (*.csv *.txt *.geojson *.json *.kml *.gpx *.plan *.waypoints);;"
                 "All files (*)"));
    if (!path.isEmpty())
        importSightings(path);
}

void MainWindow::importSightings(const QString& path)
{
    if (!mayImport())
        return;
    finishTyping();
    const Scenario& present = m_workspace.document().scenario();
    const std::optional<ImportChoice> choice = m_interaction.chooseImport(
        this, m_workspace.imports(),
        {.path = path,
         .present = std::make_shared<const Scenario>(present),
         .intoNew = startPageIsShown(), // there the present one is out of sight
         .theme = m_theme});
    if (choice && mayAnswer(false))
        takeImport(*choice, QFileInfo(path).fileName());
}

void MainWindow::takeImport(const ImportChoice& choice, const QString& fileName)
{
    if (choice.intoNew) {
        if (!mayLeaveScene(Interaction::FlightEnd::Other))
            return;
        m_workspace.document().restore(choice.scenario, {}); // it is in no file yet
    } else {
        m_workspace.document().edit(
            (choice.icebergs == 1 ? tr("Import 1 iceberg from %1")
                                  : tr("Import %n icebergs from %1", nullptr, choice.icebergs))
                .arg(fileName),
            [&](Scenario& scenario) { scenario = choice.scenario; });
        m_map->fit();
    }
    closeStartPage();
    statusBar()->showMessage((choice.icebergs == 1
                                  ? tr("Imported 1 iceberg from %1")
                                  : tr("Imported %n icebergs from %1", nullptr, choice.icebergs))
                                 .arg(fileName),
                             kMessage_ms);
}

void MainWindow::openDropped(const QString& path)
{
    if (sightingEndings().contains(QFileInfo(path).suffix().toLower()))
        importSightings(path);
    else
        openFile(path);
}

} // namespace berg
