#pragma once

// Private to core/io: values of the lines of OpenAir files.

#include "core/earth/geodesy.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A line without comment, with plain blanks, and capitals in its tag. */
struct OpenAirLine
{
    std::string tag;   ///< "AC", "DP", "V"; empty for comments and blank lines
    std::string value; ///< without surrounding blanks
};

/**
 * Splits a line of UTF-8. The blank behind the tag may be missing if a number, a known height or a
 * sign follows: "DP47:00N 048:00W", "AHFL65", "VX=". A comment begins at `*` at the start of the
 * line or behind a blank, and at `#`, `;` and `//` at the start.
 */
[[nodiscard]] OpenAirLine openAirLine(std::string_view line);

/**
 * Reads a text that consists of a place only: degrees, degrees and minutes, or those and seconds,
 * separated by colons or the usual signs, with letters of the hemisphere. The last number may have
 * decimals behind a point or a comma; minutes and seconds of 60 are carried. Returns nullopt
 * otherwise.
 */
[[nodiscard]] std::optional<LatLon> openAirPlace(std::string_view text);

/** Reads two places separated by a comma, or returns nullopt. */
[[nodiscard]] std::optional<std::pair<LatLon, LatLon>> openAirPlaces(std::string_view text);

/**
 * Reads a radius, in nautical miles unless its unit is km or m, and returns metres; decimals may
 * follow a comma. Returns nullopt unless it is above 0 and at most 2000 km.
 */
[[nodiscard]] std::optional<double> openAirRadius_m(std::string_view text);

/** A radius in metres and two bearings. */
struct OpenAirAngles
{
    double radius_m = 0;
    double from_deg = 0;
    double to_deg = 0;
};
/**
 * Reads a radius and two bearings. Returns nullopt if commas could be separators as well as decimal
 * commas.
 */
[[nodiscard]] std::optional<OpenAirAngles> openAirAngles(std::string_view text);

} // namespace berg
