#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace berg {

// Uncertainty of positions. In this program sigma is the variance of the position along one axis,
// m², the same along both (Eq. (22)-(23); with the Kalman filter the mean of the two variances). So
// the distance from the estimate is Rayleigh distributed: distance² / sigma is chi-square with 2
// degrees of freedom, P(distance <= r) = 1 - exp(-r² / (2 sigma)).

/** 95 % point of chi-square with 2 degrees of freedom: -2 ln 0.05. */
inline constexpr double kChiSquare95 = 5.991464547107979;

/** Returns the radius of the 95 % position circle round the estimate; requires sigma >= 0. */
[[nodiscard]] double radius95_m(double sigma_m2);
/** Returns the sigma whose 95 % position circle has that radius >= 0. */
[[nodiscard]] double sigmaOfRadius95_m2(double radius_m);

/** Sensor or observer that reported an iceberg. */
enum class SightingSource : std::uint8_t
{
    Radar,
    Visual,
    Satellite,
    Camera,
    GpsBeacon,
    ArgosBeacon,
    Ais,
    Aircraft
};

/** All sources, in the order of the enumerators. */
inline constexpr SightingSource kSightingSources[]{
    SightingSource::Radar,  SightingSource::Visual,    SightingSource::Satellite,
    SightingSource::Camera, SightingSource::GpsBeacon, SightingSource::ArgosBeacon,
    SightingSource::Ais,    SightingSource::Aircraft};

/** Typical error of a position from one source at the time of the fix; it grows from then on. */
struct SourceError
{
    std::string_view name;   ///< name in settings
    double sd_m = 0;         ///< standard deviation along one axis
    std::string_view reason; ///< why this value, in English

    [[nodiscard]] double sigma_m2() const { return sd_m * sd_m; }
};

/** Returns the typical error of a source. */
[[nodiscard]] const SourceError& errorOf(SightingSource source);
/** Returns the source with the settings name `name`, or nullopt if there is none. */
[[nodiscard]] std::optional<SightingSource> sourceNamed(std::string_view name);
/**
 * Returns the source that a text names in the words of logs, such as "VIS", "RADARSAT-2" or "gps
 * beacon". If it names several, returns the one with the smallest error, because all of them saw
 * the iceberg. Returns nullopt if it names none.
 */
[[nodiscard]] std::optional<SightingSource> sourceInWords(std::string_view text);
/** Returns the source with exactly this sigma (no two are equal), or nullopt if there is none. */
[[nodiscard]] std::optional<SightingSource> sourceWith(double sigma_m2);

} // namespace berg
