#include "widgets/document/file_lock.h"

#include <QCoreApplication>
#include <QFile>
#include <QSysInfo>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace berg {
namespace {

/** Returns whether the open file still has this name: its last holder may just have removed it. */
bool isNamed(int fd, const QByteArray& path)
{
    struct stat open
    {
    };
    struct stat named
    {
    };
    return ::fstat(fd, &open) == 0 && ::stat(path.constData(), &named) == 0 &&
           open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

void writeHolder(int fd)
{
    const QByteArray text = QByteArray::number(QCoreApplication::applicationPid()) + '\n' +
                            QSysInfo::machineHostName().toUtf8() + '\n';
    // Only the text of a question uses the holder: the lock holds without it.
    if (::ftruncate(fd, 0) == 0) {
        [[maybe_unused]] const ssize_t written =
            ::write(fd, text.constData(), static_cast<std::size_t>(text.size()));
    }
}

} // namespace

FileLock::FileLock(FileLock&& other) noexcept
    : m_path(std::move(other.m_path)), m_fd(std::exchange(other.m_fd, -1))
{
}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
    if (this != &other) {
        release();
        m_path = std::move(other.m_path);
        m_fd = std::exchange(other.m_fd, -1);
    }
    return *this;
}

FileLock::Outcome FileLock::take(const QString& path)
{
    release();
    const QByteArray name = QFile::encodeName(path);
    for (;;) {
        const int fd = ::open(name.constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (fd < 0)
            return Outcome::Impossible;
        if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
            const bool busy = errno == EWOULDBLOCK;
            ::close(fd);
            return busy ? Outcome::Busy : Outcome::Impossible;
        }
        if (isNamed(fd, name)) {
            writeHolder(fd);
            m_path = path;
            m_fd = fd;
            return Outcome::Taken;
        }
        ::close(fd);
    }
}

void FileLock::release()
{
    if (m_fd < 0)
        return;
    ::unlink(QFile::encodeName(m_path).constData()); // while we still hold the lock
    ::close(std::exchange(m_fd, -1));
}

LockHolder lockHolder(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QList<QByteArray> lines = file.read(4096).split('\n');
    const qint64 pid = lines.value(0).toLongLong();
    return {.pid = pid > 0 ? std::optional(pid) : std::nullopt,
            .host = QString::fromUtf8(lines.value(1))};
}

} // namespace berg
