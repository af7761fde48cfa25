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

/**
 * What distances, heights, speeds and places are shown and typed in; one unit for each quantity.
 * Files, the command line and everything inside are SI. Sizes of things, their uncertainty and the
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

/** What is not there or unknown is the default. */
[[nodiscard]] Units readUnits(const QSettings& settings);

} // namespace berg
