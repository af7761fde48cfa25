#pragma once

#include <QString>

namespace berg {

/** Who has taken a lock, as the lock file says. */
struct LockHolder
{
    qint64 pid = 0; ///< 0: unknown
    QString host;
};

/**
 * A lock that lives as long as this object and, at the latest, as long as its process: the kernel
 * lets go of it (`flock`), so neither a crash nor a process number used again can leave one behind.
 * Two objects of one process exclude each other as well.
 */
class FileLock
{
public:
    enum class Outcome
    {
        Taken,
        Busy,
        Impossible ///< the file cannot be made, or the file system has no locks
    };

    FileLock() = default;
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock() { release(); }

    /** Makes `path`, whose folder must exist, and writes into it who holds it. Never waits. */
    [[nodiscard]] Outcome take(const QString& path);
    /** Removes the file. */
    void release();
    [[nodiscard]] bool isHeld() const { return m_fd >= 0; }

private:
    QString m_path;
    int m_fd = -1;
};

/** What the lock file says; meaningful while the lock is busy. */
[[nodiscard]] LockHolder lockHolder(const QString& path);

} // namespace berg
