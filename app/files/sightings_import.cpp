#include "app/files/sightings_import.h"

#include "app/dialogs/interaction.h"
#include "app/files/scenario_files.h"
#include "app/files/start_page_controller.h"
#include "app/layout/panels.h"
#include "core/io/import/import_file.h"
#include "core/io/text/atomic_file.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/sightings/flight_sightings.h"
#include "widgets/words/issue_text.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QClipboard>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QMimeData>
#include <QTimer>

#include <algorithm>
#include <span>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

/** Files that hold sightings rather than a scenario or a run, by their endings. */
const QStringList& sightingEndings()
{
    static const QStringList kEndings{u"csv"_s, u"txt"_s,  u"geojson"_s, u"json"_s, u"kml"_s,
                                      u"kmz"_s, u"czml"_s, u"gpx"_s,     u"plan"_s, u"waypoints"_s,
                                      u"shp"_s, u"gpkg"_s, u"gml"_s,     u"dxf"_s,  u"fgb"_s,
                                      u"tab"_s, u"mif"_s,  u"e00"_s,     u"zip"_s};
    return kEndings;
}

bool isAirspaceEnding(const QString& ending)
{
    return ending == u"openair"_s || ending == u"air"_s;
}

/** The start of a file; empty if it cannot be read, as whoever reads it says why. */
std::string startOf(const QString& path)
{
    constexpr qint64 kStart = 65'536;
    QFile file(path);
    return QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly)
               ? file.read(kStart).toStdString()
               : std::string();
}

/** By its start. */
bool holdsOpenAir(const QString& path)
{
    return isOpenAir(startOf(path));
}

/** By its name and start; the content of a file of a GIS program is known when it is converted. */
bool mayHoldIceChart(const QString& path)
{
    return isGisFileName(QFile::encodeName(path).toStdString()) || isIceChart(startOf(path));
}

/** A line each; the start of a long list. */
QString reasonsOf(const Rejections& rejected)
{
    constexpr std::size_t kMostLines = 15;
    QStringList lines;
    const std::span<const RejectedRow> first(rejected.first);
    for (const RejectedRow& row : first.first(std::min(first.size(), kMostLines)))
        lines << placedIssueText({Severity::Error, placeOf(rejected, row.line), reasonOf(row)});
    if (rejected.count > kMostLines)
        lines << u"…"_s;
    return lines.join(u'\n');
}

} // namespace

SightingsImport::AirspacePointer SightingsImport::read(const AirspaceRequest& request,
                                                       const std::stop_token& stop)
{
    const std::string name = QFileInfo(request.path).fileName().toStdString();
    const std::string bytes =
        readImportFile(QFile::encodeName(request.path).toStdString(), name, stop);
    return std::make_shared<const Airspace>(
        Airspace{.path = request.path,
                 .into = request.into,
                 .result = importAirspace(*request.into, bytes, name, stop)});
}

SightingsImport::IceChartPointer SightingsImport::readIce(const AirspaceRequest& request,
                                                          const std::stop_token& stop)
{
    const std::string name = QFileInfo(request.path).fileName().toStdString();
    const std::string bytes =
        readImportFile(QFile::encodeName(request.path).toStdString(), name, stop);
    IceChartFile file{.path = request.path, .into = request.into, .result = {}};
    if (isIceChart(bytes))
        file.result = importIceChart(*request.into, bytes, name, stop);
    return std::make_shared<const IceChartFile>(std::move(file));
}

SightingsImport::SightingsImport(WindowContext& context, ScenarioFiles& files,
                                 StartPageController& start)
    : WindowPart(context)
    , m_files(files)
    , m_start(start)
    , m_airspace(u"airspace"_s,
                 {.work = [](const AirspaceRequest& request, const std::stop_token& stop,
                             const auto& deliver) { deliver(read(request, stop)); },
                  .deliver = [this](const AirspacePointer& airspace) { takeAirspace(*airspace); },
                  .end =
                      [this](const std::optional<WorkFailure>& failure) {
                          if (failure)
                              interaction().showError(&window(), failure->report);
                      }})
    , m_ice(u"ice chart"_s,
            {.work = [](const AirspaceRequest& request, const std::stop_token& stop,
                        const auto& deliver) { deliver(readIce(request, stop)); },
             .deliver = [this](const IceChartPointer& file) { takeIceChart(*file); },
             .end =
                 [this](const std::optional<WorkFailure>& failure) {
                     if (failure)
                         interaction().showError(&window(), failure->report);
                 }})
{
    window().setAcceptDrops(true);
    window().installEventFilter(this);
    connect(&m_start, &StartPageController::importRequested, this,
            &SightingsImport::chooseSightings);
}

bool SightingsImport::mayImport()
{
    if (!workspace().inFlight())
        return true;
    showMessage(tr("Airspace cannot be imported in flight. Stop the flight before importing."),
                kMessage_ms);
    return false;
}

void SightingsImport::chooseSightings()
{
    if (workspace().inFlight() && workspace().refuseIntervention())
        return;
    const QString path = interaction().openPath(
        &window(),
        tr("Sightings (*.csv *.txt *.geojson *.json *.kml *.kmz *.czml *.gpx *.plan *.waypoints "
           "*.nmea *.jpg *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;"
           "All files (*)"));
    if (!path.isEmpty())
        importSightings(path);
}

void SightingsImport::chooseAirspace()
{
    if (!mayImport())
        return;
    const QString path = interaction().openPath(
        &window(), tr("Airspace (*.txt *.openair *.air *.geojson *.json *.kml *.kmz *.czml *.shp "
                      "*.gpkg *.gml *.zip);;All files (*)"));
    if (!path.isEmpty())
        readAirspace(path);
}

void SightingsImport::chooseIceChart()
{
    const QString path = interaction().openPath(
        &window(), tr("Ice charts (*.shp *.zip *.gpkg *.gml *.fgb *.e00 *.geojson *.json);;"
                      "All files (*)"));
    if (!path.isEmpty())
        readIceChart(path);
}

void SightingsImport::readIceChart(const QString& path)
{
    panels().finishTyping();
    m_ice.start({.path = path,
                 .into = std::make_shared<const Scenario>(workspace().document().scenario())});
}

/** A file that is no ice chart may hold sightings. */
void SightingsImport::takeIceChart(const IceChartFile& file)
{
    if (!file.result) {
        askSightings(file.path);
        return;
    }
    if (workspace().inFlight()) {
        showMessage(
            tr("Ice charts cannot be imported in flight. Stop the flight before importing."),
            kMessage_ms);
        return;
    }
    if (workspace().document().scenario() != *file.into) {
        readIceChart(file.path); // into what it is now
        return;
    }
    const IceChartResult& result = *file.result;
    const QString name = QFileInfo(file.path).fileName();
    workspace().document().edit(tr("Import ice chart from %1").arg(name),
                                [&](Scenario& scenario) { scenario = result.scenario; });
    m_start.closePage();
    const std::string& date = result.scenario.iceChart->dateUtc;
    showMessage(tr("Ice chart of %1: %n areas, date %2, %3 left out or far away", nullptr,
                   static_cast<int>(result.taken))
                    .arg(name, date.empty() ? tr("unknown") : QString::fromStdString(date),
                         QString::number(result.far + result.leftOut + result.rejected.count)),
                kLongMessage_ms);
}

void SightingsImport::readAirspace(const QString& path)
{
    if (!mayImport())
        return;
    panels().finishTyping();
    m_airspace.start({.path = path,
                      .into = std::make_shared<const Scenario>(workspace().document().scenario())});
}

void SightingsImport::takeAirspace(const Airspace& airspace)
{
    if (workspace().document().scenario() != *airspace.into) {
        readAirspace(airspace.path); // into what it is now
        return;
    }
    const AirspaceResult& result = airspace.result;
    const QString name = QFileInfo(airspace.path).fileName();
    if (!mayImport())
        return; // it has taken off meanwhile
    if (result.added > 0) {
        workspace().document().edit(tr("Import airspace from %1").arg(name),
                                    [&](Scenario& scenario) { scenario = result.scenario; });
        m_start.closePage();
    }
    const QString summary =
        tr("Airspace of %1: %n areas added, %2 already present, %3 farther than 100 km, %4 left "
           "out",
           nullptr, static_cast<int>(result.added))
            .arg(name, QString::number(result.known), QString::number(result.far),
                 QString::number(result.tooMany + result.rejected.count));
    showMessage(summary, kMessage_ms);
    reportLeftOut(result, summary);
}

/** An error only where nothing is left. */
void SightingsImport::reportLeftOut(const AirspaceResult& result, const QString& summary)
{
    QStringList text{summary, {}};
    if (result.tooMany > 0)
        text << tr("%n areas: a scenario can have at most %1", nullptr,
                   static_cast<int>(result.tooMany))
                    .arg(kMostAirspaceAreas);
    for (const Rejections* list : {&result.rejected, &result.noted})
        if (list->count > 0)
            text << reasonsOf(*list);
    if (text.size() == 2)
        return;
    if (result.added + result.known == 0)
        interaction().showError(&window(), text.join(u'\n'));
    else
        interaction().showInformation(&window(), tr("Airspace left out or changed"),
                                      text.join(u'\n').toHtmlEscaped().replace(u'\n', u"<br>"_s));
}

void SightingsImport::paste()
{
    const QMimeData* data = QApplication::clipboard()->mimeData();
    const QString text = data == nullptr ? QString() : data->text();
    const bool isTable = text.trimmed().contains(u'\n') && !text.trimmed().startsWith(u'{');
    if (!isTable && !workspace().inFlight()) {
        panels().map->edits().paste();
        return;
    }
    const QString path = m_pasted.filePath(tr("Clipboard"));
    if (!attempt([&] {
            writeFileAtomically(QFile::encodeName(path).toStdString(), text.toStdString());
        }))
        return;
    importSightings(path);
}

void SightingsImport::importSightings(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if ((ending == u"txt"_s || !sightingEndings().contains(ending)) && holdsOpenAir(path)) {
        readAirspace(path);
        return;
    }
    if (mayHoldIceChart(path)) {
        readIceChart(path);
        return;
    }
    askSightings(path);
}

void SightingsImport::askSightings(const QString& path)
{
    panels().finishTyping();
    if (workspace().inFlight()) {
        importInFlight(path);
        return;
    }
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

/** Imports into the instant at which the flight stands; one that flies pauses meanwhile. */
void SightingsImport::importInFlight(const QString& path)
{
    if (workspace().refuseIntervention())
        return;
    const auto isPaused = [this] { return workspace().record().now.phase != RunPhase::Flying; };
    disconnect(m_pause);
    if (isPaused()) {
        askReports(path);
        return;
    }
    m_pause = connect(&workspace(), &Workspace::flightChanged, this, [this, path, isPaused] {
        if (!isPaused())
            return;
        disconnect(m_pause);
        QTimer::singleShot(0, this, [this, path] {
            askReports(path);
            if (workspace().mayIntervene()) // it was flying, and goes on
                workspace().fly(panels().playback->rate());
        });
    });
    workspace().pause();
}

void SightingsImport::askReports(const QString& path)
{
    if (!workspace().inFlight() || workspace().refuseIntervention())
        return;
    const double now_s = workspace().record().now.time_s;
    const std::optional<ImportChoice> choice = interaction().chooseImport(
        &window(), workspace().imports(),
        {.path = path,
         .present = std::make_shared<const Scenario>(scenarioNow(workspace().record())),
         .inFlight = true,
         .theme = theme()});
    if (!choice)
        return;
    if (!workspace().inFlight() || workspace().record().now.time_s != now_s) {
        showMessage(tr("The flight has continued in the meantime, so nothing was reported."),
                    kLongMessage_ms);
        return;
    }
    workspace().report(choice->reports);
    showMessage(
        tr("Reported %n icebergs from %1", nullptr, static_cast<int>(choice->reports.size()))
            .arg(QFileInfo(path).fileName()),
        kMessage_ms);
}

void SightingsImport::acceptImport(const ImportChoice& choice, const QString& fileName)
{
    if (choice.intoNew) {
        if (!m_files.confirmDiscardScenario())
            return;
        workspace().document().restore(choice.scenario, {}); // it is in no file yet
    } else {
        workspace().document().edit(
            tr("Import %n icebergs from %1", nullptr, choice.icebergs).arg(fileName),
            [&](Scenario& scenario) { scenario = choice.scenario; });
        panels().map->camera().fit();
    }
    m_start.closePage();
    showMessage(tr("Imported %n icebergs from %1", nullptr, choice.icebergs).arg(fileName),
                kMessage_ms);
}

void SightingsImport::openDropped(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (isAirspaceEnding(ending))
        readAirspace(path);
    else if (sightingEndings().contains(ending))
        importSightings(path); // a .txt may be either
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
