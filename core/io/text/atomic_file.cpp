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

/** What a file is to hold: a text of somebody else, or what was put on the disk already. */
struct Content
{
    std::string_view text;
    int descriptor = -1; ///< to be read from its start; -1: it is the text

    /** False leaves the reason in errno. */
    [[nodiscard]] bool copyTo(int fd) const
    {
        return descriptor >= 0 ? copyAll(descriptor, fd) : writeAll(fd, text);
    }
    [[nodiscard]] off_t size() const
    {
        struct stat found = {};
        if (descriptor < 0)
            return static_cast<off_t>(text.size());
        return ::fstat(descriptor, &found) == 0 ? found.st_size : 0;
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

/** Makes the rename last through a power cut; file systems that cannot do it are left alone. */
void flushFolder(const std::filesystem::path& target)
{
    const Descriptor fd(::open(folderOf(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.isOpen())
        ::fsync(fd.get());
}

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

std::string readFile(const std::string& path, const std::stop_token& stop)
{
    // What is open already (/dev/stdin) may be a pipe; any other pipe could keep us for ever.
    const bool isGiven = isOpenDescriptor(path);
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | (isGiven ? 0 : O_NONBLOCK)));
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

    // The size is counted, not asked for: a file may grow while it is read.
    constexpr std::size_t kChunk = std::size_t{1} << 20U;
    std::string content;
    std::size_t size = 0;
    const std::size_t most = readLimit(kLargestFile);
    while (size <= most) {
        throwIfStopped(stop);
        content.resize(size + kChunk);
        const ssize_t got = ::read(file.get(), content.data() + size, kChunk);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            throw Error(ErrorCode::FileUnreadable, path, {IssueId::CannotRead, {reason(errno)}});
        size += static_cast<std::size_t>(got);
        if (got == 0) {
            content.resize(size);
            return content;
        }
    }
    failTooLarge(path, IssueId::FileTooLarge, most >> 20U);
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

    /** Where pieces are written to; where the folder takes no files, somewhere else. */
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

    /** The name that a temporary file got late is refused: once more with one that has its name. */
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
    std::string buffer; ///< of the pieces
    int failure = 0;    ///< errno of the first one
    bool isComplete = false;
    Destination destination;
    std::optional<TemporaryFile> temporary; ///< none: the folder takes none
    std::optional<Descriptor> elsewhere;    ///< for the pieces then
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
    const std::size_t placed = placeApart(placings);
    for (std::size_t i = 0; i < placed; ++i)
        files[i].m_state->temporary->notePlaced();
    return placed;
}

void StagedFile::makeLast() const
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
