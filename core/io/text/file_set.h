#pragma once

#include <span>
#include <string>

namespace berg {

/** A file as it is to become. */
struct NewFile
{
    std::string path;
    std::string content;
};

/**
 * Writes all of the files or none: those of several UAVs, or of one flight, belong together. All
 * are on the disk before the first takes its place. Throws `Error` as `writeFileAtomically` and, of
 * a file that is there already and cannot be put back, as `readFile`; then every file is as it was
 * before, but for devices and pipes, which come last. A program that is killed leaves all or none
 * as well, but where a folder takes no temporary files; when the computer itself stops in the
 * milliseconds of the renamings, some files may be the new and others the old, each of them whole.
 */
void writeFileSet(std::span<const NewFile> files);

} // namespace berg
