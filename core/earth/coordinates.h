#pragma once

#include "core/earth/geodesy.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace berg {

/** Notation of coordinates. */
enum class CoordinateForm : std::uint8_t
{
    DegreesMinutes, ///< 47° 03.2′ N, as at sea
    DecimalDegrees, ///< 47.0533° N
    DegreesMinutesSeconds
};

/** Reason why a text is not a position. */
enum class CoordinateFault
{
    Empty,
    Unreadable,
    Half,              ///< only one angle
    Ambiguous,         ///< more than one reading
    HemisphereMissing, ///< one angle has a letter, the other has neither letter nor sign
    SignAndLetter,     ///< sign and letter for one angle, such as "-47 N"
    SameAxis,          ///< two latitudes or two longitudes
    Sixty,             ///< minutes or seconds of 60 and more
    Latitude,          ///< latitude beyond 90 degrees
    Longitude,         ///< longitude beyond 180 degrees, or from 360 degrees on if it has no letter
    Grid               ///< resembles UTM, UPS or MGRS but is not on that grid
};

/**
 * Reads a position from a UTF-8 text. Accepted are decimal degrees, degrees and minutes, or
 * degrees, minutes and seconds, with signs or letters (N, S, E or Ø, W or V; before or behind; any
 * case), all usual marks or spaces, decimal points, or commas where they cannot separate; ISO 6709;
 * and UTM, UPS and MGRS by GeographicLib (centre of the square). Latitude comes first unless
 * letters indicate otherwise. A zero needs no letter. Returns the position with longitude in [-180,
 * 180), or the reason why the text is not one. A text of more than 200 bytes is `Unreadable`.
 */
[[nodiscard]] std::variant<LatLon, CoordinateFault> parsePlace(std::string_view text);

/**
 * Returns the text of an angle >= 0 without hemisphere, UTF-8 with a decimal point: "47.0533°",
 * "47° 03.2′" or "47° 03′ 12″". `decimals` is the precision in decimals of a minute, 0 to 6, about
 * equal in all notations: 2 gives 0.01′, 0.0001° and 1″. With nullopt the text has whole degrees.
 * The value is rounded once, so minutes and seconds never read 60.
 */
[[nodiscard]] std::string angleText(double angle_deg, CoordinateForm form,
                                    std::optional<int> decimals);

/** Returns latitude and longitude in the notation of `angleText`, with letters N, S, E, W. */
[[nodiscard]] std::string placeText(const LatLon& place, CoordinateForm form,
                                    std::optional<int> decimals);

} // namespace berg
