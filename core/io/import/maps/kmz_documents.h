#pragma once

// Private to core/io: the documents of a KMZ archive.

#include "core/io/text/zip_file.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A document of an archive. */
struct KmzDocument
{
    std::string name;
    bool isLinked = true; ///< whether it is the main document, or linked from one that was read
};

/**
 * Iterates over the KML documents of an archive, each once: the main one, then linked ones, then
 * those without a link to them. Links out of the archive are not followed.
 */
class KmzDocuments
{
public:
    /** Throws `Error` WrongFormat if there is no document or the archive cannot be read. */
    KmzDocuments(std::string_view bytes, ReadBudget& budget);

    [[nodiscard]] std::size_t count() const { return m_names.size(); }
    /** Returns the next document, or nullopt after the last. */
    [[nodiscard]] std::optional<KmzDocument> next();
    /** Returns the text of a document in UTF-8. Throws `Error` WrongFormat if it cannot be read. */
    [[nodiscard]] std::string text(const std::string& name);
    /**
     * Gives back the memory of a text but still counts its length, so that many texts together are
     * limited like one.
     */
    void release(const std::string& text);
    /**
     * Queues the document that `link` in `document` points to, unless it was read or queued before.
     * Returns false if the archive has no such document.
     */
    bool follow(const std::string& link, const std::string& document);
    /** Returns the names of archives within the archive, which are not read. */
    [[nodiscard]] std::vector<std::string> archives() const { return m_archive.names(".kmz"); }

private:
    ReadBudget& m_budget;
    ZipReader m_archive;
    std::vector<std::string> m_names;
    std::size_t m_read = 0; ///< number of names already handled
    std::deque<std::string> m_waiting;
    std::set<std::string> m_entries; ///< all names, for fast lookup
    std::set<std::string> m_known;   ///< documents read or queued
};

} // namespace berg
