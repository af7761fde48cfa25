#pragma once

#include "core/base/issue.h"
#include "core/scenario/limits.h"

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** What is wrong with a number; none when it is in limits. */
[[nodiscard]] std::optional<IssueReason> outOfLimits(double value, const Limits& limits);

/** Path of an entry: "icebergs[3]". */
[[nodiscard]] std::string entryPath(const std::string& list, std::size_t i);

/** A name from a file fit for a message: at most 40 bytes and no control characters. */
[[nodiscard]] std::string printable(std::string_view text);

/** True for `YYYY-MM-DDThh:mm[:ss[.fraction]]Z` with a day the Gregorian calendar has. */
[[nodiscard]] bool isUtcTime(std::string_view text);

/** True when the bytes are well-formed UTF-8 (no overlong form, no surrogate). */
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace berg
