#pragma once

#include "widgets/document/file_lock.h"

#include <QByteArray>
#include <QDateTime>
#include <QObject>

#include <optional>
#include <set>

namespace berg {

class ScenarioDocument;

/**
 * File of the document on disk: locks it against other windows, detects changes made by others, and
 * copies it before it is first overwritten.
 *
 * Locks lie in a folder of the user, named after the canonical path, not beside the file: read-only
 * folders, memory sticks and synchronised folders stay unchanged, and all links to a file share one
 * lock. A user on another computer therefore goes unnoticed, but changes of the file do not
 * (`isChangedOutside`). GUI thread.
 */
class DocumentFile : public QObject
{
    Q_OBJECT

public:
    explicit DocumentFile(ScenarioDocument& document, QObject* parent = nullptr);

    /**
     * Sets the folder of locks, makes it if it is missing and removes the locks of killed programs
     * from it. Nothing is locked before.
     */
    void setLockFolder(const QString& folder);
    /** Returns who else has this file open, or nullopt if nobody is known to. */
    [[nodiscard]] std::optional<LockHolder> otherHolder(const QString& path) const;

    /**
     * Returns whether the content differs from what was opened or saved here. A missing file counts
     * as unchanged, one that cannot be read as changed.
     */
    [[nodiscard]] bool isChangedOutside();
    /** Records that the document is older than the file on disk. */
    void setOutdated() { m_seen.reset(); }

    /**
     * Saves the document. With `keepOld`, the previous content of a file that is written for the
     * first time in this session is copied to `PATH~`; returns false if that failed. Throws `Error`
     * as `ScenarioDocument::save`.
     */
    bool save(const QString& path, bool keepOld);

private:
    struct Seen
    {
        qint64 size = 0;
        QDateTime modified;
        QByteArray hash;
    };
    void follow();
    [[nodiscard]] QString lockPath(const QString& path) const;
    [[nodiscard]] std::optional<Seen> seen() const;

    ScenarioDocument& m_document;
    QString m_lockFolder;
    QString m_lockPath; ///< lock of the open file
    FileLock m_lock;
    std::optional<Seen> m_seen;
    std::set<QString> m_written; ///< canonical paths of files saved in this session
};

} // namespace berg
