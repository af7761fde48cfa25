#include "core/io/atomic_file.h"

#include "core/base/error.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace berg {

namespace {

std::string reason(int errorNumber)
{
    return std::generic_category().message(errorNumber);
}

/** A POSIX file descriptor that closes itself. */
class Descriptor
{
public:
    explicit Descriptor(int fd) : m_fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (m_fd >= 0)
            ::close(m_fd);
    }

    [[nodiscard]] int get() const { return m_fd; }
    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }
    /** Closes now; false when the system reports that data were lost. */
    [[nodiscard]] bool close() { return ::close(std::exchange(m_fd, -1)) == 0; }

private:
    int m_fd;
};

[[noreturn]] void failWrite(const std::string& path, const std::string& why)
{
    throw Error(ErrorCode::FileUnwritable, path, "cannot be written: " + why);
}

[[nodiscard]] bool writeAll(int fd, std::string_view content)
{
    while (!content.empty()) {
        const ssize_t written = ::write(fd, content.data(), content.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return false;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/** Devices and pipes cannot be replaced, only written to. */
void writeInPlace(const std::string& path, std::string_view content)
{
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.isOpen() || !writeAll(file.get(), content) || !file.close())
        failWrite(path, reason(errno));
}

/** The file that `path` means when it is a symbolic link, also one that points to nothing yet. */
std::filesystem::path withoutLinks(const std::string& path)
{
    constexpr int kMostLinks = 40; // as the kernel allows
    std::filesystem::path target(path);
    for (int i = 0; i < kMostLinks; ++i) {
        std::error_code failure;
        const std::filesystem::path next = std::filesystem::read_symlink(target, failure);
        if (failure)
            return target;
        target = target.parent_path() / next; // an absolute `next` replaces the whole
    }
    failWrite(path, reason(ELOOP));
}

/** New file beside the target, removed again unless it was put in the target's place. */
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::filesystem::path& target)
    {
        // File names may have 255 bytes at most; the target's own may use them all.
        constexpr std::size_t kLongestStem = 200;
        constexpr int kMostTries = 1000;
        const std::string stem = '.' + target.filename().string().substr(0, kLongestStem) + "." +
                                 std::to_string(::getpid()) + "-";
        for (int i = 0; i < kMostTries && m_fd < 0; ++i) {
            m_path = target.parent_path() / (stem + std::to_string(i) + ".tmp");
            m_fd = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (m_fd < 0 && errno != EEXIST)
                return;
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (m_fd < 0)
            return;
        if (m_open)
            ::close(m_fd);
        if (!m_placed)
            ::unlink(m_path.c_str());
    }

    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }

    /** Writes, flushes to the disk and closes; false leaves the reason in errno. */
    [[nodiscard]] bool fill(std::string_view content)
    {
        if (!writeAll(m_fd, content) || ::fsync(m_fd) != 0)
            return false;
        m_open = false;
        return ::close(m_fd) == 0;
    }

    void copyAttributes(const struct stat& from) const
    {
        // Only root may give files away; for everyone else the file simply stays their own.
        // Ownership comes first, because changing it clears the set-id bits.
        [[maybe_unused]] const int owner = ::fchown(m_fd, from.st_uid, from.st_gid);
        [[maybe_unused]] const int mode = ::fchmod(m_fd, from.st_mode & 07777U);
    }

    [[nodiscard]] bool placeAt(const std::filesystem::path& target)
    {
        m_placed = ::rename(m_path.c_str(), target.c_str()) == 0;
        return m_placed;
    }

private:
    std::filesystem::path m_path;
    int m_fd = -1;
    bool m_open = true;
    bool m_placed = false;
};

/** Retrying in place would only spoil what is there. */
[[nodiscard]] bool isFull(int errorNumber)
{
    return errorNumber == ENOSPC || errorNumber == EDQUOT || errorNumber == EFBIG;
}

/**
 * Writes into the file itself, `old` what it is now (null: it is made). The room is reserved before
 * the first byte is written, so that a full disk keeps the old content.
 */
void overwrite(const std::string& path, const std::filesystem::path& target, const struct stat* old,
               std::string_view content)
{
    const int create = old == nullptr ? O_CREAT | O_EXCL : 0;
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC | create, 0666));
    if (!file.isOpen())
        failWrite(path, reason(errno));
    const auto size = static_cast<off_t>(content.size());
    const int refusal = size > 0 ? ::posix_fallocate(file.get(), 0, size) : 0;
    if (isFull(refusal)) {
        [[maybe_unused]] const int undone =
            old == nullptr ? ::unlink(target.c_str()) : ::ftruncate(file.get(), old->st_size);
        failWrite(path, reason(refusal));
    }
    if (!writeAll(file.get(), content) || ::ftruncate(file.get(), size) != 0 ||
        ::fsync(file.get()) != 0 || !file.close())
        failWrite(path, reason(errno));
}

/**
 * Puts a finished copy in the target's place; false when the folder or the file system refuses the
 * copy or the renaming. Throws when the copy cannot be written.
 */
[[nodiscard]] bool replace(const std::string& path, const std::filesystem::path& target,
                           const struct stat* old, std::string_view content)
{
    TemporaryFile temporary(target);
    if (!temporary.isOpen()) {
        if (isFull(errno))
            failWrite(path, reason(errno));
        return false;
    }
    if (old != nullptr)
        temporary.copyAttributes(*old);
    if (!temporary.fill(content))
        failWrite(path, reason(errno));
    return temporary.placeAt(target);
}

/** Makes the rename last through a power cut; file systems that cannot do it are left alone. */
void flushFolder(const std::filesystem::path& target)
{
    const std::filesystem::path folder = target.parent_path();
    const Descriptor fd(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.isOpen())
        ::fsync(fd.get());
}

} // namespace

std::string readFile(const std::string& path)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.isOpen()) {
        const bool missing = errno == ENOENT || errno == ENOTDIR;
        throw Error(missing ? ErrorCode::FileNotFound : ErrorCode::FileUnreadable, path,
                    "cannot be opened: " + reason(errno));
    }
    struct stat status
    {
    };
    if (::fstat(file.get(), &status) != 0)
        throw Error(ErrorCode::FileUnreadable, path, "cannot be read: " + reason(errno));
    if (!S_ISREG(status.st_mode))
        throw Error(ErrorCode::FileUnreadable, path, "is not a regular file");

    // The size is counted, not asked for: a file may grow while it is read.
    constexpr std::size_t kChunk = std::size_t{1} << 20U;
    std::string content;
    std::size_t size = 0;
    while (size <= kLargestFile) {
        content.resize(size + kChunk);
        const ssize_t got = ::read(file.get(), content.data() + size, kChunk);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            throw Error(ErrorCode::FileUnreadable, path, "cannot be read: " + reason(errno));
        size += static_cast<std::size_t>(got);
        if (got == 0) {
            content.resize(size);
            return content;
        }
    }
    throw Error(ErrorCode::FileTooLarge, path,
                "is larger than " + std::to_string(kLargestFile >> 20U) + " MiB");
}

void writeFileAtomically(const std::string& path, std::string_view content)
{
    struct stat status
    {
    };
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode))) {
        writeInPlace(path, content);
        return;
    }
    if (exists && !S_ISREG(status.st_mode))
        failWrite(path, S_ISDIR(status.st_mode) ? reason(EISDIR) : "not a regular file");
    // Renaming would replace a write-protected file; whoever protected it meant it.
    if (exists && ::access(path.c_str(), W_OK) != 0)
        failWrite(path, reason(errno));

    const std::filesystem::path target = withoutLinks(path);
    const struct stat* old = exists ? &status : nullptr;
    if (!replace(path, target, old, content))
        overwrite(path, target, old, content);
    flushFolder(target);
}

} // namespace berg
