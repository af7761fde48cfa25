#include "core/io/text/atomic_file.h"

#include "core/base/error.h"
#include "core/base/stopped.h"
#include "core/io/file_descriptor.h"
#include "core/io/temporary_file.h"
#include "core/io/text/read_budget.h"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace berg {

namespace {

std::string reason(int errorNumber)
{
    return std::generic_category().message(errorNumber);
}

[[noreturn]] void failWrite(const std::string& path, const std::string& why)
{
    throw Error(ErrorCode::FileUnwritable, path, {IssueId::CannotWrite, {why}});
}

/**
 * Returns the descriptor that is open under a name such as /dev/stdout, or nullopt for other paths.
 */
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

/** Future content of a file: a text of the caller, or a file that is on the disk already. */
struct Content
{
    std::string_view text;
    std::optional<int> descriptor; ///< holds the content from its start, instead of `text`

    /** Returns false on failure, with the reason in errno. */
    [[nodiscard]] bool copyTo(int fd) const
    {
        return descriptor ? copyAll(*descriptor, fd) : writeAll(fd, text);
    }
    [[nodiscard]] off_t size() const
    {
        struct stat found = {};
        if (!descriptor)
            return static_cast<off_t>(text.size());
        return ::fstat(*descriptor, &found) == 0 ? found.st_size : 0;
    }
};

/** Devices and pipes cannot be replaced, only written to. */
void writeInPlace(const std::string& path, const Content& content)
{
    if (const std::optional<int> fd = openDescriptor(path)) {
        if (!content.copyTo(*fd))
            failWrite(path, reason(errno));
        return;
    }
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.isOpen() || !content.copyTo(file.get()) || !file.close())
        failWrite(path, reason(errno));
}

/** Returns the file at the end of all symbolic links, also if it does not exist yet. */
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

/** Whether the disk is full: a retry in place would then only spoil the old content. */
[[nodiscard]] bool isFull(int errorNumber)
{
    return errorNumber == ENOSPC || errorNumber == EDQUOT || errorNumber == EFBIG;
}

/**
 * Writes into the file itself. `old` is its present state, or null if it does not exist yet. The
 * disk space is reserved before the first byte is written, so that a full disk keeps the old
 * content.
 */
void overwrite(const std::string& path, const std::filesystem::path& target, const struct stat* old,
               const Content& content)
{
    const int create = old == nullptr ? O_CREAT | O_EXCL : 0;
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC | create, 0666));
    if (!file.isOpen())
        failWrite(path, reason(errno));
    const off_t size = content.size();
    const int refusal = size > 0 ? ::posix_fallocate(file.get(), 0, size) : 0;
    if (isFull(refusal)) {
        [[maybe_unused]] const int undone =
            old == nullptr ? ::unlink(target.c_str()) : ::ftruncate(file.get(), old->st_size);
        failWrite(path, reason(refusal));
    }
    if (!content.copyTo(file.get()) || ::ftruncate(file.get(), size) != 0 ||
        ::fsync(file.get()) != 0 || !file.close())
        failWrite(path, reason(errno));
}

/** Makes the rename survive a power cut; file systems that cannot do it are left alone. */
void flushFolder(const std::filesystem::path& target)
{
    const Descriptor fd(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.isOpen())
        ::fsync(fd.get());
}

/** Resolved target of a path to write to; throws if nothing can be written there. */
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
        // A rename would replace a write-protected file against the intention of its owner.
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

/** Opens a file as `readFile` does, with its errors. */
Descriptor openForReading(const std::string& path)
{
    // An open descriptor (/dev/stdin) may be a pipe; opening any other pipe could block for ever.
    const bool isGiven = isOpenDescriptor(path);
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (isGiven ? 0 : O_NONBLOCK)));
    if (!file.isOpen()) {
        const bool missing = errno == ENOENT || errno == ENOTDIR;
        throw Error(missing ? ErrorCode::FileNotFound : ErrorCode::FileUnreadable, path,
                    {IssueId::CannotOpen, {reason(errno)}});
    }
    struct stat status
    {
    };
    if (::fstat(file.get(), &status) != 0)
        throw Error(ErrorCode::FileUnreadable, path, {IssueId::CannotRead, {reason(errno)}});
    if (!S_ISREG(status.st_mode) && (!isGiven || S_ISDIR(status.st_mode)))
        throw Error(ErrorCode::FileUnreadable, path, {IssueId::NotRegular});
    return file;
}

/** Reads up to `room` bytes; returns 0 at the end. */
std::size_t readSome(const Descriptor& file, char* bytes, std::size_t room, const std::string& path)
{
    while (true) {
        const ssize_t got = ::read(file.get(), bytes, room);
        if (got >= 0)
            return static_cast<std::size_t>(got);
        if (errno != EINTR)
            throw Error(ErrorCode::FileUnreadable, path, {IssueId::CannotRead, {reason(errno)}});
    }
}

} // namespace

std::string readFile(const std::string& path, const std::stop_token& stop)
{
    const Descriptor file = openForReading(path);
    // The size is counted and not taken from the status, because a file may grow while it is read.
    constexpr std::size_t kChunk = std::size_t{1} << 20U;
    std::string content;
    std::size_t size = 0;
    const std::size_t most = readLimit(kLargestFile);
    while (size <= most) {
        throwIfStopped(stop);
        content.resize(size + kChunk);
        const std::size_t got = readSome(file, content.data() + size, kChunk, path);
        size += got;
        if (got == 0) {
            content.resize(size);
            return content;
        }
    }
    failTooLarge(path, IssueId::FileTooLarge, most >> 20U);
}

std::size_t readPieces(const std::string& path, std::size_t most,
                       const std::function<void(std::string_view)>& use,
                       const std::stop_token& stop)
{
    const Descriptor file = openForReading(path);
    std::string piece(std::size_t{1} << 16U, '\0');
    std::size_t size = 0;
    while (const std::size_t got = readSome(file, piece.data(), piece.size(), path)) {
        throwIfStopped(stop);
        size += got;
        if (size > readLimit(most))
            failTooLarge(path, IssueId::FileTooLarge, readLimit(most) >> 20U);
        use(std::string_view(piece).substr(0, got));
    }
    return size;
}

struct StagedFile::State
{
    explicit State(const std::string& givenPath) : path(givenPath), destination(givenPath)
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
        if (destination.exists)
            temporary->copyAttributes(destination.old);
    }

    /**
     * Descriptor to write pieces to: the temporary file, or an anonymous one where the folder takes
     * none.
     */
    int descriptor()
    {
        if (temporary)
            return temporary->descriptor();
        if (!elsewhere) {
            std::FILE* const file = std::tmpfile();
            elsewhere.emplace(file ? ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                                   : -1);
            if (file != nullptr)
                std::fclose(file);
        }
        return elsewhere->get();
    }

    void write(std::string_view piece)
    {
        if (failure == 0 && !writeAll(descriptor(), piece))
            failure = errno;
    }

    void writeBuffer()
    {
        write(buffer);
        buffer.clear();
    }

    void complete()
    {
        if (std::exchange(isComplete, true))
            return;
        if (inPieces)
            writeBuffer();
        else if (temporary)
            write(content.text);
        if (failure == 0 && temporary && !temporary->flush())
            failure = errno;
        if (failure != 0)
            failWrite(path, reason(failure));
        if (inPieces)
            content.descriptor = descriptor();
    }

    /**
     * Tries again with a temporary file that has its name from the start, where the late name is
     * refused.
     */
    [[nodiscard]] bool renameNamed()
    {
        TemporaryFile named(destination.target, TemporaryFile::Name::Early);
        if (!named.isOpen())
            return false;
        if (destination.exists)
            named.copyAttributes(destination.old);
        if (!copyAll(temporary->descriptor(), named.descriptor()) || !named.flush())
            failWrite(path, reason(errno));
        return named.place();
    }

    [[nodiscard]] bool rename()
    {
        return temporary && (temporary->place() || (!temporary->isNamed() && renameNamed()));
    }

    std::string path;
    Content content;
    bool inPieces = false;
    std::string buffer; ///< pieces not yet written
    int failure = 0;    ///< errno of the first failure, or 0
    bool isComplete = false;
    Destination destination;
    std::optional<TemporaryFile> temporary; ///< nullopt if the folder takes no temporary file
    std::optional<Descriptor> elsewhere;    ///< holds the pieces if there is no temporary file
};

StagedFile::StagedFile(const std::string& path) : m_state(std::make_unique<State>(path))
{
    m_state->inPieces = true;
}

StagedFile::StagedFile(const std::string& path, std::string_view content)
    : m_state(std::make_unique<State>(path))
{
    m_state->content.text = content;
    complete();
}

StagedFile::StagedFile(StagedFile&&) noexcept = default;
StagedFile::~StagedFile() = default;

void StagedFile::append(std::string_view text)
{
    constexpr std::size_t kBuffer = 1U << 16U;
    m_state->buffer += text;
    if (m_state->buffer.size() >= kBuffer)
        m_state->writeBuffer();
}

void StagedFile::complete()
{
    m_state->complete();
}

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

std::size_t StagedFile::placeTogether(std::span<StagedFile> files)
{
    std::vector<Placing> placings;
    std::set<std::filesystem::path> folders;
    for (const StagedFile& file : files) {
        if (!file.m_state->temporary)
            break;
        placings.push_back(file.m_state->temporary->placing());
        folders.insert(folderOf(file.m_state->destination.target));
    }
    for (const std::filesystem::path& folder : folders)
        removeLeftTemporaries(folder);
    const std::size_t placed = placeInChildProcess(placings);
    for (std::size_t i = 0; i < placed; ++i)
        files[i].m_state->temporary->notePlaced();
    return placed;
}

void StagedFile::makeDurable() const
{
    if (!m_state->destination.inPlace)
        flushFolder(m_state->destination.target);
}

void removeLeftovers(const std::string& path)
{
    removeLeftTemporaries(folderOf(withoutLinks(path)));
}

void writeFileAtomically(const std::string& path, std::string_view content)
{
    StagedFile file(path, content);
    file.place();
    file.makeDurable();
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
