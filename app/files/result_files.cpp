#include "app/files/result_files.h"

#include "app/files/file_names.h"
#include "app/layout/panels.h"
#include "app/layout/run_with_progress.h"
#include "core/io/text/file_set.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/print/export_painter.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

QString pathOf(const ExportFile& file)
{
    return QFile::decodeName(QByteArray::fromStdString(file.path));
}

} // namespace

ResultFiles::ResultFiles(WindowContext& context) : WindowPart(context)
{
    MissionRunner& runner = workspace().runner();
    runner.setExportPaint(exportPaint());
    connect(&runner, &MissionRunner::exportReady, this, &ResultFiles::writeExport);
    connect(&runner, &MissionRunner::runReady, this,
            [this](const QString& path, const std::shared_ptr<const RunFile>& run) {
                m_isRunSaved = writeRun(path, *run);
            });
    connect(&runner, &MissionRunner::commandRefused, this,
            [this] { m_isRunSaved = m_isRunSaved.value_or(false); });
    for (const ChartPanel* chart : panels().charts)
        connect(chart, &ChartPanel::exportRequested, this, [this, chart] { exportChart(*chart); });
}

/** Returns the path that the user chose; empty if cancelled. */
QString ResultFiles::runPath()
{
    const QString chosen = interaction().savePath(&window(), u"flight.bergrun"_s,
                                                  tr("Runs (*.bergrun);;All files (*)"));
    return chosen.isEmpty() ? chosen : withExtension(chosen, u"bergrun"_s);
}

void ResultFiles::saveRun()
{
    if (const QString path = runPath(); !path.isEmpty())
        workspace().runner().requestRun(path);
}

bool ResultFiles::saveRunNow()
{
    workspace().pause();
    const QString path = runPath();
    if (path.isEmpty())
        return false;
    m_isRunSaved.reset();
    workspace().runner().requestRun(path);
    interaction().waitUntil(
        &window(), tr("The run is saved as soon as the current plan is made."),
        [this] { return m_isRunSaved.has_value(); }, true);
    return m_isRunSaved.value_or(false);
}

bool ResultFiles::writeRun(const QString& path, const RunFile& run)
{
    if (!attempt([&] {
            runWithProgress(interaction(), &window(),
                            tr("Saving %1").arg(QFileInfo(path).fileName()),
                            [&] { berg::saveRun(run, QFile::encodeName(path).toStdString()); });
        }))
        return false;
    workspace().noteSaved(run);
    showMessage(tr("Saved %1").arg(path), kMessage_ms);
    return true;
}

void ResultFiles::exportPlan()
{
    chooseExport(settings().value("export/format").toString().toStdString());
}

void ResultFiles::copyPicture()
{
    QApplication::clipboard()->setPixmap(panels().map->grab());
    showMessage(tr("Picture of the map copied"), kMessage_ms);
}

void ResultFiles::chooseExport(const std::string& formatId)
{
    const ScenarioDocument& document = workspace().document();
    const QString folder = settings().value("export/folder", QDir::homePath()).toString();
    const QString name = fileNameOf(QString::fromStdString(document.scenario().name));
    const ExportOffer offer{.suggested = {.formatId = formatId,
                                          .options = m_exportOptions,
                                          .path = QDir(folder).filePath(name)},
                            .flown = workspace().inFlight(),
                            .scenario = std::make_shared<const Scenario>(document.scenario()),
                            .theme = theme()};
    const std::uint64_t generation = workspace().runner().generation();
    const std::optional<ExportRequest> choice =
        interaction().chooseExport(&window(), workspace().runner(), offer);
    if (!isStillOf(generation) || !choice)
        return;
    settings().setValue("export/folder", QFileInfo(choice->path).absolutePath());
    settings().setValue("export/format", QString::fromStdString(choice->formatId));
    m_exportOptions = choice->options;
    workspace().runner().requestExport(*choice);
}

/** Returns false and shows a message if the content to export was replaced while the dialog was
 * open. */
bool ResultFiles::isStillOf(std::uint64_t generation)
{
    const bool isOf = generation == workspace().runner().generation();
    if (!isOf)
        showMessage(outdatedExportText(), kMessage_ms);
    return isOf;
}

/** Asks once about all files that are there already. */
void ResultFiles::writeExport(const std::vector<ExportFile>& files)
{
    const std::uint64_t generation = workspace().runner().generation();
    QStringList present;
    for (const ExportFile& file : files)
        if (const QFileInfo info(pathOf(file)); info.exists())
            present << info.fileName();
    const auto answer =
        present.isEmpty() ? Interaction::Overwrite::Overwrite
                          : interaction().askOverwrite(
                                &window(), present.join(u", "_s),
                                tr("%n files with these names exist. Their content would be lost.",
                                   nullptr, static_cast<int>(present.size())));
    if (answer == Interaction::Overwrite::SaveAs)
        exportPlan();
    if (answer != Interaction::Overwrite::Overwrite || !isStillOf(generation))
        return;
    attempt([&] {
        writeFileSet(files);
        showMessage(files.size() == 1
                        ? tr("Exported %1").arg(pathOf(files.front()))
                        : tr("Exported %n files", nullptr, static_cast<int>(files.size())),
                    kMessage_ms);
    });
}

void ResultFiles::exportChart(const ChartPanel& chart)
{
    const QString path =
        interaction().savePath(&window(), chart.exportName(), ChartPanel::exportFilters());
    if (path.isEmpty())
        return;
    attempt([&] {
        chart.exportChart(path);
        showMessage(tr("Exported %1").arg(path), kMessage_ms);
    });
}

} // namespace berg
