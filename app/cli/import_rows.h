#pragma once

#include "core/io/import/fields/import_table.h"

#include <string>

namespace berg::cli {

/** Longest list of rows on stderr. */
inline constexpr std::size_t kMostListedRows = 100;

/** Returns the names of all sources of positions, with commas. */
[[nodiscard]] std::string sourceNames();

/** Returns "line 3" in the language of the command line. */
[[nodiscard]] std::string saidPlace(const Rejections& rejected, std::size_t number);

/** Writes rows with their reasons to stderr; of a long list only its start. */
void printRows(const std::string& file, const Rejections& rows);

} // namespace berg::cli
