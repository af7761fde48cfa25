#include "core/io/atomic_file.h"

#include "core/base/error.h"

#include <cerrno>
#include <charconv>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/file.h>
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

/** The descriptor that is already open under a name such as /dev/stdout; none for other paths. */
std::optional<int> openDescriptor(std::string_view path)
{
    if (path == "/dev/stdin")
        return STDIN_FILENO;
    if (path == "/dev/stdout" || path == "/dev/stderr")
        return path == "/dev/stdout" ? STDOUT_FILENO : STDERR_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!path.starts_with(folder))
            continue;
        int fd = -1;
        const char* const end = path.data() + path.size();
        const auto [last, failure] = std::from_chars(path.data() + folder.size(), end, fd);
        if (failure == std::errc() && last == end && fd >= 0)
            return fd;
    }
    return std::nullopt;
}

/** Devices and pipes cannot be replaced, only written to. */
void writeInPlace(const std::string& path, std::string_view content)
{
    if (const std::optional<int> fd = openDescriptor(path)) {
        if (!writeAll(*fd, content))
            failWrite(path, reason(errno));
        return;
    }
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

/** The folder that a file is in, as system calls want it. */
std::filesystem::path folderOf(const std::filesystem::path& file)
{
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

// Names of files that are being written: `.TARGET.PID-NUMBER.tmp`.
constexpr std::string_view kTemporaryEnding = ".tmp";

std::string temporaryStem(const std::filesystem::path& target)
{
    // File names may have 255 bytes at most; the target's own may use them all.
    constexpr std::size_t kLongestStem = 200;
    return '.' + target.filename().string().substr(0, kLongestStem) + ".";
}

/**
 * New file beside the target, removed again unless it was put in the target's place. Where the file
 * system can, it has no name until then: a program that is killed leaves nothing. Locked, which
 * tells it from one whose writer was killed.
 */
class TemporaryFile
{
public:
    enum class Name
    {
        Late,
        Early
    };

    explicit TemporaryFile(const std::filesystem::path& target, Name name = Name::Late)
        : m_target(target)
    {
        if (name == Name::Late)
            m_fd = ::open(folderOf(target).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        m_isNamed = m_fd < 0;
        if (m_isNamed)
            takeName([this](const char* path) {
                m_fd = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
                return m_fd >= 0;
            });
        if (m_fd >= 0)
            ::flock(m_fd, LOCK_EX | LOCK_NB);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (m_fd < 0)
            return;
        if (m_isNamed && !m_placed)
            ::unlink(m_path.c_str());
        ::close(m_fd);
    }

    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }
    [[nodiscard]] bool isNamed() const { return m_isNamed; }

    /** Writes and flushes to the disk; false leaves the reason in errno. */
    [[nodiscard]] bool fill(std::string_view content) const
    {
        if (!writeAll(m_fd, content) || ::fsync(m_fd) != 0)
            return false;
        const int copy = ::dup(m_fd); // some file systems tell only when a file is closed
        return copy >= 0 && ::close(copy) == 0;
    }

    void copyAttributes(const struct stat& from) const
    {
        // Only root may give files away; for everyone else the file simply stays their own.
        // Ownership comes first, because changing it clears the set-id bits.
        [[maybe_unused]] const int owner = ::fchown(m_fd, from.st_uid, from.st_gid);
        [[maybe_unused]] const int mode = ::fchmod(m_fd, from.st_mode & 07777U);
    }

    /** False when the folder refuses; without a name, also where there is no /proc. */
    [[nodiscard]] bool place()
    {
        if (!m_isNamed) {
            const std::string self = "/proc/self/fd/" + std::to_string(m_fd);
            m_isNamed = takeName([&](const char* path) {
                return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path, AT_SYMLINK_FOLLOW) == 0;
            });
        }
        m_placed = m_isNamed && ::rename(m_path.c_str(), m_target.c_str()) == 0;
        return m_placed;
    }

private:
    /** The first free name that `make` can use. */
    template <class Make>
    bool takeName(const Make& make)
    {
        constexpr int kMostTries = 1000;
        const std::string stem = temporaryStem(m_target) + std::to_string(::getpid()) + "-";
        for (int i = 0; i < kMostTries; ++i) {
            m_path = m_target.parent_path() / (stem + std::to_string(i)).append(kTemporaryEnding);
            if (make(m_path.c_str()))
                return true;
            if (errno != EEXIST)
                return false;
        }
        return false;
    }

    std::filesystem::path m_target;
    std::filesystem::path m_path;
    int m_fd = -1;
    bool m_isNamed = false;
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

/** Makes the rename last through a power cut; file systems that cannot do it are left alone. */
void flushFolder(const std::filesystem::path& target)
{
    const Descriptor fd(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.isOpen())
        ::fsync(fd.get());
}

} // namespace

std::string readFile(const std::string& path)
{
    // What is open already (/dev/stdin) may be a pipe; any other pipe could keep us for ever.
    const bool isGiven = isOpenDescriptor(path);
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (isGiven ? 0 : O_NONBLOCK)));
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
    if (!S_ISREG(status.st_mode) && (!isGiven || S_ISDIR(status.st_mode)))
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

namespace {

/** What a path to be written to leads to; throws when nothing can be written there. */
struct Destination
{
    explicit Destination(const std::string& path)
    {
        inPlace = openDescriptor(path).has_value();
        if (inPlace)
            return;
        exists = ::stat(path.c_str(), &old) == 0;
        if (!exists && errno != ENOENT)
            failWrite(path, reason(errno));
        inPlace = exists && (S_ISCHR(old.st_mode) || S_ISFIFO(old.st_mode));
        if (exists && !inPlace && !S_ISREG(old.st_mode))
            failWrite(path, S_ISDIR(old.st_mode) ? reason(EISDIR) : "not a regular file");
        // Renaming would replace a write-protected file; whoever protected it meant it.
        if (exists && ::access(path.c_str(), W_OK) != 0)
            failWrite(path, reason(errno));
        if (!inPlace)
            target = withoutLinks(path);
    }

    bool inPlace = false; ///< a device, a pipe, an open descriptor
    bool exists = false;
    struct stat old = {};
    std::filesystem::path target; ///< at the end of all links
};

} // namespace

struct StagedFile::State
{
    State(const std::string& givenPath, std::string_view givenContent)
        : path(givenPath), content(givenContent), destination(givenPath)
    {
        if (destination.inPlace)
            return;
        temporary.emplace(destination.target);
        if (!temporary->isOpen()) {
            if (isFull(errno))
                failWrite(path, reason(errno));
            temporary.reset();
            return;
        }
        fill();
    }

    void fill()
    {
        if (destination.exists)
            temporary->copyAttributes(destination.old);
        if (!temporary->fill(content))
            failWrite(path, reason(errno));
    }

    [[nodiscard]] bool rename()
    {
        if (!temporary)
            return false;
        if (temporary->place())
            return true;
        if (temporary->isNamed())
            return false;
        temporary.emplace(destination.target, TemporaryFile::Name::Early);
        if (!temporary->isOpen())
            return false;
        fill();
        return temporary->place();
    }

    std::string path;
    std::string_view content;
    Destination destination;
    std::optional<TemporaryFile> temporary; ///< none: the folder takes none
};

StagedFile::StagedFile(const std::string& path, std::string_view content)
    : m_state(std::make_unique<State>(path, content))
{
}

StagedFile::StagedFile(StagedFile&&) noexcept = default;
StagedFile::~StagedFile() = default;

void StagedFile::place()
{
    const Destination& to = m_state->destination;
    if (to.inPlace) {
        writeInPlace(m_state->path, m_state->content);
        return;
    }
    removeLeftovers(m_state->path);
    if (!m_state->rename())
        overwrite(m_state->path, to.target, to.exists ? &to.old : nullptr, m_state->content);
}

void StagedFile::makeLast() const
{
    if (!m_state->destination.inPlace)
        flushFolder(m_state->destination.target);
}

void removeLeftovers(const std::string& path)
{
    const std::filesystem::path target = withoutLinks(path);
    const std::string stem = temporaryStem(target);
    std::error_code failure;
    for (std::filesystem::directory_iterator it(folderOf(target), failure), end;
         !failure && it != end; it.increment(failure)) {
        const std::string name = it->path().filename().string();
        const bool isOurs = name.starts_with(stem) && name.ends_with(kTemporaryEnding) &&
                            name.find_first_not_of("0123456789-", stem.size()) ==
                                name.size() - kTemporaryEnding.size();
        if (!isOurs)
            continue;
        const Descriptor left(::open(it->path().c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW));
        if (left.isOpen() && ::flock(left.get(), LOCK_EX | LOCK_NB) == 0)
            ::unlink(it->path().c_str());
    }
}

void writeFileAtomically(const std::string& path, std::string_view content)
{
    StagedFile file(path, content);
    file.place();
    file.makeLast();
}

void checkWritable(const std::string& path)
{
    const Destination to(path);
    if (to.inPlace || TemporaryFile(to.target).isOpen() || to.exists)
        return;
    const Descriptor probe(
        ::open(to.target.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!probe.isOpen())
        failWrite(path, reason(errno));
    ::unlink(to.target.c_str());
}

bool isOpenDescriptor(std::string_view path)
{
    return openDescriptor(path).has_value();
}

} // namespace berg
