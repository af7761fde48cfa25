#pragma once

#include "core/earth/geodesy.h"

#include <chrono>
#include <optional>

namespace berg {

/** An instant in UTC, without leap seconds. */
using SunTime = std::chrono::sys_time<std::chrono::milliseconds>;

/**
 * Returns the elevation of the sun's centre above the horizon, degrees, without refraction.
 * Equations of NOAA's solar calculator (gml.noaa.gov/grad/solcalc), after Meeus, Astronomical
 * Algorithms (1991); accurate to 0.01 degrees from 1900 to 2100.
 */
[[nodiscard]] double sunElevation_deg(SunTime time, LatLon place);

/**
 * Elevation at which the sun's upper edge appears on the horizon: 34' of refraction and a radius of
 * 16'.
 */
inline constexpr double kSunrise_deg = -0.833;
/** Lowest elevation of the sun's centre in civil twilight. */
inline constexpr double kCivilTwilight_deg = -6;

/** Time for which the sun is above an elevation, within one solar day. */
struct SunSpan
{
    /** Times of rising and setting through the elevation; nullopt if it does not on this day. */
    std::optional<SunTime> begin;
    std::optional<SunTime> end;
    /** True if above at solar noon; if both times are nullopt, above all day. */
    bool isAboveAtNoon = false;
    bool operator==(const SunSpan&) const = default;
};

/**
 * Returns the span for the solar day around `time`: 12 hours before and after the nearest solar
 * noon.
 */
[[nodiscard]] SunSpan sunSpan(SunTime time, LatLon place, double elevation_deg);

/**
 * Returns the first time after `time` at which the sun rises through the elevation, or nullopt if
 * there is none within a year.
 */
[[nodiscard]] std::optional<SunTime> nextRise(SunTime time, LatLon place, double elevation_deg);
/**
 * Returns the last time before `time` at which the sun set through the elevation, or nullopt if
 * there is none within a year.
 */
[[nodiscard]] std::optional<SunTime> lastSet(SunTime time, LatLon place, double elevation_deg);

} // namespace berg
