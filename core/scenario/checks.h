#pragma once

#include <string>
#include <string_view>

namespace berg {

/** Allowed values of a number. */
struct Limits
{
    double low = 0;
    double high = 0;
    bool above = false; ///< `low` itself is not allowed
};

/** What is wrong with a number, as the end of a sentence ("must be ..."); empty when in limits. */
[[nodiscard]] std::string limitsFault(double value, const Limits& limits);

/** Shortest text that reads back as `value`, in the C locale; for messages. */
[[nodiscard]] std::string shortText(double value);

/** Path of an entry: "icebergs[3]". */
[[nodiscard]] std::string entryPath(const std::string& list, std::size_t i);

/** A name from a file fit for a message: at most 40 bytes and no control characters. */
[[nodiscard]] std::string printable(std::string_view text);

/** True for `YYYY-MM-DDThh:mm[:ss[.fraction]]Z` with a day the Gregorian calendar has. */
[[nodiscard]] bool isUtcTime(std::string_view text);

/** True when the bytes are well-formed UTF-8 (no overlong form, no surrogate). */
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace berg
