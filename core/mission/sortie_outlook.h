#pragma once

#include "core/base/issue.h"
#include "core/scenario/fence.h"
#include "core/vehicle/wind_series.h"

#include <memory>
#include <vector>

namespace berg {

/** Planned path of one UAV. */
struct PlannedPath
{
    /** Position of the UAV, then the meeting place of each iceberg in its order. */
    std::vector<Point> places_m;
    /** Number of places, the first included, before the UAV turns home. */
    std::size_t thisSortie = 0;
    double aloft_s = 0; ///< time since take-off at the start of the path
    WindAhead wind_mps; ///< from the start of the path on
    /** Fence that the legs lead around; null if there is none. */
    std::shared_ptr<const Geofence> fence;
};

/** Point of no return: beyond it the UAV cannot be home without using its reserve. */
struct NoReturn
{
    double time_s = 0;         ///< time since the start of the path
    std::vector<Point> path_m; ///< path to that point from the last place before it
};

/** Safety figures of a plan for the operator. */
struct SortieOutlook
{
    /**
     * Usable endurance (`usableEndurance_s`) left at home, s; also the least over the plan, since
     * flying on shortens the path home by no more than the distance flown. Nullopt if the endurance
     * is unlimited.
     */
    std::optional<double> margin_s;
    /** On the path past all icebergs; nullopt if the UAV can return from anywhere on it. */
    std::optional<NoReturn> noReturn;
    double noContact_s = 0; ///< time out of range of the ground station; 0 without a station
};

/**
 * Computes the safety figures of a path. Legs are straight, or straight from corner to corner of
 * the fence, and flown at the airspeed in the wind of the moment (`flightTime_s`). The figures are
 * empty for a path without places. The margin is minus infinity if the wind is not below the
 * airspeed.
 */
[[nodiscard]] SortieOutlook sortieOutlook(const Scenario& scenario, const Uav& uav,
                                          const PlannedPath& path);

/**
 * Returns the 5th percentile of the margin over 1,000 flights of the same path with errors in wind
 * and airspeed: normal with standard deviations of 1 m/s + 15 % of the wind speed along each axis,
 * and 3 % of the airspeed, the same random draws each time. The value is minus infinity if those
 * flights never come home against the wind. Returns nullopt if the endurance is unlimited or the
 * path has no places. Takes about 0.2 ms for a dozen icebergs.
 */
[[nodiscard]] std::optional<double> lowMargin_s(const Uav& uav, const PlannedPath& path);

/**
 * Returns the warnings for UAV number `index` of the scenario: reserve used by 1 flight in 20
 * (`lowMargin_s` below 0), and time without contact of at least 1 s.
 */
[[nodiscard]] std::vector<Issue> sortieIssues(std::size_t index, const SortieOutlook& outlook,
                                              const std::optional<double>& lowMargin_s);

/**
 * Returns the range of the ground station's link to a UAV `height_m` above the sea, m: the range of
 * the scenario, or the sum of both radio horizons, 4.12 km (sqrt(h1 / m) + sqrt(h2 / m)).
 */
[[nodiscard]] double linkRange_m(const GroundStation& station, double height_m);

} // namespace berg
