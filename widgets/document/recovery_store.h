#pragma once

#include "core/io/files/run_json.h"
#include "core/scenario/scenario.h"
#include "widgets/document/file_lock.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace berg {

/** Data about unsaved work besides the scenario itself. */
struct RecoveryInfo
{
    QString name;         ///< name of the scenario; may be empty
    QString originalPath; ///< file of the scenario; empty if it was never saved
    QDateTime edited;
    qint64 pid = 0; ///< process that wrote it
    QString host;
};

/**
 * Paths of the files of one recovery: `<id>.berg`, its data in `<id>.json`, `<id>.bergrun` for a
 * flight in progress, and `<id>.lock`.
 */
struct RecoveryFiles
{
    QString folder;
    QString id;

    [[nodiscard]] QString scenario() const;
    [[nodiscard]] QString info() const;
    [[nodiscard]] QString run() const;
    [[nodiscard]] QString lock() const;
};

/**
 * Writes the files, each completely or not at all. `run` is null without a flight. Throws
 * `Error{FileUnwritable}`. Thread: any.
 */
void writeRecovery(const RecoveryFiles& files, const Scenario& scenario, const RecoveryInfo& info,
                   const RunFile* run = nullptr);
/** Removes the files and leftovers of a killed writer; the lock stays. Thread: any. */
void removeRecovery(const RecoveryFiles& files);

/** Removes recoveries whose program was killed before it wrote `<id><ending>`. Thread: any. */
void removeEmptyRecoveries(const QString& folder, const QString& ending);

/** A recovery that is locked against other programs while this object lives. */
struct HeldRecovery
{
    RecoveryFiles files;
    FileLock lock;
};

/** Work of a program that no longer runs, locked while it is offered to the user. */
struct FoundRecovery
{
    HeldRecovery held;
    RecoveryInfo info;
    Scenario scenario;
    /** Null if nothing was flown or the run cannot be read. */
    std::shared_ptr<const RunFile> run = {};
};

struct FoundRecoveries
{
    std::vector<FoundRecovery> usable; ///< newest first
    QStringList damaged;               ///< new paths of unreadable files
};

/**
 * The folder of recoveries, one for each window with unsaved changes. A window holds the lock of
 * its own; a free lock belongs to a program that ended without removing it.
 */
class RecoveryStore
{
public:
    explicit RecoveryStore(QString folder) : m_folder(std::move(folder)) {}

    /** Adds an empty recovery and creates the folder. Throws `Error{FileUnwritable}`. */
    [[nodiscard]] HeldRecovery add() const;
    /**
     * Returns and locks all recoveries whose lock is free. One whose scenario cannot be read is
     * renamed to `<id>.berg.damaged` and ignored from then on.
     */
    [[nodiscard]] FoundRecoveries abandoned() const;

private:
    QString m_folder;
};

} // namespace berg
