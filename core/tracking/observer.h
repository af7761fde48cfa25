#pragma once

#include "core/base/geometry.h"

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

/**
 * Estimate and uncertainty of one iceberg, Eq. (18), (22)-(23): outside the field of view the
 * estimate moves with the known velocity and sigma grows by q dt; in view the estimate is the
 * truth and sigma is 0. (Eq. (21) as printed contradicts (22); (22) is what we do.)
 */
struct Track
{
    Point anchor_m = Point::Zero(); ///< estimate at `anchor_s`
    double anchor_s = 0;
    Point velocity_mps = Point::Zero();
    double sigma_m2 = 0; ///< variance along one axis
    double q_m2ps = 0;
    bool inView = false;

    [[nodiscard]] Point estimate_m(double time_s) const
    {
        return anchor_m + velocity_mps * (time_s - anchor_s);
    }
    void seen(const Point& truth_m, double time_s)
    {
        anchor_m = truth_m;
        anchor_s = time_s;
        sigma_m2 = 0;
        inView = true;
    }
    void unseen(double dt_s)
    {
        sigma_m2 += q_m2ps * dt_s;
        inView = false;
    }
    bool operator==(const Track&) const = default;
};

} // namespace berg
