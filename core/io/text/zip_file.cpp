#include "core/io/text/zip_file.h"

#include "core/base/error.h"
#include "core/io/text/file_backed_buffer.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <memory>
#include <zip.h>

namespace berg {

namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Source = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

/** Source over bytes in memory, which must outlive it. */
Source sourceOf(std::string_view bytes)
{
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr),
                  &zip_source_free);
    require(source != nullptr, "libzip has no memory");
    return source;
}

/**
 * Opens the archive of the source, which stays with the caller. Returns null if it is not an
 * archive.
 */
Archive archiveOf(const Source& source, int flags)
{
    zip_source_keep(source.get());
    Archive archive(zip_open_from_source(source.get(), flags, nullptr), &zip_discard);
    if (archive == nullptr)
        zip_source_free(source.get());
    return archive;
}

bool endsWith(std::string_view name, std::string_view ending)
{
    return name.size() >= ending.size() &&
           std::ranges::equal(
               name.substr(name.size() - ending.size()), ending,
               [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/** Whether macOS added the entry for another one: its folders and its icon. */
bool isOfMacOs(std::string_view name)
{
    const std::string_view file = name.substr(name.rfind('/') + 1); // npos + 1 is 0
    return file.starts_with("._") || name.starts_with("__MACOSX/") ||
           name.find("/__MACOSX/") != std::string_view::npos;
}

/**
 * Presents a buffer to libzip as a file. An exception of the buffer is stored in `fault` until
 * libzip returns.
 */
struct BufferFile
{
    FileBackedBuffer buffer;
    std::size_t at = 0;
    std::exception_ptr fault = {};
    zip_error_t error = {};
};

zip_int64_t seek(BufferFile& file, void* data, zip_uint64_t length)
{
    const zip_int64_t at =
        zip_source_seek_compute_offset(file.at, file.buffer.size(), data, length, &file.error);
    if (at < 0)
        return -1;
    file.at = static_cast<std::size_t>(at);
    return 0;
}

zip_int64_t transfer(BufferFile& file, void* data, std::size_t length, zip_source_cmd_t command)
try {
    char* const bytes = static_cast<char*>(data);
    if (command == ZIP_SOURCE_READ)
        length = file.buffer.read(file.at, {bytes, length});
    else
        file.buffer.write(file.at, {bytes, length});
    file.at += length;
    return static_cast<zip_int64_t>(length);
} catch (...) {
    file.fault = std::current_exception();
    zip_error_set(&file.error, command == ZIP_SOURCE_READ ? ZIP_ER_READ : ZIP_ER_WRITE, 0);
    return -1;
}

zip_int64_t serve(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command)
{
    auto& file = *static_cast<BufferFile*>(user);
    switch (command) {
    case ZIP_SOURCE_OPEN:
    case ZIP_SOURCE_BEGIN_WRITE:
        file.at = 0;
        return 0;
    case ZIP_SOURCE_READ:
    case ZIP_SOURCE_WRITE:
        return transfer(file, data, length, command);
    case ZIP_SOURCE_SEEK:
    case ZIP_SOURCE_SEEK_WRITE:
        return seek(file, data, length);
    case ZIP_SOURCE_TELL:
    case ZIP_SOURCE_TELL_WRITE:
        return static_cast<zip_int64_t>(file.at);
    case ZIP_SOURCE_STAT: {
        auto* const stat = static_cast<zip_stat_t*>(data);
        zip_stat_init(stat);
        stat->valid = ZIP_STAT_SIZE;
        stat->size = file.buffer.size();
        return sizeof *stat;
    }
    case ZIP_SOURCE_ERROR:
        return zip_error_to_data(&file.error, data, length);
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(
            ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
            ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_BEGIN_WRITE,
            ZIP_SOURCE_WRITE, ZIP_SOURCE_SEEK_WRITE, ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_COMMIT_WRITE,
            ZIP_SOURCE_ROLLBACK_WRITE, ZIP_SOURCE_REMOVE, -1);
    default:
        return 0;
    }
}

/**
 * Compresses the text, dates it to the first possible day and closes the archive. Returns false if
 * libzip or a buffer fails.
 */
bool pack(const std::string& entryName, BufferFile& text, BufferFile& packed)
{
    constexpr unsigned kBest = 9;
    constexpr unsigned kFirstDay = (1U << 5U) | 1U; // 1980-01-01, the earliest date of the format
    const Source target(zip_source_function_create(&serve, &packed, nullptr), &zip_source_free);
    require(target != nullptr, "libzip has no memory");
    Archive archive = archiveOf(target, ZIP_CREATE | ZIP_TRUNCATE);
    if (archive == nullptr)
        return false;
    Source entry(zip_source_function(archive.get(), &serve, &text), &zip_source_free);
    const zip_int64_t at = entry == nullptr ? -1
                                            : zip_file_add(archive.get(), entryName.c_str(),
                                                           entry.get(), ZIP_FL_ENC_UTF_8);
    if (at < 0)
        return false;
    static_cast<void>(entry.release()); // the archive owns it now
    const auto index = static_cast<zip_uint64_t>(at);
    if (zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, kBest) != 0 ||
        zip_file_set_dostime(archive.get(), index, 0, kFirstDay, 0) != 0 ||
        zip_close(archive.get()) != 0)
        return false;
    static_cast<void>(archive.release()); // zip_close has freed it
    return true;
}

} // namespace

void writeZip(const std::string& entryName, const std::function<void(const TextSink&)>& write,
              const TextSink& put)
{
    BufferFile text;
    BufferFile packed;
    write([&text](std::string_view piece) { text.buffer.append(piece); });
    const bool isPacked = pack(entryName, text, packed);
    for (const BufferFile* file : {&text, &packed})
        if (file->fault)
            std::rethrow_exception(file->fault);
    require(isPacked, "libzip does not write");
    packed.buffer.putAll(put);
}

struct ZipReader::Opened
{
    Source source;
    Archive archive;
};

ZipReader::ZipReader(std::string_view bytes, ReadBudget& budget) : m_budget(budget)
{
    Source source = sourceOf(bytes);
    Archive archive = archiveOf(source, ZIP_RDONLY);
    if (archive == nullptr)
        throw Error(ErrorCode::WrongFormat, budget.subject(), {IssueId::ArchiveDamaged});
    m_opened = std::make_unique<Opened>(
        Opened{.source = std::move(source), .archive = std::move(archive)});
}

ZipReader::~ZipReader() = default;

std::vector<std::string> ZipReader::names(std::string_view ending) const
{
    std::vector<std::string> found;
    zip_t* const archive = m_opened->archive.get();
    const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive, 0));
    for (zip_uint64_t i = 0; i < count; ++i) {
        m_budget.throwIfStopped();
        const char* const given = zip_get_name(archive, i, ZIP_FL_ENC_GUESS);
        const std::string name = given == nullptr ? "" : given;
        if (!endsWith(name, ending) || isOfMacOs(name))
            continue;
        m_budget.take(2 * sizeof(std::string) + name.capacity());
        found.push_back(name);
    }
    const auto main = std::ranges::find_if(found, [](const std::string& name) {
        constexpr std::string_view kMain = "doc.kml";
        return name.size() == kMain.size() && endsWith(name, kMain);
    });
    if (main != found.end())
        std::rotate(found.begin(), main, main + 1);
    return found;
}

std::string ZipReader::text(const std::string& name) const
{
    const auto fail = [&] {
        const std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
        throw Error(ErrorCode::WrongFormat, m_budget.subject(), {IssueId::ArchiveEntry, {ending}});
    };
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> entry(
        zip_fopen(m_opened->archive.get(), name.c_str(), ZIP_FL_ENC_GUESS), &zip_fclose);
    if (entry == nullptr)
        fail();
    constexpr std::size_t kPiece = 1U << 16U;
    std::string text;
    // The size in the archive may be wrong, so bytes are counted.
    for (zip_int64_t got = 1; got > 0;) {
        m_budget.throwIfStopped();
        const std::size_t size = text.size();
        if (text.capacity() < size + kPiece) { // while the text grows there are two copies
            const std::size_t capacity = text.capacity();
            m_budget.take(2 * capacity + kPiece);
            text.reserve(2 * capacity + kPiece);
            m_budget.release(capacity);
        }
        text.resize(size + kPiece);
        got = zip_fread(entry.get(), text.data() + size, kPiece);
        if (got < 0)
            fail();
        text.resize(size + static_cast<std::size_t>(got));
    }
    return text;
}

std::string unzipped(std::string_view bytes, std::string_view ending, ReadBudget& budget)
{
    const ZipReader archive(bytes, budget);
    const std::vector<std::string> names = archive.names(ending);
    if (names.empty())
        throw Error(ErrorCode::WrongFormat, budget.subject(),
                    {IssueId::ArchiveWithout, {std::string(ending)}});
    return archive.text(names.front());
}

} // namespace berg
