#pragma once

#include "core/io/text/read_budget.h"
#include "core/io/text/text_sink.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Writes a zip archive to `put` with one entry of any length, whose content `write` supplies. It
 * holds no time, so that equal contents give equal bytes. Throws as `FileBackedBuffer`; exceptions
 * of `write` and `put` pass through.
 */
void writeZip(const std::string& entryName, const std::function<void(const TextSink&)>& write,
              const TextSink& put);

/** A file of an archive. */
struct ZipEntry
{
    std::string name;
    std::string content;
};

/** Returns a zip archive of the entries, which holds no times. Throws as `FileBackedBuffer`. */
[[nodiscard]] std::string zipOf(const std::vector<ZipEntry>& entries);

/** Returns true if the bytes begin as a zip archive. */
[[nodiscard]] inline bool isZip(std::string_view bytes)
{
    return bytes.starts_with("PK\x03\x04");
}

/** Reader of a zip archive in memory; the bytes and the budget must outlive it. */
class ZipReader
{
public:
    /** Throws `Error` WrongFormat if the archive cannot be read. */
    ZipReader(std::string_view bytes, ReadBudget& budget);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    /**
     * Returns the names that end with `ending`, ignoring case, in the order of the archive, except
     * that a `doc.kml` of the top folder comes first, where programs look for the main document.
     * Files that macOS adds (`__MACOSX`, `._doc.kml`) are left out.
     */
    [[nodiscard]] std::vector<std::string> names(std::string_view ending) const;
    /**
     * Returns the text of the entry with this name and charges the budget for it. Throws `Error`
     * WrongFormat if it cannot be unpacked, and whatever the budget throws.
     */
    [[nodiscard]] std::string text(const std::string& name) const;

private:
    struct Opened;

    ReadBudget& m_budget;
    std::unique_ptr<Opened> m_opened;
};

/**
 * Returns the text of the first entry of `ZipReader::names(ending)`. Throws `Error` WrongFormat if
 * there is none, and as `ZipReader`.
 */
[[nodiscard]] std::string unzipped(std::string_view bytes, std::string_view ending,
                                   ReadBudget& budget);

} // namespace berg
