#include "core/io/text/file_set.h"

#include "core/base/error.h"
#include "core/io/file_descriptor.h"

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <vector>

namespace berg {

namespace {

/** Whether a failed write can be undone, which it cannot for a pipe or a device. */
bool canBePutBack(const std::string& path)
{
    std::error_code none;
    return !isOpenDescriptor(path) &&
           (!std::filesystem::exists(path, none) || std::filesystem::is_regular_file(path, none));
}

/**
 * Previous state of a file, to restore it. The file stays open: if a new one takes its place, the
 * old one can still be read. A file that may be overwritten in place is copied to memory first.
 */
class Before
{
public:
    explicit Before(const std::string& path)
        : m_path(path)
        , m_isKept(canBePutBack(path))
        , m_file(m_isKept ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK) : -1)
    {
        if (m_isKept && !m_file.isOpen() && errno != ENOENT)
            fail();
        struct stat found = {};
        m_isThere = m_file.isOpen() && ::fstat(m_file.get(), &found) == 0 && S_ISREG(found.st_mode);
    }

    void copy()
    {
        if (m_isThere)
            readPieces([&](std::string_view piece) { m_copy += piece; });
        m_isCopied = true;
    }

    void putBack() const
    {
        if (!m_isKept)
            return;
        std::error_code ignored; // the first fault is the one to report
        if (!m_isThere) {
            if (std::filesystem::is_regular_file(m_path, ignored))
                std::filesystem::remove(m_path, ignored);
            return;
        }
        try {
            StagedFile file(m_path);
            if (m_isCopied)
                file.append(m_copy);
            else
                readPieces([&](std::string_view piece) { file.append(piece); });
            file.complete();
            file.place();
        } catch (const Error&) {
        }
    }

private:
    [[noreturn]] void fail() const
    {
        throw Error(ErrorCode::FileUnreadable, m_path,
                    {IssueId::CannotRead, {std::generic_category().message(errno)}});
    }

    template <class Take>
    void readPieces(const Take& take) const
    {
        std::array<char, 1U << 16U> piece{};
        for (off_t at = 0;;) {
            const ssize_t got = ::pread(m_file.get(), piece.data(), piece.size(), at);
            if (got < 0 && errno == EINTR)
                continue;
            if (got < 0)
                fail();
            if (got == 0)
                return;
            take(std::string_view(piece.data(), static_cast<std::size_t>(got)));
            at += got;
        }
    }

    std::string m_path;
    bool m_isKept;
    Descriptor m_file;
    bool m_isThere = false;
    bool m_isCopied = false;
    std::string m_copy;
};

} // namespace

void FileSet::add(const std::string& path, std::string_view content)
{
    m_entries.push_back({path, StagedFile(path, content)});
}

StagedFile& FileSet::add(const std::string& path)
{
    m_entries.push_back({path, StagedFile(path)});
    return m_entries.back().staged;
}

void FileSet::write()
{
    std::vector<Entry*> entries;
    for (Entry& entry : m_entries)
        entries.push_back(&entry);
    std::stable_partition(entries.begin(), entries.end(),
                          [](const Entry* entry) { return canBePutBack(entry->path); });
    std::vector<StagedFile> staged;
    std::deque<Before> before;
    for (Entry* entry : entries) {
        entry->staged.complete();
        staged.push_back(std::move(entry->staged));
        if (entries.size() > 1)
            before.emplace_back(entry->path);
    }
    std::size_t placed = 0;
    try {
        if (staged.size() > 1)
            placed = StagedFile::placeTogether(staged);
        for (; placed < staged.size(); ++placed) {
            if (!before.empty())
                before[placed].copy();
            staged[placed].place();
        }
    } catch (...) {
        for (std::size_t i = 0; i < placed; ++i)
            before[i].putBack();
        throw;
    }
    for (const StagedFile& file : staged)
        file.makeDurable();
}

void writeFileSet(std::span<const NewFile> files)
{
    FileSet set;
    for (const NewFile& file : files)
        set.add(file.path, file.content);
    set.write();
}

} // namespace berg
