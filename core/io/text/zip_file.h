#pragma once

#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** A zip archive with one entry. It holds no time, so that equal contents are equal bytes. */
[[nodiscard]] std::string zipFile(std::string_view entryName, std::string_view content);

[[nodiscard]] inline bool isZip(std::string_view bytes)
{
    return bytes.starts_with("PK\x03\x04");
}

/**
 * The first entry whose name ends with `ending`, in letters of either case. Throws `Error`
 * WrongFormat when there is none or the archive cannot be read, FileTooLarge when it would unpack
 * to more than `kLargestFile`; `Stopped` when asked to stop.
 */
[[nodiscard]] std::string unzipped(std::string_view bytes, std::string_view ending,
                                   const std::string& subject, const std::stop_token& stop = {});

} // namespace berg
