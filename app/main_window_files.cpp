#include "app/main_window.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/io/scenario_json.h"
#include "core/scenario/presets.h"
#include "widgets/map/map_view.h"
#include "widgets/model/error_text.h"
#include "widgets/panels/inspector_panel.h"

#include <QCloseEvent>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QStandardPaths>
#include <QStatusBar>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kRecentFiles = 8;

QString scenarioFilter()
{
    return MainWindow::tr("Scenarios (*.berg);;All files (*)");
}

QString withExtension(const QString& path, const QString& extension)
{
    return QFileInfo(path).suffix().isEmpty() ? path + u'.' + extension : path;
}

/** "QGroundControl (*.plan);;..." in the order of the table of formats. */
QString exportFilter()
{
    QStringList filters;
    for (const ExportFormat& format : exportFormats())
        filters += u"%1 (*.%2)"_s.arg(
            QString::fromUtf8(format.reader.data(), qsizetype(format.reader.size())),
            QString::fromUtf8(format.extension.data(), qsizetype(format.extension.size())));
    return filters.join(u";;"_s);
}

} // namespace

bool MainWindow::maySettleChanges()
{
    const ScenarioDocument& document = m_workspace.document();
    if (document.isClean())
        return true;
    const QString name = QString::fromStdString(document.scenario().name);
    switch (m_interaction.askUnsaved(this, name.isEmpty() ? tr("Untitled") : name)) {
    case Interaction::Unsaved::Save:
        return saveScenario();
    case Interaction::Unsaved::Discard:
        return true;
    case Interaction::Unsaved::Cancel:
        return false;
    }
    return false;
}

void MainWindow::newScenario()
{
    if (!maySettleChanges())
        return;
    Scenario scenario = randomScenario(1, {.icebergs = 0});
    scenario.name = tr("New scenario").toStdString();
    m_workspace.document().reset(scenario);
}

void MainWindow::openScenario()
{
    const QString path = m_interaction.openPath(this, scenarioFilter());
    if (!path.isEmpty())
        openFile(path);
}

bool MainWindow::openFile(const QString& path)
{
    if (!maySettleChanges())
        return false;
    try {
        m_workspace.document().open(path);
        rememberFile(path);
        return true;
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
        return false;
    }
}

bool MainWindow::saveScenario()
{
    const QString path = m_workspace.document().filePath();
    return path.isEmpty() ? saveScenarioAs() : saveTo(path);
}

bool MainWindow::saveScenarioAs()
{
    const ScenarioDocument& document = m_workspace.document();
    const QString suggested = document.filePath().isEmpty()
                                  ? QString::fromStdString(document.scenario().name) + u".berg"_s
                                  : document.filePath();
    const QString path = m_interaction.savePath(this, suggested, scenarioFilter());
    return !path.isEmpty() && saveTo(withExtension(path, u"berg"_s));
}

bool MainWindow::saveTo(const QString& path)
{
    m_inspector->finishTyping();
    try {
        m_workspace.document().save(path);
        rememberFile(path);
        statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
        return true;
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
        return false;
    }
}

void MainWindow::saveRun()
{
    const QString chosen =
        m_interaction.savePath(this, u"flight.bergrun"_s, tr("Runs (*.bergrun);;All files (*)"));
    if (chosen.isEmpty())
        return;
    const QString path = withExtension(chosen, u"bergrun"_s);
    connect(
        &m_workspace.runner(), &MissionRunner::runReady, this,
        [this, path](const std::shared_ptr<const RunFile>& run) {
            try {
                berg::saveRun(*run, QFile::encodeName(path).toStdString());
                statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
            } catch (const Error& error) {
                m_interaction.showError(this, errorReport(error));
            }
        },
        Qt::SingleShotConnection);
    m_workspace.runner().requestRun();
}

void MainWindow::exportPlan()
{
    const ScenarioDocument& document = m_workspace.document();
    const QString name = QString::fromStdString(document.scenario().name);
    const QString path = m_interaction.savePath(this, name + u".plan"_s, exportFilter());
    if (path.isEmpty())
        return;
    const QString suffix = QFileInfo(path).suffix();
    for (const ExportFormat& format : exportFormats())
        if (suffix.toStdString() == format.extension)
            return writeExport(path, QString::fromStdString(std::string(format.id)));
    m_interaction.showError(
        this, tr("The ending of the file name says the format: .plan, .waypoints, .geojson or "
                 ".csv; \"%1\" is none of them.")
                  .arg(QFileInfo(path).fileName()));
}

void MainWindow::writeExport(const QString& path, const QString& formatId)
{
    connect(
        &m_workspace.runner(), &MissionRunner::exportReady, this,
        [this, path](const std::string& content) {
            try {
                writeFileAtomically(QFile::encodeName(path).toStdString(), content);
                statusBar()->showMessage(tr("Exported %1").arg(path), 4000);
            } catch (const Error& error) {
                m_interaction.showError(this, errorReport(error));
            }
        },
        Qt::SingleShotConnection);
    m_workspace.runner().requestExport(formatId.toStdString());
}

void MainWindow::rememberFile(const QString& path)
{
    QStringList files = m_settings.value("files/recent").toStringList();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setValue("files/recent", files.mid(0, kRecentFiles));
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    for (const QString& path : m_settings.value("files/recent").toStringList())
        m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { openFile(path); });
    if (m_recentMenu->isEmpty())
        m_recentMenu->addAction(tr("No files yet"))->setEnabled(false);
}

} // namespace berg
