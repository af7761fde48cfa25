#include "app/map/backdrop_file.h"

#include "app/dialogs/interaction.h"
#include "app/layout/panels.h"
#include "app/map/map_controller.h"
#include "core/io/import/import_file.h"
#include "widgets/panels/map/layers_panel.h"

#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kFileKey = "view/backdrop";

void readBackdrop(const QString& path, const std::stop_token& stop, const auto& deliver)
{
    const std::string name = QFile::encodeName(path).toStdString();
    deliver(std::make_shared<const BackdropShapes>(
        readMapShapes(readImportFile(name, name, stop), name, stop)));
}

} // namespace

BackdropFile::BackdropFile(WindowContext& context, MapController& map)
    : WindowPart(context)
    , m_map(map)
    , m_task(u"backdrop"_s, {.work = [](const QString& path, const std::stop_token& stop,
                                        const auto& deliver) { readBackdrop(path, stop, deliver); },
                             .deliver = [this](const BackdropPointer& backdrop) { show(backdrop); },
                             .end =
                                 [this](const std::optional<WorkFailure>& failure) {
                                     if (failure)
                                         report(*failure);
                                 }})
{
    connect(panels().layers, &LayersPanel::backdropRequested, this, &BackdropFile::choose);
    connect(panels().layers, &LayersPanel::backdropRemoved, this, &BackdropFile::remove);
    if (const QString path = settings().value(kFileKey).toString(); !path.isEmpty())
        open(path, false);
}

void BackdropFile::choose()
{
    const QString path = interaction().openPath(
        &window(),
        tr("Maps (*.geojson *.json *.kml *.kmz *.czml *.shp *.gpkg *.gml *.dxf *.fgb *.zip);;All "
           "files (*)"));
    if (!path.isEmpty())
        open(QFileInfo(path).absoluteFilePath(), true);
}

void BackdropFile::open(const QString& path, bool isAsked)
{
    m_path = path;
    m_isAsked = isAsked;
    m_task.start(path);
}

void BackdropFile::remove()
{
    m_task.drop();
    settings().remove(kFileKey);
    panels().layers->showBackdrop({});
    m_map.setBackdrop(nullptr);
}

void BackdropFile::show(const BackdropPointer& backdrop)
{
    settings().setValue(kFileKey, m_path);
    panels().layers->showBackdrop(m_path);
    m_map.setBackdrop(backdrop);
    if (backdrop->empty())
        showMessage(
            tr("%1 contains no points, lines or polygons").arg(QFileInfo(m_path).fileName()),
            kLongMessage_ms);
}

/** Keeps the previous map on failure. */
void BackdropFile::report(const WorkFailure& failure)
{
    const QString name = QFileInfo(m_path).fileName();
    if (!m_isAsked) {
        panels().layers->showBackdrop(m_path); // so that it can be removed
        showMessage(tr("The background map %1 cannot be read").arg(name), kLongMessage_ms);
    } else if (failure.error.code() == ErrorCode::WrongFormat)
        interaction().showError(&window(),
                                tr("%1 is neither GeoJSON nor KML. Convert it with a map program, "
                                   "such as QGIS, and choose it again.")
                                    .arg(name));
    else
        interaction().showError(&window(), failure.report);
}

} // namespace berg
