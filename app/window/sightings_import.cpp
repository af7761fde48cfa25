#include "app/window/sightings_import.h"

#include "app/dialogs/interaction.h"
#include "app/window/panels.h"
#include "app/window/scenario_files.h"
#include "app/window/start_guide.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/workspace.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMainWindow>
#include <QMimeData>
#include <QTimer>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

/** Files that hold sightings rather than a scenario or a run, by their endings. */
const QStringList& sightingEndings()
{
    static const QStringList kEndings{u"csv"_s,  u"geojson"_s, u"json"_s, u"kml"_s,      u"kmz"_s,
                                      u"czml"_s, u"gpx"_s,     u"plan"_s, u"waypoints"_s};
    return kEndings;
}

} // namespace

SightingsImport::SightingsImport(WindowContext& context, ScenarioFiles& files, StartGuide& start)
    : WindowPart(context), m_files(files), m_start(start)
{
    window().setAcceptDrops(true);
    window().installEventFilter(this);
    connect(&m_start, &StartGuide::importRequested, this, &SightingsImport::chooseSightings);
}

bool SightingsImport::mayImport()
{
    if (!workspace().inFlight())
        return true;
    showMessage(tr("In flight no sightings can be imported. Stop the flight to import them."),
                kMessage_ms);
    return false;
}

void SightingsImport::chooseSightings()
{
    if (!mayImport())
        return;
    const QString path = interaction().openPath(
        &window(),
        tr("Sightings (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints);;"
           "All files (*)"));
    if (!path.isEmpty())
        importSightings(path);
}

void SightingsImport::importSightings(const QString& path)
{
    if (!mayImport())
        return;
    panels().finishTyping();
    const Scenario& present = workspace().document().scenario();
    const std::optional<ImportChoice> choice = interaction().chooseImport(
        &window(), workspace().imports(),
        {.path = path,
         .present = std::make_shared<const Scenario>(present),
         .intoNew = m_start.pageIsShown(), // there the present one is out of sight
         .theme = theme()});
    if (choice && m_files.mayAnswer(false))
        acceptImport(*choice, QFileInfo(path).fileName());
}

void SightingsImport::acceptImport(const ImportChoice& choice, const QString& fileName)
{
    if (choice.intoNew) {
        if (!m_files.mayLeaveScene(Interaction::FlightEnd::Other))
            return;
        workspace().document().restore(choice.scenario, {}); // it is in no file yet
    } else {
        workspace().document().edit(
            tr("Import %n icebergs from %1", nullptr, choice.icebergs).arg(fileName),
            [&](Scenario& scenario) { scenario = choice.scenario; });
        panels().map->fit();
    }
    m_start.closePage();
    showMessage(tr("Imported %n icebergs from %1", nullptr, choice.icebergs).arg(fileName),
                kMessage_ms);
}

void SightingsImport::openDropped(const QString& path)
{
    if (sightingEndings().contains(QFileInfo(path).suffix().toLower()))
        importSightings(path);
    else
        m_files.openFile(path);
}

/** A file dropped on the window. */
bool SightingsImport::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return WindowPart::eventFilter(watched, event);
    auto& drop = *static_cast<QDropEvent*>(event);
    const QList<QUrl> urls = drop.mimeData()->urls();
    if (event->type() == QEvent::DragEnter) {
        if (urls.size() == 1 && urls.front().isLocalFile())
            drop.acceptProposedAction();
    } else if (!urls.isEmpty()) {
        drop.acceptProposedAction();
        // After the drop: the program that the file comes from waits for its end.
        QTimer::singleShot(0, this,
                           [this, path = urls.front().toLocalFile()] { openDropped(path); });
    }
    return true;
}

} // namespace berg
