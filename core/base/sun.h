#pragma once

#include "core/base/geodesy.h"

#include <chrono>
#include <optional>

namespace berg {

/** An instant of UTC, without leap seconds. */
using SunTime = std::chrono::sys_time<std::chrono::milliseconds>;

/**
 * Height of the sun's centre above the horizon, degrees, without refraction. Equations of NOAA's
 * solar calculator (gml.noaa.gov/grad/solcalc), after Meeus, Astronomical Algorithms (1991); within
 * 0.01 degrees from 1900 to 2100.
 */
[[nodiscard]] double sunElevation_deg(SunTime time, LatLon place);

/** When the sun's upper edge is seen on the horizon: 34' of refraction and a radius of 16'. */
inline constexpr double kSunrise_deg = -0.833;
/** At civil twilight the centre of the sun is no more than this below the horizon. */
inline constexpr double kCivilTwilight_deg = -6;

/** When the sun is above an elevation, from one solar midnight to the next. */
struct SunSpan
{
    /** When it rises and sets through the elevation; nullopt: not on this day. */
    std::optional<SunTime> begin;
    std::optional<SunTime> end;
    bool isAboveAtNoon = false; ///< with neither time: all day, else never
    bool operator==(const SunSpan&) const = default;
};

/** Of the solar day round `time`: 12 hours before and after the nearest solar noon. */
[[nodiscard]] SunSpan sunSpan(SunTime time, LatLon place, double elevation_deg);

/** First time after `time` at which the sun rises through the elevation; nullopt if none within a
 * year. */
[[nodiscard]] std::optional<SunTime> nextRise(SunTime time, LatLon place, double elevation_deg);
/** Last time before `time` at which it set through the elevation; nullopt if none within a year. */
[[nodiscard]] std::optional<SunTime> lastSet(SunTime time, LatLon place, double elevation_deg);

} // namespace berg
