#pragma once

#include "core/base/issue.h"
#include "core/scenario/fence.h"

#include <memory>
#include <vector>

namespace berg {

/** What is planned for one UAV. */
struct PlannedPath
{
    /** The UAV, then where it is to meet each iceberg of its order. */
    std::vector<Point> places_m;
    std::size_t thisSortie = 0; ///< so many of them, the first included, are before going home
    double aloft_s = 0;         ///< since take-off, at the start
    Point wind_mps = Point::Zero();
    std::shared_ptr<const Geofence> fence; ///< that the legs lead round; null: none
};

/** Where a plan cannot be left for home any more with the reserve whole. */
struct NoReturn
{
    double time_s = 0;         ///< from the start of the path
    std::vector<Point> path_m; ///< to there, from the last place before
};

/** What an operator must know of a plan besides the order. */
struct SortieOutlook
{
    /**
     * What is left of the usable endurance (`usableEndurance_s`) at home, and the least over the
     * plan: flying on makes the path home shorter by no more than what was flown. None: unlimited.
     */
    std::optional<double> margin_s;
    std::optional<NoReturn> noReturn; ///< on the path past all icebergs; none: nowhere
    double noContact_s = 0;           ///< out of the range of the ground station; 0 without one
};

/** Legs are straight, or straight from corner to corner of the fence, flown at the airspeed in the
 * wind (`LegFlight`). */
[[nodiscard]] SortieOutlook sortieOutlook(const Scenario& scenario, const Uav& uav,
                                          const PlannedPath& path);

/**
 * The 5th percentile of the margin when wind and airspeed are not quite what they are taken for: of
 * 1,000 flights of the same path, the wind off by a normal error of 1 m/s + 15 % of its speed along
 * each axis, the airspeed by 3 % (standard deviations), drawn in the same way each time. Minus
 * infinity: against such a wind they never come home. None: unlimited endurance. About 0.2 ms for a
 * dozen icebergs.
 */
[[nodiscard]] std::optional<double> lowMargin_s(const Uav& uav, const PlannedPath& path);

/** Warnings of UAV number `index` of the scenario: the reserve that one flight of twenty takes, and
 * the time without contact. */
[[nodiscard]] std::vector<Issue> sortieIssues(std::size_t index, const SortieOutlook& outlook,
                                              const std::optional<double>& lowMargin_s);

/** How far the link of the ground station reaches at that height above the sea: the range given, or
 * the radio horizon of both, 4.12 km (sqrt(h1 / m) + sqrt(h2 / m)). */
[[nodiscard]] double linkRange_m(const GroundStation& station, double height_m);

} // namespace berg
