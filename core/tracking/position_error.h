#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace berg {

// How uncertain a position is. sigma of this program is the variance of the position along one
// axis, m², the same along both (Eq. (22)-(23); with the Kalman filter the mean of the two
// variances). So the distance from the estimate is Rayleigh distributed: distance² / sigma is
// chi-square with 2 degrees of freedom, P(distance <= r) = 1 - exp(-r² / (2 sigma)).

/** 95 % point of chi-square with 2 degrees of freedom: -2 ln 0.05. */
inline constexpr double kChiSquare95 = 5.991464547107979;

/** Radius of the circle round the estimate that holds the position with 95 %; sigma >= 0. */
[[nodiscard]] double radius95_m(double sigma_m2);
/** The sigma whose circle has that radius, >= 0. */
[[nodiscard]] double sigmaOfRadius95_m2(double radius_m);

/** What an iceberg was seen or heard by. */
enum class SightingSource : std::uint8_t
{
    Radar,
    Visual,
    Satellite,
    Camera,
    GpsBeacon,
    ArgosBeacon
};

inline constexpr SightingSource kSightingSources[]{
    SightingSource::Radar,  SightingSource::Visual,    SightingSource::Satellite,
    SightingSource::Camera, SightingSource::GpsBeacon, SightingSource::ArgosBeacon};

/** The usual error of a position from one source, when it is fixed; it grows from then on. */
struct SourceError
{
    std::string_view name; ///< for settings
    double sd_m = 0;       ///< standard deviation along one axis
    std::string_view reason;

    [[nodiscard]] double sigma_m2() const { return sd_m * sd_m; }
};

[[nodiscard]] const SourceError& errorOf(SightingSource source);
/** Returns nullopt if no source has that name. */
[[nodiscard]] std::optional<SightingSource> sourceNamed(std::string_view name);
/** The source with exactly this sigma, no two of which are alike; nullopt if there is none. */
[[nodiscard]] std::optional<SightingSource> sourceWith(double sigma_m2);

} // namespace berg
