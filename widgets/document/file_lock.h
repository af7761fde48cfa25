#pragma once

#include <QString>

#include <optional>

namespace berg {

/** Holder of a lock, as stated in the lock file. */
struct LockHolder
{
    std::optional<qint64> pid; ///< process id, if the file states one
    QString host;
};

/**
 * A lock that lives as long as this object and at most as long as its process: the kernel releases
 * it (`flock`), so neither a crash nor a reused process id leaves one behind. Two objects of one
 * process also exclude each other.
 */
class FileLock
{
public:
    enum class Outcome
    {
        Taken,
        Busy,
        Impossible ///< the file cannot be created, or the file system has no locks
    };

    FileLock() = default;
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock() { release(); }

    /**
     * Releases the present lock, creates `path`, whose folder must exist, locks it and writes its
     * holder. Never waits.
     */
    [[nodiscard]] Outcome take(const QString& path);
    /** Removes the file and releases the lock. */
    void release();
    [[nodiscard]] bool isHeld() const { return m_fd >= 0; }

private:
    QString m_path;
    int m_fd = -1;
};

/**
 * Returns the holder stated in the lock file as far as it can be read; meaningful while the lock is
 * busy.
 */
[[nodiscard]] LockHolder lockHolder(const QString& path);

} // namespace berg
