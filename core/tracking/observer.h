#pragma once

#include "core/geometry/geometry.h"
#include "core/tracking/drift.h"

#include <cstdint>
#include <optional>

namespace berg {

/** Shape of the camera's field of view. */
enum class FovShape
{
    Body,  ///< rectangle that turns with the UAV's heading
    North, ///< rectangle, along = north
    Disk   ///< disk whose diameter is the first extent
};

/** Ground area covered by the camera; bank is ignored. */
struct SensorSpec
{
    Point fov_m = Point(600, 600); ///< extent along and across the heading
    FovShape shape = FovShape::Body;
    bool operator==(const SensorSpec&) const = default;
};

/**
 * Model of how positions and uncertainties of the icebergs become known. Names: `kObserverNames`.
 */
enum class ObserverModel
{
    Simple, ///< model of the paper: in view the estimate is the truth; velocity and start are known
    Kalman  ///< noisy measurements of icebergs in view, filtered for position and velocity
};

/** Pattern flown to find an iceberg again that was not at its estimate. */
enum class SearchPattern
{
    None,
    Square, ///< expanding square
    Sector
};

/**
 * Parameters of the measurement processor. `ObserverModel::Simple` uses only the search pattern
 * and, for the chances of a search, the detection probability.
 */
struct ObserverSpec
{
    ObserverModel model = ObserverModel::Simple;
    double positionSd_m = 5; ///< standard deviation of a measurement along each axis
    double interval_s = 1;   ///< sensor interval
    /** Detection probability: chance that one camera sample shows an iceberg in view. */
    double detection = 1;
    SearchPattern search = SearchPattern::Square;
    bool operator==(const ObserverSpec&) const = default;
};

/** Random numbers of one camera sample of one iceberg. */
struct SampleDraw
{
    /** Uniform in [0, 1); the iceberg is detected if it is below the detection probability. */
    double chance = 0;
    Point noise = Point::Zero(); ///< standard normal number along each axis
};

/**
 * Returns the random numbers of camera sample number `sample` >= 0 of a run. They do not depend on
 * the flight, so that flights of one scenario are compared under equal chances. `stream` is the
 * iceberg's.
 */
[[nodiscard]] SampleDraw sampleDraw(std::uint64_t seed, std::uint64_t stream, std::int64_t sample);

/** Returns the distance, m, from the UAV within which everything is in view, on any heading. */
[[nodiscard]] double surelySeen_m(const SensorSpec& sensor);

/** Tests points against the field of view of a UAV at one instant. */
class FieldOfView
{
public:
    /** Makes the field of view of a UAV at `centre_m` with heading `psi_rad`. */
    FieldOfView(const SensorSpec& sensor, const Point& centre_m, double psi_rad);

    /** Returns whether the point is in view. */
    [[nodiscard]] bool contains(const Point& p_m) const;

    /** Returns the distance, m, beyond which no point is in view, on any heading. */
    [[nodiscard]] static double reach_m(const SensorSpec& sensor);

private:
    Point m_centre_m;
    Point m_along; ///< unit vector of the first extent
    Point m_half_m;
    bool m_disk;
};

/** Whether an iceberg is near its estimate, as far as is known. */
enum class TrackStatus
{
    Tracked,
    Lost,   ///< not seen at its estimate; it is searched for
    GivenUp ///< the search ended without a sighting; only chance can find it
};

/**
 * Estimate and uncertainty of one iceberg. The simple model follows Eq. (18), (22)-(23): outside
 * the field of view the estimate moves with the known velocity and sigma grows by q dt; in view the
 * estimate is the truth and sigma is 0. (Eq. (21) as printed contradicts (22); (22) is used.)
 *
 * With measurements it is a Kalman filter for position and velocity: constant velocity plus the
 * white-noise velocity of Eq. (17), whose position variance grows by q t. Both axes are measured
 * with the same variance, so they share one covariance (sigma, mixed, velocity variance). With a
 * known velocity and measurements without noise it equals the simple model. If the velocity is not
 * constant (`DriftProcess`), its estimate fades to the mean and its variance grows.
 */
struct Track
{
    Point anchor_m = Point::Zero(); ///< estimate at `anchor_s`
    double anchor_s = 0;
    /** Time of the last sighting; before the first one, the time from which it is known. */
    double seen_s = 0;
    Point velocity_mps = Point::Zero();
    double sigma_m2 = 0; ///< variance of the position along one axis
    double q_m2ps = 0;
    bool inView = false;       ///< whether the last camera sample showed it
    double mixed_m2ps = 0;     ///< covariance of position and velocity along one axis
    double velocity_m2ps2 = 0; ///< variance of the velocity along one axis
    /** Probability that it is near its estimate after camera samples that showed nothing. */
    double presence = 1;
    TrackStatus status = TrackStatus::Tracked;
    bool left = false;              ///< whether it has left the monitored area
    Point mean_mps = Point::Zero(); ///< mean to which the velocity fades; see `DriftProcess`
    double velocitySpread_mps = 0;
    double velocityTime_s = 0; ///< 0 means a constant velocity
    /** Whether the mean changes with place and time (`DriftForcing`); `setMean` changes it. */
    bool isForced = false;

    /** Returns the predicted position at `time_s`. */
    [[nodiscard]] Point estimate_m(double time_s) const
    {
        if (velocityTime_s > 0 && time_s > anchor_s)
            return fadedEstimate_m(time_s);
        return anchor_m + velocity_mps * (time_s - anchor_s);
    }
    /** Sets the estimate to the true position seen at `time_s`; simple model. */
    void seen(const Point& truth_m, double time_s)
    {
        anchor_m = truth_m;
        anchor_s = time_s;
        seen_s = time_s;
        sigma_m2 = 0;
        inView = true;
    }
    [[nodiscard]] DriftProcess process() const
    {
        return {.q_m2ps = q_m2ps,
                .velocitySpread_mps = velocitySpread_mps,
                .velocityTime_s = velocityTime_s};
    }
    [[nodiscard]] DriftVariances variances() const
    {
        return {
            .position_m2 = sigma_m2, .mixed_m2ps = mixed_m2ps, .velocity_m2ps2 = velocity_m2ps2};
    }
    void setVariances(const DriftVariances& variances)
    {
        sigma_m2 = variances.position_m2;
        mixed_m2ps = variances.mixed_m2ps;
        velocity_m2ps2 = variances.velocity_m2ps2;
    }
    /**
     * Predicts the variances after `dt_s`. If the velocity fades, the anchor moves on too, so that
     * the velocity is that of the same instant.
     */
    void grow(double dt_s)
    {
        if (velocityTime_s > 0) {
            moveOn(dt_s);
            return;
        }
        sigma_m2 += q_m2ps * dt_s + dt_s * (2 * mixed_m2ps + dt_s * velocity_m2ps2);
        mixed_m2ps += dt_s * velocity_m2ps2;
    }
    /** Returns sigma after `dt_s` >= 0 without a sighting. */
    [[nodiscard]] double sigmaAfter_m2(double dt_s) const
    {
        if (velocityTime_s > 0)
            return grown(variances(), process(), dt_s).position_m2;
        return sigma_m2 + q_m2ps * dt_s + dt_s * (2 * mixed_m2ps + dt_s * velocity_m2ps2);
    }
    /**
     * Sets the mean velocity from `time_s` on, which must not be before the anchor; the velocity
     * above the mean stays. Nullopt means that the iceberg is aground and stands still.
     */
    void setMean(const std::optional<Point>& mean, double time_s);
    /**
     * Updates the filter with a position measured at `time_s`; `grow` must have predicted the
     * variances for that time.
     */
    void measured(const Point& position_m, double variance_m2, double time_s);
    bool operator==(const Track&) const = default;

private:
    [[nodiscard]] Point fadedEstimate_m(double time_s) const;
    void moveOn(double dt_s);
};

} // namespace berg
