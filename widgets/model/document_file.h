#pragma once

#include "widgets/model/file_lock.h"

#include <QByteArray>
#include <QDateTime>
#include <QObject>

#include <optional>
#include <set>

namespace berg {

class ScenarioDocument;

/**
 * The document's file on disk: locked against other windows, watched for changes made by others,
 * copied before it is first written over.
 *
 * Locks are in a folder of the user, named after the canonical path, not beside the file: read-only
 * folders, memory sticks and synchronised folders stay as they are, and all links to a file mean
 * one lock. Somebody on another computer is so not seen; what he saves is (`isChangedOutside`).
 * GUI thread.
 */
class DocumentFile : public QObject
{
    Q_OBJECT

public:
    explicit DocumentFile(ScenarioDocument& document, QObject* parent = nullptr);

    /** From now on; before, nothing is locked. */
    void setLockFolder(const QString& folder);
    /** Who else has this file open; none: nobody, or nobody who can be seen. */
    [[nodiscard]] std::optional<LockHolder> otherHolder(const QString& path) const;

    /** The content is not what was opened or saved here. A file that is gone counts as unchanged.
     */
    [[nodiscard]] bool isChangedOutside();
    /** The document is older than what is on disk. */
    void setOutdated() { m_seen.reset(); }

    /**
     * Saves the document. With `keepOld`, what a file holds that is written for the first time
     * since the program began is kept as `PATH~`; false when that was not possible. Throws `Error`
     * of `ScenarioDocument::save`.
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
    QString m_lockPath; ///< of the file that is open
    FileLock m_lock;
    std::optional<Seen> m_seen;
    std::set<QString> m_written; ///< canonical paths
};

} // namespace berg
