#include "core/io/temporary_file.h"

#include "core/io/file_descriptor.h"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>

namespace berg {

namespace {

constexpr std::string_view kTemporaryEnding = ".tmp";

/** Whether `name` has the form `.TARGET.PID-NUMBER.tmp`. */
bool isTemporaryName(std::string_view name)
{
    const auto dropDigits = [&name] {
        const std::size_t before = name.size();
        while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0)
            name.remove_suffix(1);
        return name.size() < before;
    };
    const auto drop = [&name](std::string_view end) {
        const bool ends = name.ends_with(end);
        name.remove_suffix(ends ? end.size() : 0);
        return ends;
    };
    return name.starts_with('.') && drop(kTemporaryEnding) && dropDigits() && drop("-") &&
           dropDigits() && drop(".") && name.size() > 1;
}

/**
 * Runs in a forked copy of this process that has the calling thread only, so it may use nothing but
 * system calls.
 */
[[noreturn]] void placeAll(std::span<const Placing> placings, int reportTo)
{
    for (const Placing& placing : placings) {
        const bool isNamed =
            placing.link.empty() || ::linkat(AT_FDCWD, placing.link.c_str(), AT_FDCWD,
                                             placing.name.c_str(), AT_SYMLINK_FOLLOW) == 0;
        if (!isNamed)
            break;
        if (::rename(placing.name.c_str(), placing.target.c_str()) != 0) {
            if (!placing.link.empty())
                ::unlink(placing.name.c_str());
            break;
        }
        // A killed parent cannot read this; the remaining files are renamed all the same.
        [[maybe_unused]] const ssize_t reports = ::write(reportTo, "+", 1);
    }
    ::_exit(0);
}

} // namespace

std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::size_t placeInChildProcess(std::span<const Placing> placings)
{
    int ends[2] = {-1, -1};
    if (placings.empty() || ::pipe2(ends, O_CLOEXEC) != 0)
        return 0;
    const Descriptor reports(ends[0]);
    Descriptor reportTo(ends[1]);
    sigset_t all;
    sigset_t before;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before); // keeps Ctrl-C from interrupting the renames
    const pid_t other = ::fork();
    if (other == 0)
        placeAll(placings, reportTo.get());
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (!reportTo.close() || other < 0)
        return 0;
    std::size_t placed = 0;
    for (char mark = 0;;) {
        const ssize_t got = ::read(reports.get(), &mark, 1);
        if (got == 0 || (got < 0 && errno != EINTR))
            break;
        placed += got > 0 ? 1U : 0U;
    }
    while (::waitpid(other, nullptr, 0) < 0 && errno == EINTR)
        continue;
    return placed;
}

void removeLeftTemporaries(const std::filesystem::path& folder)
{
    std::error_code failure;
    for (std::filesystem::directory_iterator it(folder, failure), end; !failure && it != end;
         it.increment(failure)) {
        if (!isTemporaryName(it->path().filename().string()))
            continue;
        const Descriptor left(
            ::open(it->path().c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
        struct stat found = {};
        if (left.isOpen() && ::fstat(left.get(), &found) == 0 && S_ISREG(found.st_mode) &&
            ::flock(left.get(), LOCK_EX | LOCK_NB) == 0)
            ::unlink(it->path().c_str());
    }
}

TemporaryFile::TemporaryFile(const std::filesystem::path& target, Name name) : m_target(target)
{
    if (name == Name::Late)
        m_fd = ::open(folderOf(target).c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0666);
    m_isNamed = m_fd < 0;
    if (m_isNamed)
        acceptName([this](const char* path) {
            m_fd = ::open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            return m_fd >= 0;
        });
    if (m_fd >= 0)
        ::flock(m_fd, LOCK_EX | LOCK_NB);
}

TemporaryFile::~TemporaryFile()
{
    if (m_fd < 0)
        return;
    if (m_isNamed && !m_placed)
        ::unlink(m_path.c_str());
    ::close(m_fd);
}

bool TemporaryFile::flush() const
{
    if (::fsync(m_fd) != 0)
        return false;
    const int copy = ::dup(m_fd); // some file systems report errors only when a file is closed
    return copy >= 0 && ::close(copy) == 0;
}

void TemporaryFile::copyAttributes(const struct stat& from) const
{
    // Only root may give files away; for everyone else the file simply stays their own.
    // Ownership comes first, because changing it clears the set-id bits.
    [[maybe_unused]] const int owner = ::fchown(m_fd, from.st_uid, from.st_gid);
    [[maybe_unused]] const int mode = ::fchmod(m_fd, from.st_mode & 07777U);
}

bool TemporaryFile::place()
{
    if (!m_isNamed)
        m_isNamed = acceptName([this](const char* path) {
            return ::linkat(AT_FDCWD, link().c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
        });
    m_placed = m_isNamed && ::rename(m_path.c_str(), m_target.c_str()) == 0;
    return m_placed;
}

Placing TemporaryFile::placing() const
{
    return {.link = m_isNamed ? std::string() : link(),
            .name = m_isNamed ? m_path.string() : nameOf(0).string(),
            .target = m_target.string()};
}

std::filesystem::path TemporaryFile::nameOf(int number) const
{
    // A file name may have at most 255 bytes, which the target's own name may use up.
    constexpr std::size_t kLongestStem = 200;
    return m_target.parent_path() /
           ('.' + m_target.filename().string().substr(0, kLongestStem) + '.' +
            std::to_string(::getpid()) + '-' + std::to_string(number))
               .append(kTemporaryEnding);
}

std::string TemporaryFile::link() const
{
    return "/proc/self/fd/" + std::to_string(m_fd);
}

template <class Make>
bool TemporaryFile::acceptName(const Make& make)
{
    constexpr int kMostTries = 1000;
    for (int i = 0; i < kMostTries; ++i) {
        m_path = nameOf(i);
        if (make(m_path.c_str()))
            return true;
        if (errno != EEXIST)
            return false;
    }
    return false;
}

} // namespace berg
