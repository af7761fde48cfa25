#pragma once

#include "core/io/text/atomic_file.h"

#include <deque>
#include <span>
#include <string>
#include <string_view>

namespace berg {

/** A file with its future content. */
struct NewFile
{
    std::string path;
    std::string content;
};

/**
 * Set of files that are written all or not at all, e.g. those of several UAVs or of one flight. All
 * are on the disk before the first is renamed to its target.
 */
class FileSet
{
public:
    /**
     * Adds a file with this content, which must live until `write`, and stages it on the disk.
     * Throws `Error{FileUnwritable}`.
     */
    void add(const std::string& path, std::string_view content);
    /**
     * Adds a file whose content follows through `StagedFile::append`; the reference stays valid
     * until `write`. Throws `Error{FileUnwritable}`.
     */
    [[nodiscard]] StagedFile& add(const std::string& path);

    /**
     * Renames all files to their targets; call it once. Throws `Error` like `writeFileAtomically`
     * and, if an existing file cannot be read for a later restore, FileUnreadable. Every file is
     * then as it was before, except devices and pipes, which come last. A killed program leaves all
     * or none as well, except where a folder takes no temporary files. If the computer itself stops
     * in the milliseconds of the renames, some files may be new and others old, each of them whole.
     */
    void write();

private:
    struct Entry
    {
        std::string path;
        StagedFile staged;
    };
    std::deque<Entry> m_entries; ///< a deque, because `add` returns references to its elements
};

/** Writes these files, all or none; throws as `FileSet::write`. */
void writeFileSet(std::span<const NewFile> files);

} // namespace berg
