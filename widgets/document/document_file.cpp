#include "widgets/document/document_file.h"

#include "core/io/text/atomic_file.h"
#include "widgets/document/scenario_document.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Returns the canonical path, also for a file that does not exist yet in an existing folder. */
QString canonicalPath(const QString& path)
{
    const QFileInfo file(path);
    if (QString canonical = file.canonicalFilePath(); !canonical.isEmpty())
        return canonical;
    return QDir(QFileInfo(file.absolutePath()).canonicalFilePath()).filePath(file.fileName());
}

/** Removes the locks of programs that were killed. */
void removeFreeLocks(const QString& folder)
{
    for (const QFileInfo& file : QDir(folder).entryInfoList({u"*.lock"_s}, QDir::Files)) {
        FileLock lock; // its destructor removes the file
        (void)lock.take(file.filePath());
    }
}

/** Copies a file with its permissions; returns false if that failed. */
bool copyTo(const QString& path, const QString& copy)
{
    try {
        const std::string content = readFile(QFile::encodeName(path).toStdString());
        writeFileAtomically(QFile::encodeName(copy).toStdString(), content);
        return QFile::setPermissions(copy, QFile::permissions(path));
    } catch (const Error&) {
        return false;
    }
}

} // namespace

DocumentFile::DocumentFile(ScenarioDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&m_document, &ScenarioDocument::filePathChanged, this, &DocumentFile::follow);
}

void DocumentFile::setLockFolder(const QString& folder)
{
    m_lockFolder = folder;
    QDir().mkpath(folder);
    removeFreeLocks(folder);
    follow();
}

/** Follows a document that was opened, saved, or begun without a file. */
void DocumentFile::follow()
{
    // Size and time read now could belong to a later change: leaving both unset makes the first
    // check compare the content.
    m_seen = m_document.fileHash().isEmpty() ? seen() : Seen{.hash = m_document.fileHash()};
    const QString path = m_document.filePath();
    if (!path.isEmpty())
        removeLeftovers(QFile::encodeName(path).toStdString());
    const QString lock = path.isEmpty() || m_lockFolder.isEmpty() ? QString() : lockPath(path);
    if (lock == m_lockPath && m_lock.isHeld())
        return;
    m_lock.release();
    m_lockPath = lock;
    if (!lock.isEmpty()) // another window may hold it: the user has chosen to open the file anyway
        (void)m_lock.take(lock);
}

QString DocumentFile::lockPath(const QString& path) const
{
    const QByteArray key =
        QCryptographicHash::hash(canonicalPath(path).toUtf8(), QCryptographicHash::Sha1);
    return QDir(m_lockFolder).filePath(QString::fromLatin1(key.toHex()) + u".lock"_s);
}

std::optional<LockHolder> DocumentFile::otherHolder(const QString& path) const
{
    if (m_lockFolder.isEmpty() || path.isEmpty())
        return std::nullopt;
    const QString lock = lockPath(path);
    if (lock == m_lockPath && m_lock.isHeld())
        return std::nullopt;
    FileLock attempt;
    if (attempt.take(lock) != FileLock::Outcome::Busy)
        return std::nullopt;
    return lockHolder(lock);
}

std::optional<DocumentFile::Seen> DocumentFile::seen() const
{
    const QFileInfo file(m_document.filePath());
    if (m_document.filePath().isEmpty() || !file.exists())
        return std::nullopt;
    try {
        return Seen{.size = file.size(),
                    .modified = file.lastModified(),
                    .hash = hashOf(readFile(QFile::encodeName(file.filePath()).toStdString()))};
    } catch (const Error&) {
        return std::nullopt;
    }
}

bool DocumentFile::isChangedOutside()
{
    const QFileInfo file(m_document.filePath());
    if (m_document.filePath().isEmpty() || !file.exists())
        return false;
    if (m_seen && m_seen->size == file.size() && m_seen->modified == file.lastModified())
        return false;
    const std::optional<Seen> now = seen();
    if (!now || !m_seen || now->hash != m_seen->hash)
        return true;
    m_seen = now; // rewritten with the same content
    return false;
}

bool DocumentFile::save(const QString& path, bool keepOld)
{
    const bool first = !m_written.contains(canonicalPath(path));
    const bool isBackedUp =
        !keepOld || !first || !QFileInfo::exists(path) || copyTo(path, path + u'~');
    m_document.save(path);
    m_written.insert(canonicalPath(path));
    return isBackedUp;
}

} // namespace berg
