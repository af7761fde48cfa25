#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** An instant of UTC in milliseconds, without leap seconds. */
using UtcTime = std::chrono::sys_time<std::chrono::milliseconds>;

/**
 * Returns the instant of an ISO 8601 text for which `isUtcTime` holds, its fraction cut to
 * milliseconds, or nullopt for any other text.
 */
[[nodiscard]] std::optional<UtcTime> parseUtc(std::string_view text);

/**
 * Returns `start` + `after_s` seconds as ISO 8601 text, rounded to milliseconds, such as
 * "2026-05-01T12:00:07.500Z"; whole seconds have no fraction.
 */
[[nodiscard]] std::string utcText(UtcTime start, double after_s);
/** Returns the minute in which `start` + `after_s` lies as text for people: "2026-05-01 12:07". */
[[nodiscard]] std::string minuteText(UtcTime start, double after_s);

} // namespace berg
