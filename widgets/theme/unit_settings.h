#pragma once

#include "core/earth/coordinates.h"

#include <QSettings>

#include <cstdint>

namespace berg {

/** Unit of distances. */
enum class DistanceUnit : std::uint8_t
{
    Metric,  ///< m and km
    Nautical ///< nautical miles of 1852 m
};

/** Unit of speeds. */
enum class SpeedUnit : std::uint8_t
{
    MetresPerSecond,
    Knots
};

/** Form in which drift, current, wind and an asset's velocity are shown. */
enum class VectorForm : std::uint8_t
{
    Direction, ///< speed and direction: wind comes from it, all others go towards it
    Components ///< east and north
};

/** Unit of heights. */
enum class HeightUnit : std::uint8_t
{
    Metres,
    Feet
};

/** Whether courses by magnetic north are shown besides true north, and with which declination. */
enum class NorthForm : std::uint8_t
{
    True,  ///< true north only
    Model, ///< World Magnetic Model at place and date
    Typed  ///< typed declination (`typedDeclination_deg`)
};

/** Form of the times of a run if its scenario has a start; otherwise they are elapsed times. */
enum class TimeForm : std::uint8_t
{
    Utc,
    Elapsed ///< since the start of the run
};

/** Which measure of position uncertainty comes first; the other one is shown beside it. */
enum class UncertaintyForm : std::uint8_t
{
    Sigma,   ///< variance along each axis, m²
    Radius95 ///< radius of the 95 % position circle
};

/**
 * Units in which quantities are shown and typed, one per quantity. Files, the command line and all
 * internal values are SI. Object sizes and the cross-track error are always in metres.
 */
struct alignas(8) Units // one word: for other sizes Clang's atomics need a library
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
 * Units of this process, like the default `QLocale`. Set them before creating windows, and recreate
 * windows after a change. Any thread may read them.
 */
[[nodiscard]] Units shownUnits();
/** Sets the units of this process. */
void setShownUnits(const Units& units);

// Keys of the user's settings with their values, the default first.
inline constexpr const char* kDistanceUnitKey = "units/distance"; ///< metric, nautical
inline constexpr const char* kSpeedUnitKey = "units/speed";       ///< mps, knots
inline constexpr const char* kCoordinateFormKey =
    "units/coordinates";                                       ///< minutes, decimal, seconds
inline constexpr const char* kVectorFormKey = "units/vectors"; ///< direction, components
inline constexpr const char* kHeightUnitKey = "units/heights"; ///< metres, feet
inline constexpr const char* kNorthFormKey = "units/north";    ///< true, model, typed
inline constexpr const char* kTimeFormKey = "units/times";     ///< utc, elapsed
inline constexpr const char* kUncertaintyFormKey = "units/uncertainty"; ///< sigma, radius

/** Reads the units; a missing or unknown value means the default. */
[[nodiscard]] Units readUnits(const QSettings& settings);

} // namespace berg
