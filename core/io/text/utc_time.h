#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** An instant of UTC, without leap seconds. */
using UtcTime = std::chrono::sys_time<std::chrono::milliseconds>;

/**
 * Instant of an ISO 8601 text for which `isUtcTime` holds, its fraction cut to milliseconds; none
 * for any other text.
 */
[[nodiscard]] std::optional<UtcTime> parseUtc(std::string_view text);

/** ISO 8601 text of `start` + `after_s` seconds, e.g. "2026-05-01T12:00:07.500Z", rounded to ms. */
[[nodiscard]] std::string utcText(UtcTime start, double after_s);

} // namespace berg
