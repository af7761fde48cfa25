#pragma once

#include <string>
#include <string_view>

namespace berg {

/** Largest file any reader accepts, bytes. */
inline constexpr std::size_t kLargestFile = 64U << 20U;

/**
 * Whole content of a regular file. Throws `Error` FileNotFound, FileUnreadable (directory, no
 * permission) or FileTooLarge (over `kLargestFile`), subject = path.
 */
[[nodiscard]] std::string readFile(const std::string& path);

/**
 * Writes the file so that a reader sees the old or the new content, never a part: temporary file
 * in the same folder, flushed, then renamed over the target (a symbolic link keeps pointing, the
 * file it points to is replaced; permissions of an existing file are kept). Where the folder or the
 * file system refuses the temporary file or the renaming, the file itself is written over, after
 * the room for it was reserved. Throws `Error{FileUnwritable}`; then the old content is still there
 * (unless a device failed in the middle of writing it over) and no temporary file is left.
 */
void writeFileAtomically(const std::string& path, std::string_view content);

} // namespace berg
