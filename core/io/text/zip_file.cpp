#include "core/io/text/zip_file.h"

#include "core/base/error.h"
#include "core/io/text/file_backed_buffer.h"

#include <algorithm>
#include <cctype>
#include <deque>
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

/** Text of an entry with its name. */
struct NamedText
{
    std::string name;
    BufferFile text;
};

/** Adds an entry, compressed and dated to the first possible day. Returns false on failure. */
bool add(zip_t* archive, NamedText& named)
{
    constexpr unsigned kBest = 9;
    constexpr unsigned kFirstDay = (1U << 5U) | 1U; // 1980-01-01, the earliest date of the format
    Source entry(zip_source_function(archive, &serve, &named.text), &zip_source_free);
    const zip_int64_t at =
        entry == nullptr ? -1
                         : zip_file_add(archive, named.name.c_str(), entry.get(), ZIP_FL_ENC_UTF_8);
    if (at < 0)
        return false;
    static_cast<void>(entry.release()); // the archive owns it now
    const auto index = static_cast<zip_uint64_t>(at);
    return zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, kBest) == 0 &&
           zip_file_set_dostime(archive, index, 0, kFirstDay, 0) == 0;
}

/** Adds all texts and closes the archive. Returns false if libzip or a buffer fails. */
bool pack(std::deque<NamedText>& texts, BufferFile& packed)
{
    const Source target(zip_source_function_create(&serve, &packed, nullptr), &zip_source_free);
    require(target != nullptr, "libzip has no memory");
    Archive archive = archiveOf(target, ZIP_CREATE | ZIP_TRUNCATE);
    if (archive == nullptr)
        return false;
    for (NamedText& text : texts)
        if (!add(archive.get(), text))
            return false;
    if (zip_close(archive.get()) != 0)
        return false;
    static_cast<void>(archive.release()); // zip_close has freed it
    return true;
}

void writePacked(std::deque<NamedText>& texts, const TextSink& put)
{
    BufferFile packed;
    const bool isPacked = pack(texts, packed);
    for (const NamedText& named : texts)
        if (named.text.fault)
            std::rethrow_exception(named.text.fault);
    if (packed.fault)
        std::rethrow_exception(packed.fault);
    require(isPacked, "libzip does not write");
    packed.buffer.putAll(put);
}

} // namespace

void writeZip(const std::string& entryName, const std::function<void(const TextSink&)>& write,
              const TextSink& put)
{
    std::deque<NamedText> texts;
    NamedText& named = texts.emplace_back();
    named.name = entryName;
    write([&named](std::string_view piece) { named.text.buffer.append(piece); });
    writePacked(texts, put);
}

std::string zipOf(const std::vector<ZipEntry>& entries)
{
    std::deque<NamedText> texts;
    for (const ZipEntry& entry : entries) {
        NamedText& named = texts.emplace_back();
        named.name = entry.name;
        named.text.buffer.append(entry.content);
    }
    std::string archive;
    writePacked(texts, [&archive](std::string_view piece) { archive += piece; });
    return archive;
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
