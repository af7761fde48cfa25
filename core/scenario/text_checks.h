#pragma once

#include "core/base/issue.h"
#include "core/scenario/limits.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Returns why a number is outside the limits, or nullopt if it is within them. */
[[nodiscard]] std::optional<IssueReason> outOfLimits(double value, const Limits& limits);

/** Returns the path of a list entry, such as "icebergs[3]". */
[[nodiscard]] std::string entryPath(const std::string& list, std::size_t i);

/**
 * Returns a name from a file in a form fit for a message: its first 40 bytes at most, followed by
 * "..." if it was longer, with "?" in place of each control character.
 */
[[nodiscard]] std::string printable(std::string_view text);

/**
 * Returns true for `YYYY-MM-DDThh:mm[:ss[.fraction]]Z` with a date of the Gregorian calendar and a
 * fraction of at most nine digits.
 */
[[nodiscard]] bool isUtcTime(std::string_view text);

/**
 * Returns the instant of a text for which `isUtcTime` holds, its fraction cut to milliseconds, or
 * nullopt for any other text.
 */
[[nodiscard]] std::optional<std::chrono::sys_time<std::chrono::milliseconds>>
utcTimeOf(std::string_view text);
/** Returns the seconds since 1970, without a fraction, of a text accepted by `isUtcTime`. */
[[nodiscard]] double utcSeconds(std::string_view text);

/** Returns true if the bytes are well-formed UTF-8 (no overlong form, no surrogate). */
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace berg
