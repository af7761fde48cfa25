#pragma once

#include "core/base/geodesy.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace berg {

/** How coordinates are written. */
enum class CoordinateForm : std::uint8_t
{
    DegreesMinutes, ///< 47° 03.2′ N, as at sea
    DecimalDegrees, ///< 47.0533° N
    DegreesMinutesSeconds
};

/** Why a text is no place. */
enum class CoordinateFault
{
    Empty,
    Unreadable,
    Half,              ///< one angle only
    Ambiguous,         ///< more than one way to read it
    HemisphereMissing, ///< one angle has a letter, the other neither letter nor sign
    SignAndLetter,     ///< "-47 N"
    SameAxis,          ///< two latitudes or two longitudes
    Sixty,             ///< minutes or seconds of 60 and more
    Latitude,          ///< beyond 90 degrees
    Longitude,         ///< beyond 180 degrees; without a letter, from 360 on
    Grid               ///< looks like UTM, UPS or MGRS, but is not on that grid
};

/** In English, a whole sentence. */
[[nodiscard]] std::string_view faultText(CoordinateFault fault);

/**
 * The place a UTF-8 text names: decimal degrees, degrees and minutes, or those and seconds, with
 * signs or letters (N, S, E or Ø, W or V; before or behind; any case), marks of all usual kinds or
 * spaces, decimal points, or commas where they cannot separate; ISO 6709; UTM, UPS and MGRS by
 * GeographicLib (the centre of a square). Latitude first unless letters say otherwise. A zero needs
 * no letter. Longitude in [-180, 180).
 */
[[nodiscard]] std::variant<LatLon, CoordinateFault> parsePlace(std::string_view text);

/**
 * An angle >= 0 without hemisphere, UTF-8 with a decimal point: "47.0533°", "47° 03.2′" or
 * "47° 03′ 12″". `decimals` of a minute, 0 to 6, name the precision in every form, about: 2 are
 * 0.01′, 0.0001° and 1″; -1: whole degrees. Rounded once, so that no minutes or seconds of 60 come
 * out.
 */
[[nodiscard]] std::string angleText(double angle_deg, CoordinateForm form, int decimals);

/** Both angles as `angleText` writes them, with letters N, S, E, W. */
[[nodiscard]] std::string placeText(const LatLon& place, CoordinateForm form, int decimals);

} // namespace berg
