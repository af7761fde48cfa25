#pragma once

#include "core/io/text/atomic_file.h"

#include <deque>
#include <span>
#include <string>
#include <string_view>

namespace berg {

/** A file as it is to become. */
struct NewFile
{
    std::string path;
    std::string content;
};

/**
 * Files of which all are written or none: those of several UAVs, or of one flight, belong together.
 * All are on the disk before the first takes its place.
 */
class FileSet
{
public:
    /** A file of this content, which must live until `write`. */
    void add(const std::string& path, std::string_view content);
    /** One whose content is yet to come, by `StagedFile::append`. */
    [[nodiscard]] StagedFile& add(const std::string& path);

    /**
     * Puts all in their places, once. Throws `Error` as `writeFileAtomically` and, of a file that
     * is there already and cannot be put back, as `readFile`; then every file is as it was before,
     * but for devices and pipes, which come last. A program that is killed leaves all or none as
     * well, but where a folder takes no temporary files; when the computer itself stops in the
     * milliseconds of the renamings, some files may be the new and others the old, each of them
     * whole.
     */
    void write();

private:
    struct Entry
    {
        std::string path;
        StagedFile staged;
    };
    std::deque<Entry> m_entries; ///< which stay where they are: `add` tells
};

/** The set of these files, written. */
void writeFileSet(std::span<const NewFile> files);

} // namespace berg
