#include "core/io/text/file_backed_buffer.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace berg {

namespace {

constexpr std::size_t kInMemory = 1U << 16U;

std::filesystem::path folder()
{
    std::error_code none;
    const std::filesystem::path found = std::filesystem::temp_directory_path(none);
    return none ? std::filesystem::path("/tmp") : found;
}

[[noreturn]] void fail()
{
    const std::string why = std::generic_category().message(errno);
    throw Error(ErrorCode::FileUnwritable, folder().string(), {IssueId::CannotWrite, {why}});
}

} // namespace

void FileBackedBuffer::append(std::string_view bytes)
{
    m_tail += bytes;
    if (m_tail.size() < kInMemory)
        return;
    writeFile(m_inFile, m_tail);
    m_inFile += m_tail.size();
    m_tail.clear();
}

void FileBackedBuffer::write(std::size_t at, std::string_view bytes)
{
    require(at <= size(), "FileBackedBuffer::write: beyond the end");
    const std::size_t early = at < m_inFile ? std::min(bytes.size(), m_inFile - at) : 0;
    writeFile(at, bytes.substr(0, early));
    bytes.remove_prefix(early);
    if (bytes.empty())
        return;
    const std::size_t from = at + early - m_inFile;
    const std::size_t over = std::min(bytes.size(), m_tail.size() - from);
    m_tail.replace(from, over, bytes.substr(0, over));
    append(bytes.substr(over));
}

void FileBackedBuffer::writeFile(std::size_t at, std::string_view bytes)
{
    if (bytes.empty())
        return;
    if (m_file == nullptr) {
        auto file = std::make_unique<TemporaryFile>(folder() / "bergwatch");
        if (!file->isOpen())
            fail();
        m_file = std::move(file);
    }
    while (!bytes.empty()) {
        const ssize_t put =
            ::pwrite(m_file->descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (put < 0 && errno == EINTR)
            continue;
        if (put < 0)
            fail();
        at += static_cast<std::size_t>(put);
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
}

std::size_t FileBackedBuffer::read(std::size_t at, std::span<char> into) const
{
    std::size_t got = 0;
    while (got < into.size() && at + got < m_inFile) {
        const ssize_t piece =
            ::pread(m_file->descriptor(), into.data() + got,
                    std::min(into.size() - got, m_inFile - at - got), static_cast<off_t>(at + got));
        if (piece < 0 && errno == EINTR)
            continue;
        if (piece == 0)
            errno = EIO; // the file is shorter than what was written
        if (piece <= 0)
            fail();
        got += static_cast<std::size_t>(piece);
    }
    if (got < into.size() && at + got < size())
        got += m_tail.copy(into.data() + got, into.size() - got, at + got - m_inFile);
    return got;
}

void FileBackedBuffer::putAll(const TextSink& put) const
{
    std::array<char, kInMemory> piece{};
    for (std::size_t at = 0; at < size();) {
        const std::size_t got = read(at, piece);
        put(std::string_view(piece.data(), got));
        at += got;
    }
}

void FileBackedBuffer::clear()
{
    m_inFile = 0; // later content overwrites the file
    m_tail.clear();
}

} // namespace berg
