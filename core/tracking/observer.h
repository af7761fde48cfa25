#pragma once

#include "core/base/geometry.h"
#include "core/tracking/drift.h"

#include <cstdint>

namespace berg {

enum class FovShape
{
    Body,  ///< rectangle turning with the UAV's heading
    North, ///< rectangle, along = north
    Disk   ///< diameter = the first extent
};

/** What the camera covers, bank ignored. */
struct SensorSpec
{
    Point fov_m = Point(600, 600); ///< extent along and across the heading
    FovShape shape = FovShape::Body;
    bool operator==(const SensorSpec&) const = default;
};

/** How positions and uncertainties of the icebergs are known. Names: `kObserverNames`. */
enum class ObserverModel
{
    Simple, ///< the paper's: in view the estimate is the truth, velocity and start are known
    Kalman  ///< noisy measurements of icebergs in view, filtered for position and velocity
};

/** What is flown to find an iceberg again that was not where it was believed to be. */
enum class SearchPattern
{
    None,
    Square, ///< expanding square
    Sector
};

/** The measurement processor; all but the model is read with `ObserverModel::Kalman` only. */
struct ObserverSpec
{
    ObserverModel model = ObserverModel::Simple;
    double positionSd_m = 5; ///< of a measurement, along each axis
    double interval_s = 1;   ///< between two looks of the camera
    double detection = 1;    ///< chance that one look shows an iceberg in view
    SearchPattern search = SearchPattern::Square;
    bool operator==(const ObserverSpec&) const = default;
};

/** The random numbers of one look at one iceberg. */
struct LookDraw
{
    double chance = 0;           ///< uniform in [0, 1): shown when below the chance of detection
    Point noise = Point::Zero(); ///< standard normal along each axis
};

/**
 * Those of look number `look` >= 0 of a run: the same whatever is flown, so that flights of one
 * scenario are compared with the same luck. `stream` is the iceberg's.
 */
[[nodiscard]] LookDraw lookDraw(std::uint64_t seed, std::uint64_t stream, std::int64_t look);

/** How far from the UAV everything is in view, whatever its heading. */
[[nodiscard]] double surelySeen_m(const SensorSpec& sensor);

/** Test of points against the field of view of a UAV at one instant. */
class FieldOfView
{
public:
    FieldOfView(const SensorSpec& sensor, const Point& centre_m, double psi_rad);

    [[nodiscard]] bool contains(const Point& p_m) const;

    /** No point farther from the UAV than this is in view, however it is turned. */
    [[nodiscard]] static double reach_m(const SensorSpec& sensor);

private:
    Point m_centre_m;
    Point m_along; ///< unit vector of the first extent
    Point m_half_m;
    bool m_disk;
};

/** Whether an iceberg is where it is believed to be, as far as is known. */
enum class TrackStatus
{
    Tracked,
    Lost,   ///< not seen where it should have been; searched for
    GivenUp ///< the search has ended without it; found only by chance
};

/**
 * Estimate and uncertainty of one iceberg. In the simple model Eq. (18), (22)-(23): outside the
 * field of view the estimate moves with the known velocity and sigma grows by q dt; in view the
 * estimate is the truth and sigma is 0. (Eq. (21) as printed contradicts (22); (22) is what we do.)
 *
 * With measurements a Kalman filter for position and velocity: constant velocity plus the
 * white-noise velocity of Eq. (17), whose position variance grows by q t. Both axes are measured
 * with the same variance, so they share one covariance (sigma, mixed, velocity variance). With a
 * known velocity and measurements without noise it is the simple model. Where the velocity is not
 * constant (`DriftProcess`), what is believed of it fades to the mean, and its variance grows.
 */
struct Track
{
    Point anchor_m = Point::Zero(); ///< estimate at `anchor_s`
    double anchor_s = 0;
    double seen_s = 0; ///< last seen; before the first time, known from then on
    Point velocity_mps = Point::Zero();
    double sigma_m2 = 0; ///< variance along one axis
    double q_m2ps = 0;
    bool inView = false;       ///< seen in the last look
    double mixed_m2ps = 0;     ///< covariance of position and velocity along one axis
    double velocity_m2ps2 = 0; ///< variance of the velocity along one axis
    double presence = 1;       ///< chance that it is where the camera looks in vain
    TrackStatus status = TrackStatus::Tracked;
    bool left = false;              ///< of the area that is monitored
    Point mean_mps = Point::Zero(); ///< what the velocity fades to; see `DriftProcess`
    double velocitySpread_mps = 0;
    double velocityTime_s = 0; ///< 0: the velocity is constant

    [[nodiscard]] Point estimate_m(double time_s) const
    {
        if (velocityTime_s > 0 && time_s > anchor_s)
            return fadedEstimate_m(time_s);
        return anchor_m + velocity_mps * (time_s - anchor_s);
    }
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
     * Prediction of the filter: the variances of `dt_s` later. A velocity that fades is then that
     * of the instant as well: the anchor moves on.
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
    /** sigma after `dt_s` >= 0 unseen. */
    [[nodiscard]] double sigmaAfter_m2(double dt_s) const
    {
        if (velocityTime_s > 0)
            return grown(variances(), process(), dt_s).position_m2;
        return sigma_m2 + q_m2ps * dt_s + dt_s * (2 * mixed_m2ps + dt_s * velocity_m2ps2);
    }
    /** A position measured at `time_s`, to which the variances have grown. */
    void measured(const Point& position_m, double variance_m2, double time_s);
    bool operator==(const Track&) const = default;

private:
    [[nodiscard]] Point fadedEstimate_m(double time_s) const;
    void moveOn(double dt_s);
};

} // namespace berg
