#include "app/file_names.h"
#include "app/main_window.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/file_set.h"
#include "core/scenario/presets.h"
#include "widgets/map/map_view.h"
#include "widgets/model/error_text.h"
#include "widgets/panels/flight/chart_panel.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"

#include <QCloseEvent>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QStatusBar>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kRecentFiles = 8;
constexpr int kMessage_ms = 4000;

QString scenarioFilter()
{
    return MainWindow::tr("Scenarios (*.berg);;All files (*)");
}

/** "Bergwatch, process 4711 on fram": whoever has a file open. */
QString holderText(const LockHolder& holder)
{
    return holder.pid == 0
               ? MainWindow::tr("Another Bergwatch")
               : MainWindow::tr("Bergwatch, process %1 on %2").arg(holder.pid).arg(holder.host);
}

QString pathOf(const ExportFile& file)
{
    return QFile::decodeName(QByteArray::fromStdString(file.path));
}

} // namespace

/** What is being typed counts as if Return had been pressed. */
void MainWindow::finishTyping()
{
    m_inspector->finishTyping();
    m_icebergs->finishTyping();
    m_tradeoff->finishTyping();
}

/**
 * The gate for all that makes the present scene go away: one question about the changes that are in
 * no file and the flight under way.
 */
bool MainWindow::mayLeaveScene(Interaction::FlightEnd why)
{
    finishTyping();
    const ScenarioDocument& document = m_workspace.document();
    if (document.isClean())
        return mayEndFlight(why);
    const bool wasInFlight = m_workspace.inFlight();
    const QString name = QString::fromStdString(document.scenario().name);
    switch (m_interaction.askUnsaved(this, {.name = name.isEmpty() ? tr("Untitled") : name,
                                            .endsFlight = m_workspace.isMidFlight()})) {
    case Interaction::Unsaved::Save:
        return saveScenario() && mayAnswer(wasInFlight);
    case Interaction::Unsaved::Discard:
        return mayAnswer(wasInFlight);
    case Interaction::Unsaved::Cancel:
        return false;
    }
    return false;
}

/** A flight that has come to its end is in the list of runs, and nothing is lost. */
bool MainWindow::mayEndFlight(Interaction::FlightEnd why)
{
    return !m_workspace.isMidFlight() || m_interaction.askEndFlight(this, why);
}

/** False: a flight has begun since the question was asked, and is to go on. */
bool MainWindow::mayAnswer(bool wasInFlight)
{
    if (wasInFlight || !m_workspace.inFlight())
        return true;
    if (!m_interaction.askEndFlight(this, Interaction::FlightEnd::Answer))
        return false;
    m_workspace.reset();
    return true;
}

void MainWindow::newScenario()
{
    if (!mayLeaveScene(Interaction::FlightEnd::Other))
        return;
    Scenario scenario = randomScenario(1, {.icebergs = 0});
    scenario.name = tr("New scenario").toStdString();
    m_workspace.document().reset(scenario);
}

void MainWindow::openScenario()
{
    const bool wasInFlight = m_workspace.inFlight();
    const QString path =
        m_interaction.openPath(this, tr("Scenarios, runs and studies (*.berg *.bergrun "
                                        "*.bergstudy);;All files (*)"));
    if (!path.isEmpty() && (isStudyFile(path) || mayAnswer(wasInFlight)))
        openFile(path);
}

/** False: another window has the file, and the user then does not want it. */
bool MainWindow::openUnlessInUse(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    const std::optional<LockHolder> holder = m_workspace.file().otherHolder(path);
    const Interaction::InUse choice = holder
                                          ? m_interaction.askInUse(this, name, holderText(*holder))
                                          : Interaction::InUse::OpenAnyway;
    switch (choice) {
    case Interaction::InUse::OpenCopy:
        m_workspace.document().reset(
            loadScenario(QFile::encodeName(path).toStdString(), ScenarioUse::Editing));
        statusBar()->showMessage(tr("Opened a copy of %1").arg(name), kMessage_ms);
        return true;
    case Interaction::InUse::OpenAnyway:
        m_workspace.openFile(path);
        return true;
    case Interaction::InUse::Cancel:
        return false;
    }
    return false;
}

bool MainWindow::openFile(const QString& path)
{
    if (isStudyFile(path)) {
        m_workspace.studyFiles().open(path);
        return true;
    }
    if (!mayLeaveScene(Interaction::FlightEnd::Other))
        return false;
    try {
        if (!openUnlessInUse(path))
            return false;
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
    const QString suggested =
        document.filePath().isEmpty()
            ? fileNameOf(QString::fromStdString(document.scenario().name)) + u".berg"_s
            : document.filePath();
    const QString path = m_interaction.savePath(this, suggested, scenarioFilter());
    return !path.isEmpty() && saveTo(withExtension(path, u"berg"_s));
}

/** Asks when somebody else's work would be lost. */
Interaction::Overwrite MainWindow::mayOverwrite(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    DocumentFile& file = m_workspace.file();
    if (path == m_workspace.document().filePath()) {
        if (file.isChangedOutside())
            return m_interaction.askOverwrite(
                this, name,
                tr("Another program has changed it since you opened it. Those changes would be "
                   "lost."));
    } else if (const std::optional<LockHolder> holder = file.otherHolder(path)) {
        return m_interaction.askOverwrite(
            this, name,
            tr("%1 has it open. What is saved there would be lost.").arg(holderText(*holder)));
    }
    return Interaction::Overwrite::Overwrite;
}

bool MainWindow::saveTo(const QString& path)
{
    finishTyping();
    switch (mayOverwrite(path)) {
    case Interaction::Overwrite::Overwrite:
        break;
    case Interaction::Overwrite::SaveAs:
        return saveScenarioAs();
    case Interaction::Overwrite::Cancel:
        return false;
    }
    try {
        const bool keepOld = m_settings.value(kKeepOldKey, true).toBool();
        const bool kept = m_workspace.file().save(path, keepOld);
        rememberFile(path);
        statusBar()->showMessage(
            (kept ? tr("Saved %1") : tr("Saved %1; its folder takes no backup copy")).arg(path),
            kMessage_ms);
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
    m_workspace.runner().requestRun(withExtension(chosen, u"bergrun"_s));
}

void MainWindow::writeRun(const QString& path, const RunFile& run)
{
    try {
        berg::saveRun(run, QFile::encodeName(path).toStdString());
        statusBar()->showMessage(tr("Saved %1").arg(path), 4000);
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
    }
}

void MainWindow::exportPlan()
{
    const ScenarioDocument& document = m_workspace.document();
    const QString folder = m_settings.value("export/folder", QDir::homePath()).toString();
    const QString name = fileNameOf(QString::fromStdString(document.scenario().name));
    const ExportOffer offer{
        .suggested = {.formatId = m_settings.value("export/format").toString().toStdString(),
                      .options = m_carried.exportOptions,
                      .path = QDir(folder).filePath(name)},
        .flown = m_workspace.inFlight(),
        .scenario = std::make_shared<const Scenario>(document.scenario()),
        .theme = m_theme};
    const std::uint64_t generation = m_workspace.runner().generation();
    const std::optional<ExportRequest> choice =
        m_interaction.chooseExport(this, m_workspace.runner(), offer);
    if (!isStillOf(generation) || !choice)
        return;
    m_settings.setValue("export/folder", QFileInfo(choice->path).absolutePath());
    m_settings.setValue("export/format", QString::fromStdString(choice->formatId));
    m_carried.exportOptions = choice->options;
    m_workspace.runner().requestExport(*choice);
}

/** False, and the user is told: what was to be exported has been replaced while he was asked. */
bool MainWindow::isStillOf(std::uint64_t generation)
{
    const bool isOf = generation == m_workspace.runner().generation();
    if (!isOf)
        statusBar()->showMessage(outdatedExportText(), kMessage_ms);
    return isOf;
}

/** Asks once about all files that are there already. */
void MainWindow::writeExport(const std::vector<ExportFile>& files)
{
    const std::uint64_t generation = m_workspace.runner().generation();
    QStringList present;
    for (const ExportFile& file : files)
        if (const QFileInfo info(pathOf(file)); info.exists())
            present << info.fileName();
    const auto answer =
        present.isEmpty()
            ? Interaction::Overwrite::Overwrite
            : m_interaction.askOverwrite(
                  this, present.join(u", "_s),
                  tr("%n files of these names are there. What is in them would be lost.", nullptr,
                     static_cast<int>(present.size())));
    if (answer == Interaction::Overwrite::SaveAs)
        exportPlan();
    if (answer != Interaction::Overwrite::Overwrite || !isStillOf(generation))
        return;
    try {
        writeFileSet(files);
        statusBar()->showMessage(
            files.size() == 1 ? tr("Exported %1").arg(pathOf(files.front()))
                              : tr("Exported %n files", nullptr, static_cast<int>(files.size())),
            kMessage_ms);
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
    }
}

void MainWindow::exportChart(const ChartPanel& chart)
{
    const QString path =
        m_interaction.savePath(this, chart.exportName(), ChartPanel::exportFilters());
    if (path.isEmpty())
        return;
    try {
        chart.exportChart(path);
        statusBar()->showMessage(tr("Exported %1").arg(path), 4000);
    } catch (const Error& error) {
        m_interaction.showError(this, errorReport(error));
    }
}

void MainWindow::openRunToCompare()
{
    const QString path = m_interaction.openPath(this, tr("Runs (*.bergrun);;All files (*)"));
    if (!path.isEmpty())
        m_workspace.runs().open(path);
}

void MainWindow::rememberFile(const QString& path)
{
    QStringList files = m_settings.value(kRecentFilesKey).toStringList();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setValue(kRecentFilesKey, files.mid(0, kRecentFiles));
}

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    m_recentMenu->setToolTipsVisible(true);
    for (const QString& path : m_settings.value(kRecentFilesKey).toStringList()) {
        const QFileInfo file(path);
        if (!file.exists())
            continue;
        QString name = file.fileName();
        name.replace(u'&', u"&&"_s); // else the next letter is a mnemonic
        QAction* action = m_recentMenu->addAction(name, this, [this, path] { openFile(path); });
        action->setToolTip(QDir::toNativeSeparators(file.absoluteFilePath()));
    }
    if (m_recentMenu->isEmpty())
        m_recentMenu->addAction(tr("No files yet"))->setEnabled(false);
}

} // namespace berg
