#pragma once

#include "core/io/files/run_json.h"
#include "core/scenario/scenario.h"
#include "widgets/model/file_lock.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace berg {

/** What is known about unsaved work besides the scenario itself. */
struct RecoveryInfo
{
    QString name;         ///< of the scenario; may be empty
    QString originalPath; ///< file the scenario belongs to; empty: none yet
    QDateTime edited;
    qint64 pid = 0; ///< of the program that wrote it
    QString host;
};

/** The files of one recovery: `<id>.berg`, what is known about it beside it in `<id>.json`, and of
 * a flight under way `<id>.bergrun`. */
struct RecoveryFiles
{
    QString folder;
    QString id;

    [[nodiscard]] QString scenario() const;
    [[nodiscard]] QString info() const;
    [[nodiscard]] QString run() const;
    [[nodiscard]] QString lock() const;
};

/** Writes them, each whole or not at all; no run: none is under way. Throws
 * `Error{FileUnwritable}`. Thread: any. */
void writeRecovery(const RecoveryFiles& files, const Scenario& scenario, const RecoveryInfo& info,
                   const RunFile* run = nullptr);
/** Removes them and what a writer that was killed has left of them; the lock stays. Thread: any. */
void removeRecovery(const RecoveryFiles& files);

/**
 * What is left of recoveries whose program was killed before it had written `<id><ending>`. Thread:
 * any.
 */
void removeEmptyRecoveries(const QString& folder, const QString& ending);

/** A recovery that nobody else may touch as long as this object lives. */
struct HeldRecovery
{
    RecoveryFiles files;
    FileLock lock;
};

/** Work of a program that is gone, held by this one for as long as it is offered. */
struct FoundRecovery
{
    HeldRecovery held;
    RecoveryInfo info;
    Scenario scenario;
    std::shared_ptr<const RunFile> run = {}; ///< null: nothing was flown, or it cannot be read
};

struct FoundRecoveries
{
    std::vector<FoundRecovery> usable; ///< newest first
    QStringList damaged;               ///< set aside under these paths: a report for each
};

/**
 * The folder of recoveries, one for each window with unsaved changes. A window holds the lock of
 * its own; one whose lock is free belongs to a program that ended without removing it.
 */
class RecoveryStore
{
public:
    explicit RecoveryStore(QString folder) : m_folder(std::move(folder)) {}

    /** A new one, without content. Throws `Error{FileUnwritable}`; makes the folder. */
    [[nodiscard]] HeldRecovery add() const;
    /**
     * All that nobody holds. One whose scenario cannot be read is renamed to `<id>.berg.damaged`
     * and never looked at again.
     */
    [[nodiscard]] FoundRecoveries abandoned() const;

private:
    QString m_folder;
};

} // namespace berg
