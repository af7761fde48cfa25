#include "core/io/text/zip_file.h"

#include "core/base/error.h"
#include "core/io/text/spool.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <memory>
#include <zip.h>

namespace berg {

namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Source = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

/** In memory; `bytes` must live as long. */
Source sourceOf(std::string_view bytes)
{
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr),
                  &zip_source_free);
    require(source != nullptr, "libzip has no memory");
    return source;
}

/** Of the source, which the caller keeps; null: it is none. */
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

/** A spool as libzip reads and writes files; what the spool throws is kept for after it. */
struct SpoolFile
{
    Spool spool;
    std::size_t at = 0;
    std::exception_ptr fault = {};
    zip_error_t error = {};
};

zip_int64_t seek(SpoolFile& file, void* data, zip_uint64_t length)
{
    const zip_int64_t at =
        zip_source_seek_compute_offset(file.at, file.spool.size(), data, length, &file.error);
    if (at < 0)
        return -1;
    file.at = static_cast<std::size_t>(at);
    return 0;
}

zip_int64_t transfer(SpoolFile& file, void* data, std::size_t length, zip_source_cmd_t command)
try {
    char* const bytes = static_cast<char*>(data);
    if (command == ZIP_SOURCE_READ)
        length = file.spool.read(file.at, {bytes, length});
    else
        file.spool.write(file.at, {bytes, length});
    file.at += length;
    return static_cast<zip_int64_t>(length);
} catch (...) {
    file.fault = std::current_exception();
    zip_error_set(&file.error, command == ZIP_SOURCE_READ ? ZIP_ER_READ : ZIP_ER_WRITE, 0);
    return -1;
}

zip_int64_t serve(void* user, void* data, zip_uint64_t length, zip_source_cmd_t command)
{
    auto& file = *static_cast<SpoolFile*>(user);
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
        stat->size = file.spool.size();
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

/** Deflated, on the first day there is, closed. False where libzip or one of the two refuses. */
bool pack(const std::string& entryName, SpoolFile& text, SpoolFile& packed)
{
    constexpr unsigned kBest = 9;
    constexpr unsigned kFirstDay = (1U << 5U) | 1U; // 1980-01-01, the earliest there is
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
    static_cast<void>(entry.release()); // it is the archive's
    const auto index = static_cast<zip_uint64_t>(at);
    if (zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, kBest) != 0 ||
        zip_file_set_dostime(archive.get(), index, 0, kFirstDay, 0) != 0 ||
        zip_close(archive.get()) != 0)
        return false;
    static_cast<void>(archive.release()); // closed
    return true;
}

} // namespace

void writeZip(const std::string& entryName, const std::function<void(const TextSink&)>& write,
              const TextSink& put)
{
    SpoolFile text;
    SpoolFile packed;
    write([&text](std::string_view piece) { text.spool.append(piece); });
    const bool isPacked = pack(entryName, text, packed);
    for (const SpoolFile* file : {&text, &packed})
        if (file->fault)
            std::rethrow_exception(file->fault);
    require(isPacked, "libzip does not write");
    packed.spool.putAll(put);
}

std::string unzipped(std::string_view bytes, std::string_view ending, ReadBudget& budget)
{
    const auto fail = [&](IssueReason reason) {
        throw Error(ErrorCode::WrongFormat, budget.subject(), std::move(reason));
    };
    const Source file = sourceOf(bytes);
    const Archive archive = archiveOf(file, ZIP_RDONLY);
    if (archive == nullptr)
        fail({IssueId::ArchiveDamaged});
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    zip_int64_t index = 0;
    const auto nameOf = [&] {
        const char* const name =
            zip_get_name(archive.get(), static_cast<zip_uint64_t>(index), ZIP_FL_ENC_GUESS);
        return std::string_view(name == nullptr ? "" : name);
    };
    while (index < count && !endsWith(nameOf(), ending))
        ++index;
    if (index >= count)
        fail({IssueId::ArchiveWithout, {std::string(ending)}});
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> entry(
        zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(index), 0), &zip_fclose);
    constexpr std::size_t kPiece = 1U << 16U;
    std::string text;
    // What the archive says of the size may be a lie, so it is counted.
    for (zip_int64_t got = 1; got > 0;) {
        budget.goOn();
        const std::size_t size = text.size();
        if (text.capacity() < size + kPiece) { // while it grows there are two of it
            const std::size_t capacity = text.capacity();
            budget.take(2 * capacity + kPiece);
            text.reserve(2 * capacity + kPiece);
            budget.giveBack(capacity);
        }
        text.resize(size + kPiece);
        got = entry == nullptr ? -1 : zip_fread(entry.get(), text.data() + size, kPiece);
        if (got < 0)
            fail({IssueId::ArchiveEntry, {std::string(ending)}});
        text.resize(size + static_cast<std::size_t>(got));
    }
    return text;
}

} // namespace berg
