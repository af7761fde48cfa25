#pragma once

// Private to core/link: the fields of NMEA 0183 sentences.

#include "core/base/knots.h"
#include "core/earth/geodesy.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace berg {

/** Returns the XOR of the bytes between `$` or `!` and `*`. */
[[nodiscard]] std::uint8_t nmeaChecksum(std::string_view content);

/** Returns true if the line ends with `*` and the checksum of `content` in hexadecimal digits. */
[[nodiscard]] bool hasNmeaChecksum(std::string_view line, std::string_view content);

/** Returns the texts between commas; they refer to `content`. */
[[nodiscard]] std::vector<std::string_view> nmeaFields(std::string_view content);

/** Returns a decimal number in [low, high], or nullopt for any other text. */
[[nodiscard]] std::optional<double> nmeaNumber(std::string_view text, double low, double high);

/** Returns the place of "ddmm.mmm", "N", "dddmm.mmm", "E", or nullopt for anything else. */
[[nodiscard]] std::optional<LatLon> nmeaPlace(std::span<const std::string_view> four);

/** Returns the seconds since midnight of "hhmmss" or "hhmmss.ss", or nullopt for anything else. */
[[nodiscard]] std::optional<double> nmeaTimeOfDay(std::string_view text);

/**
 * Returns the time on a day given as "ddmmyy" in microseconds since 1970, or nullopt if either
 * cannot be read; years 80 to 99 belong to the last century.
 */
[[nodiscard]] std::optional<std::int64_t> nmeaUnixTime(std::string_view date,
                                                       std::optional<double> timeOfDay_s);

/** Returns the speed of a text in knots. */
[[nodiscard]] std::optional<double> nmeaSpeed(std::string_view knots);

/**
 * Returns the time of the tag block in front of a sentence (`\c:1700000000*hh\`, seconds or
 * milliseconds since 1970) in microseconds; nullopt without one or with a wrong checksum.
 */
[[nodiscard]] std::optional<std::int64_t> nmeaTagTime(std::string_view before);

} // namespace berg
