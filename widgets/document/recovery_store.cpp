#include "widgets/document/recovery_store.h"

#include "core/io/files/recovery_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/text/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include <algorithm>
#include <optional>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

const QString kEnding = u".berg"_s;

std::string nativePath(const QString& path)
{
    return QFile::encodeName(path).toStdString();
}

/** Returns the data file, or what the scenario gives if it is missing or damaged. */
RecoveryInfo readInfo(const RecoveryFiles& files, const Scenario& scenario)
{
    RecoveryInfo info{.name = QString::fromStdString(scenario.name),
                      .edited = QFileInfo(files.scenario()).lastModified()};
    try {
        const std::string path = nativePath(files.info());
        const RecoveryNote note = recoveryFromJson(readFile(path), path);
        info.originalPath = QString::fromStdString(note.originalPath);
        info.pid = note.pid;
        info.host = QString::fromStdString(note.host);
        const QDateTime edited =
            QDateTime::fromString(QString::fromStdString(note.editedUtc), Qt::ISODateWithMs);
        if (edited.isValid())
            info.edited = edited.toLocalTime();
    } catch (const Error&) { // the scenario is enough
    }
    return info;
}

/** Returns the current flight, or null if there is none or it cannot be read. */
std::shared_ptr<const RunFile> readRun(const RecoveryFiles& files)
try {
    return std::make_shared<const RunFile>(loadRun(nativePath(files.run())));
} catch (const Error&) { // the scenario is enough
    return nullptr;
}

/** Renames an unreadable file, so that it can still be examined. */
QString setAside(const RecoveryFiles& files)
{
    QString aside = files.scenario() + u".damaged"_s;
    QFile::rename(files.scenario(), aside);
    return aside;
}

} // namespace

QString RecoveryFiles::scenario() const
{
    return QDir(folder).filePath(id + kEnding);
}

QString RecoveryFiles::info() const
{
    return QDir(folder).filePath(id + u".json"_s);
}

QString RecoveryFiles::lock() const
{
    return QDir(folder).filePath(id + u".lock"_s);
}

QString RecoveryFiles::run() const
{
    return QDir(folder).filePath(id + u".bergrun"_s);
}

void writeRecovery(const RecoveryFiles& files, const Scenario& scenario, const RecoveryInfo& info,
                   const RunFile* run)
{
    const RecoveryNote note{.originalPath = info.originalPath.toStdString(),
                            .editedUtc =
                                info.edited.toUTC().toString(Qt::ISODateWithMs).toStdString(),
                            .pid = info.pid,
                            .host = info.host.toStdString()};
    if (run == nullptr) // a run must not stay beside another scenario
        QFile::remove(files.run());
    writeFileAtomically(nativePath(files.scenario()), scenarioToJson(scenario));
    writeFileAtomically(nativePath(files.info()), recoveryToJson(note));
    if (run != nullptr) // written last, because the scenario matters more
        saveRun(*run, nativePath(files.run()));
}

void removeRecovery(const RecoveryFiles& files)
{
    const QDir folder(files.folder);
    const QString lock = QFileInfo(files.lock()).fileName();
    for (const QString& name :
         folder.entryList({u'*' + files.id + u'*'}, QDir::Files | QDir::Hidden))
        if (name != lock)
            QFile::remove(folder.filePath(name));
}

void removeEmptyRecoveries(const QString& folder, const QString& ending)
{
    for (const QFileInfo& file : QDir(folder).entryInfoList({u"*.lock"_s}, QDir::Files)) {
        HeldRecovery held{.files = {.folder = folder, .id = file.completeBaseName()}, .lock = {}};
        const QString content = QDir(folder).filePath(held.files.id + ending);
        if (!QFile::exists(content) &&
            held.lock.take(held.files.lock()) == FileLock::Outcome::Taken &&
            !QFile::exists(content)) // it may have been written since
            removeRecovery(held.files);
    }
}

HeldRecovery RecoveryStore::add() const
{
    HeldRecovery held{
        .files = {.folder = m_folder, .id = QUuid::createUuid().toString(QUuid::WithoutBraces)},
        .lock = {}};
    if (!QDir().mkpath(m_folder) || held.lock.take(held.files.lock()) != FileLock::Outcome::Taken)
        throw Error(ErrorCode::FileUnwritable, nativePath(held.files.lock()),
                    {IssueId::CannotMake});
    return held;
}

FoundRecoveries RecoveryStore::abandoned() const
{
    removeEmptyRecoveries(m_folder, kEnding);
    FoundRecoveries found;
    for (const QFileInfo& file : QDir(m_folder).entryInfoList({u'*' + kEnding}, QDir::Files)) {
        HeldRecovery held{.files = {.folder = m_folder, .id = file.completeBaseName()}, .lock = {}};
        if (held.lock.take(held.files.lock()) != FileLock::Outcome::Taken)
            continue;
        try {
            Scenario scenario =
                loadScenario(nativePath(held.files.scenario()), ScenarioUse::Editing);
            RecoveryInfo info = readInfo(held.files, scenario);
            std::shared_ptr<const RunFile> run = readRun(held.files);
            found.usable.push_back({.held = std::move(held),
                                    .info = std::move(info),
                                    .scenario = std::move(scenario),
                                    .run = std::move(run)});
        } catch (const Error& error) {
            // If it is gone, its window has just closed.
            if (error.code() != ErrorCode::FileNotFound)
                found.damaged << setAside(held.files);
        }
    }
    std::sort(found.usable.begin(), found.usable.end(),
              [](const FoundRecovery& a, const FoundRecovery& b) {
                  return a.info.edited > b.info.edited;
              });
    return found;
}

} // namespace berg
