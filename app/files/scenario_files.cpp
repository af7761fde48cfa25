#include "app/files/scenario_files.h"

#include "app/files/file_names.h"
#include "app/layout/panels.h"
#include "app/layout/run_with_progress.h"
#include "app/start/start_content.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/presets/presets.h"
#include "widgets/workspace/workspace.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kKeepOldKey = "files/keepOld"; ///< on by default
constexpr const char* kRecentFilesKey = "files/recent";
constexpr int kRecentFiles = 8;

QString scenarioFilter()
{
    return ScenarioFiles::tr("Scenarios (*.berg);;All files (*)");
}

/** "Bergwatch, process 4711 on fram": whoever has a file open. */
QString holderText(const LockHolder& holder)
{
    return holder.pid
               ? ScenarioFiles::tr("Bergwatch, process %1 on %2").arg(*holder.pid).arg(holder.host)
               : ScenarioFiles::tr("Another Bergwatch");
}

} // namespace

ScenarioFiles::ScenarioFiles(WindowContext& context) : WindowPart(context)
{
    if (const QString path = workspace().document().filePath(); !path.isEmpty())
        remember(path); // of the command line
}

bool ScenarioFiles::isStudyFile(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"bergstudy"_s;
}

bool ScenarioFiles::isRunFile(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"bergrun"_s;
}

bool ScenarioFiles::isTelemetryLog(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"tlog"_s;
}

bool ScenarioFiles::confirmDiscardScenario()
{
    panels().finishTyping();
    if (workspace().document().isClean())
        return mayEndFlight();
    const bool wasInFlight = workspace().inFlight();
    return maySettleChanges(workspace().isMidFlight()) && mayAnswer(wasInFlight);
}

bool ScenarioFiles::maySettleChanges(bool endsFlight)
{
    panels().finishTyping();
    const ScenarioDocument& document = workspace().document();
    if (document.isClean())
        return true;
    const QString name = QString::fromStdString(document.scenario().name);
    const auto answer = interaction().askUnsaved(
        &window(), {.name = name.isEmpty() ? tr("Untitled") : name, .endsFlight = endsFlight});
    return answer == Interaction::Unsaved::Discard ||
           (answer == Interaction::Unsaved::Save && saveScenario());
}

bool ScenarioFiles::mayEndFlight()
{
    return !workspace().isMidFlight() ||
           interaction().askEndFlight(&window(), Interaction::FlightEnd::Other);
}

bool ScenarioFiles::mayAnswer(bool wasInFlight)
{
    if (wasInFlight || !workspace().inFlight())
        return true;
    if (!interaction().askEndFlight(&window(), Interaction::FlightEnd::Answer))
        return false;
    workspace().reset();
    return true;
}

bool ScenarioFiles::newScenario()
{
    if (!confirmDiscardScenario())
        return false;
    Scenario scenario = randomScenario(1, {.icebergs = 0});
    scenario.name = tr("New scenario").toStdString();
    for (Uav& uav : scenario.uavs)
        uav.position_m = Point::Zero(); // the place that is typed is where it starts
    workspace().document().reset(scenario);
    return true;
}

void ScenarioFiles::openScenario()
{
    const bool wasInFlight = workspace().inFlight();
    const QString path =
        interaction().openPath(&window(), tr("Scenarios, runs, studies and telemetry logs (*.berg "
                                             "*.bergrun *.bergstudy *.tlog);;All files (*)"));
    const bool staysBeside = isStudyFile(path) || isTelemetryLog(path);
    if (!path.isEmpty() && (staysBeside || mayAnswer(wasInFlight)))
        openFile(path);
}

/** False: another window has the file, and the user then does not want it. */
bool ScenarioFiles::openUnlessInUse(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    const std::optional<LockHolder> holder = workspace().file().otherHolder(path);
    const Interaction::InUse choice =
        holder ? interaction().askInUse(&window(), name, holderText(*holder))
               : Interaction::InUse::OpenAnyway;
    switch (choice) {
    case Interaction::InUse::OpenCopy:
        workspace().document().reset(
            loadScenario(QFile::encodeName(path).toStdString(), ScenarioUse::Editing));
        showMessage(tr("Opened a copy of %1").arg(name), kMessage_ms);
        return true;
    case Interaction::InUse::OpenAnyway:
        if (isRunFile(path))
            return openRun(path);
        workspace().openFile(path);
        return true;
    case Interaction::InUse::Cancel:
        return false;
    }
    return false;
}

/** False: the user did not want to wait. */
bool ScenarioFiles::openRun(const QString& path)
{
    std::shared_ptr<const RunFile> run;
    const bool isRead =
        runWithProgress(interaction(), &window(), tr("Reading %1").arg(QFileInfo(path).fileName()),
                        [&](const std::stop_token& stop) {
                            run = std::make_shared<const RunFile>(
                                loadRun(QFile::encodeName(path).toStdString(), stop));
                        });
    if (isRead)
        workspace().openRun(std::move(run));
    return isRead;
}

bool ScenarioFiles::openFile(const QString& path)
{
    if (isStudyFile(path)) {
        workspace().studyFiles().open(path);
        return true;
    }
    if (isTelemetryLog(path)) {
        emit telemetryLogChosen(path);
        return true;
    }
    if (!confirmDiscardScenario())
        return false;
    bool isOpen = false;
    attempt([&] {
        isOpen = openUnlessInUse(path);
        if (isOpen)
            remember(path);
    });
    return isOpen;
}

void ScenarioFiles::openExample(const QString& path)
{
    if (!confirmDiscardScenario())
        return;
    attempt([&] { workspace().document().reset(loadExample(path)); });
}

bool ScenarioFiles::saveScenario()
{
    const QString path = workspace().document().filePath();
    return path.isEmpty() ? saveScenarioAs() : saveTo(path);
}

bool ScenarioFiles::saveScenarioAs()
{
    const ScenarioDocument& document = workspace().document();
    const QString suggested =
        document.filePath().isEmpty()
            ? fileNameOf(QString::fromStdString(document.scenario().name)) + u".berg"_s
            : document.filePath();
    const QString path = interaction().savePath(&window(), suggested, scenarioFilter());
    return !path.isEmpty() && saveTo(withExtension(path, u"berg"_s));
}

/** Asks when somebody else's work would be lost. */
Interaction::Overwrite ScenarioFiles::mayOverwrite(const QString& path)
{
    const QString name = QFileInfo(path).fileName();
    DocumentFile& file = workspace().file();
    if (path == workspace().document().filePath()) {
        if (file.isChangedOutside())
            return interaction().askOverwrite(
                &window(), name,
                tr("Another program has changed it since you opened it. Those changes would be "
                   "lost."));
    } else if (const std::optional<LockHolder> holder = file.otherHolder(path)) {
        return interaction().askOverwrite(
            &window(), name,
            tr("%1 has it open. Changes saved there would be lost.").arg(holderText(*holder)));
    }
    return Interaction::Overwrite::Overwrite;
}

bool ScenarioFiles::saveTo(const QString& path)
{
    panels().finishTyping();
    switch (mayOverwrite(path)) {
    case Interaction::Overwrite::Overwrite:
        break;
    case Interaction::Overwrite::SaveAs:
        return saveScenarioAs();
    case Interaction::Overwrite::Cancel:
        return false;
    }
    return attempt([&] {
        const bool keepOld = keepsOld();
        const bool isBackedUp = workspace().file().save(path, keepOld);
        remember(path);
        showMessage((isBackedUp ? tr("Saved %1")
                                : tr("Saved %1; a backup copy cannot be written to its folder"))
                        .arg(path),
                    kMessage_ms);
    });
}

void ScenarioFiles::remember(const QString& path)
{
    QStringList files = recent();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    settings().setValue(kRecentFilesKey, files.mid(0, kRecentFiles));
}

void ScenarioFiles::fillRecentMenu(QMenu& menu)
{
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const QString& path : recent()) {
        const QFileInfo file(path);
        if (!file.exists())
            continue;
        QString name = file.fileName();
        name.replace(u'&', u"&&"_s); // else the next letter is a mnemonic
        QAction* action = menu.addAction(name, this, [this, path] { openFile(path); });
        action->setToolTip(QDir::toNativeSeparators(file.absoluteFilePath()));
    }
    if (menu.isEmpty())
        menu.addAction(tr("No files yet"))->setEnabled(false);
}

QStringList ScenarioFiles::recent() const
{
    return settings().value(kRecentFilesKey).toStringList();
}

void ScenarioFiles::forget(const QString& path)
{
    QStringList files = recent();
    files.removeAll(path);
    settings().setValue(kRecentFilesKey, files);
}

bool ScenarioFiles::keepsOld() const
{
    return settings().value(kKeepOldKey, true).toBool();
}

void ScenarioFiles::setKeepsOld(bool on)
{
    settings().setValue(kKeepOldKey, on);
}

} // namespace berg
