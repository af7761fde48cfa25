#include "core/io/text/zip_file.h"

#include "core/base/error.h"

#include <algorithm>
#include <cctype>
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

std::string allOf(const Source& source)
{
    zip_stat_t found;
    zip_stat_init(&found);
    require(zip_source_stat(source.get(), &found) == 0 && zip_source_open(source.get()) == 0,
            "libzip lost what it wrote");
    std::string bytes(found.size, '\0');
    const zip_int64_t got = zip_source_read(source.get(), bytes.data(), bytes.size());
    zip_source_close(source.get());
    require(got == static_cast<zip_int64_t>(bytes.size()), "libzip lost what it wrote");
    return bytes;
}

} // namespace

std::string zipFile(std::string_view entryName, std::string_view content)
{
    const Source file = sourceOf(std::string_view());
    Archive archive = archiveOf(file, ZIP_CREATE | ZIP_TRUNCATE);
    require(archive != nullptr, "libzip makes no archive");
    zip_source_t* const entry = zip_source_buffer(archive.get(), content.data(), content.size(), 0);
    const std::string name(entryName);
    const zip_int64_t at = zip_file_add(archive.get(), name.c_str(), entry, ZIP_FL_ENC_UTF_8);
    constexpr unsigned kBest = 9;
    constexpr unsigned kFirstDay = (1U << 5U) | 1U; // 1980-01-01, the earliest there is
    const auto index = static_cast<zip_uint64_t>(at);
    require(entry != nullptr && at >= 0 &&
                zip_set_file_compression(archive.get(), index, ZIP_CM_DEFLATE, kBest) == 0 &&
                zip_file_set_dostime(archive.get(), index, 0, kFirstDay, 0) == 0 &&
                zip_close(archive.get()) == 0,
            "libzip does not write");
    static_cast<void>(archive.release()); // closed
    return allOf(file);
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
