#pragma once

#include "core/io/text/read_budget.h"

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
 * WrongFormat when there is none or the archive cannot be read, and what the budget of the archive
 * throws, of which the text takes.
 */
[[nodiscard]] std::string unzipped(std::string_view bytes, std::string_view ending,
                                   ReadBudget& budget);

} // namespace berg
