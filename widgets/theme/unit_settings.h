#pragma once

#include "core/base/coordinates.h"

#include <QSettings>

#include <cstdint>

namespace berg {

enum class DistanceUnit : std::uint8_t
{
    Metric,  ///< m and km
    Nautical ///< nautical miles of 1852 m
};

enum class SpeedUnit : std::uint8_t
{
    MetresPerSecond,
    Knots
};

/** How drift, current, wind and the way of an asset are shown and typed. */
enum class VectorForm : std::uint8_t
{
    Direction, ///< speed and direction: wind from there, all else towards it
    Components ///< east and north
};

enum class HeightUnit : std::uint8_t
{
    Metres,
    Feet
};

/** Whether courses are shown by magnetic north beside true north, and by which declination. */
enum class NorthForm : std::uint8_t
{
    True,  ///< by true north alone
    Model, ///< the World Magnetic Model, at place and date
    Typed  ///< `typedDeclination_deg`
};

/** How the instants of a run are shown if its scenario has a start; else they are elapsed times. */
enum class TimeForm : std::uint8_t
{
    Utc,
    Elapsed ///< since the start of the run
};

/** Which way of saying how uncertain a position is comes first; the other is beside it. */
enum class UncertaintyForm : std::uint8_t
{
    Sigma,   ///< the variance along each axis, m²
    Radius95 ///< of the circle that holds it with 95 %
};

/**
 * What distances, heights, speeds, places and times are shown and typed in; one unit for each
 * quantity. Files, the command line and everything inside are SI. Sizes of things and the
 * cross-track error are metres in any case.
 */
struct alignas(8) Units // one word: Clang stores others by a function of a library
{
    DistanceUnit distance = DistanceUnit::Metric;
    SpeedUnit speed = SpeedUnit::MetresPerSecond;
    VectorForm vectors = VectorForm::Direction;
    CoordinateForm coordinates = CoordinateForm::DegreesMinutes;
    HeightUnit height = HeightUnit::Metres;
    NorthForm north = NorthForm::True;
    TimeForm times = TimeForm::Utc;
    UncertaintyForm uncertainty = UncertaintyForm::Sigma;
    bool operator==(const Units&) const = default;
};

/**
 * Those in use: of the process, as the default `QLocale` is. Whoever makes windows sets them
 * before, and makes the window anew when they change. Any thread may read.
 */
[[nodiscard]] Units shownUnits();
void setShownUnits(const Units& units);

// Settings of the user: the key of each quantity, and the values it takes, the default first.
inline constexpr const char* kDistanceUnitKey = "units/distance"; ///< metric, nautical
inline constexpr const char* kSpeedUnitKey = "units/speed";       ///< mps, knots
inline constexpr const char* kCoordinateFormKey =
    "units/coordinates";                                       ///< minutes, decimal, seconds
inline constexpr const char* kVectorFormKey = "units/vectors"; ///< direction, components
inline constexpr const char* kHeightUnitKey = "units/heights"; ///< metres, feet
inline constexpr const char* kNorthFormKey = "units/north";    ///< true, model, typed
inline constexpr const char* kTimeFormKey = "units/times";     ///< utc, elapsed
inline constexpr const char* kUncertaintyFormKey = "units/uncertainty"; ///< sigma, radius

/** What is not there or unknown is the default. */
[[nodiscard]] Units readUnits(const QSettings& settings);

} // namespace berg
