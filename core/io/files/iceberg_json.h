#pragma once

#include "core/scenario/scenario.h"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>

namespace berg {

/** Largest text that `icebergsFromJson` reads: a thousand icebergs take a twentieth of it. */
inline constexpr std::size_t kLargestIcebergText = 4U << 20U;

/** Icebergs by themselves, as they go by way of the clipboard: entries as in a scenario file. */
[[nodiscard]] std::string icebergsToJson(std::span<const Iceberg> icebergs);

/**
 * The icebergs of such a text, at most `kMostIcebergs`; each could stand in a scenario. Their ids
 * are those of the text: they may be empty or equal. `subject` names the text in errors. Throws
 * `Error`: FileTooLarge, SyntaxError, WrongFormat, UnsupportedVersion, InvalidInput with every
 * fault found. `Stopped` when asked to stop.
 */
[[nodiscard]] std::vector<Iceberg> icebergsFromJson(std::string_view text,
                                                    const std::string& subject,
                                                    const std::stop_token& stop = {});

} // namespace berg
