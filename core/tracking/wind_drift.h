#pragma once

#include "core/earth/geodesy.h"
#include "core/geometry/geometry.h"
#include "core/tracking/iceberg_size.h"

#include <string_view>

namespace berg {

/** Wind and current at one place and time: velocities towards true east and north. */
struct Forcing
{
    Point wind_mps = Point::Zero();
    Point current_mps = Point::Zero();
    bool operator==(const Forcing&) const = default;
};

/**
 * Returns the velocity of a wind that comes *from* a direction, degrees clockwise from true north.
 */
[[nodiscard]] Point windFrom_mps(double speed_mps, double from_deg);
/** Returns the velocity of a current that flows *towards* a direction, degrees clockwise. */
[[nodiscard]] Point currentTo_mps(double speed_mps, double to_deg);
/** Returns the direction of a velocity in [0, 360) degrees clockwise from north; 0 for none. */
[[nodiscard]] double directionTo_deg(const Point& velocity_mps);

/** Densities and form-drag coefficients of air and water. */
struct DragCoefficients
{
    std::string_view name;
    double air_kgpm3 = 0;
    double air = 0;
    double water_kgpm3 = 0;
    double water = 0;
};
/** Set of C-CORE's operational forecaster, to which `dimensionsOfLength` belongs. */
inline constexpr DragCoefficients kCCoreDrag{
    .name = "c-core", .air_kgpm3 = 1.225, .air = 1.1857, .water_kgpm3 = 1023.6, .water = 0.7867};
/** Set of OpenBerg (OpenDrift), without its skin friction. */
inline constexpr DragCoefficients kOpenBergDrag{
    .name = "openberg", .air_kgpm3 = 1.293, .air = 0.8, .water_kgpm3 = 1027, .water = 0.25};

/**
 * Returns the share f of the wind in the drift of an iceberg on which the drags of air and water
 * balance, without acceleration, Coriolis force and waves:
 *
 *     f = sqrt(k) / (1 + sqrt(k)),   k = air_kgpm3 air sail / (water_kgpm3 water keel)
 */
[[nodiscard]] double windShare(const IcebergDimensions& dimensions, const DragCoefficients& drag);

/** Velocity of ice as a linear combination of wind and current. */
struct DriftLaw
{
    double currentShare = 1;
    double windShare = 0;
    double turn_deg = 0; ///< of the wind: to the right in the north, to the left in the south
    bool operator==(const DriftLaw&) const = default;
};

/**
 * Law of bergy bits and growlers: the current and 2 % of the wind, turned 20 degrees (C-CORE,
 * documentation of drift-forecasting).
 */
inline constexpr DriftLaw kSmallIceDrift{.currentShare = 1, .windShare = 0.02, .turn_deg = 20};

/**
 * Returns the law of ice of this length > 0: `kSmallIceDrift` below `kShortestIceberg_m`, else V =
 * (1 - f) current + f wind with the `windShare` of its dimensions.
 */
[[nodiscard]] DriftLaw driftLaw(double length_m, const DragCoefficients& drag = kCCoreDrag);

/**
 * Returns the velocity of ice at this latitude; the equator counts as north. The wind is that at 10
 * m, the current the mean over the draft.
 */
[[nodiscard]] Point driftVelocity_mps(const DriftLaw& law, const Forcing& forcing,
                                      double latitude_deg);

} // namespace berg
