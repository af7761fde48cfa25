#pragma once

#include "core/scenario/scenario.h"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/**
 * Largest text that `icebergsFromJson` reads, bytes; a thousand icebergs take a twentieth of it.
 */
inline constexpr std::size_t kLargestIcebergText = 4U << 20U;

/**
 * Returns the text of a list of icebergs for the clipboard; the entries are those of a scenario
 * file.
 */
[[nodiscard]] std::string icebergsToJson(std::span<const Iceberg> icebergs);

/**
 * Reads icebergs from a text of `icebergsToJson`, at most `kMostIcebergs`; each is valid in a
 * scenario apart from its id, which may be empty or equal to others, and its assigned UAV, which
 * may be unknown. `subject` names the text in errors. Throws `Error`: FileTooLarge (over
 * `kLargestIcebergText`), SyntaxError, WrongFormat, UnsupportedVersion, InvalidInput with every
 * fault found; `Stopped` if a stop is requested.
 */
[[nodiscard]] std::vector<Iceberg> icebergsFromJson(std::string_view text,
                                                    const std::string& subject,
                                                    const std::stop_token& stop = {});

} // namespace berg
