#pragma once

#include "core/scenario/scenario.h"

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

namespace berg {

/** How good a bound is wanted. */
struct BoundProgress
{
    double zeta_m2s = 0; ///< best bound so far
    double share = 0;    ///< of the work limit
};

struct BoundOptions
{
    /** Units of about half a nanosecond to a whole one: the default is 5 to 10 s on an idle core,
     * 13 to 27 s under load. What the icebergs' motion takes is not counted. */
    std::int64_t workLimit = 10'000'000'000;
    std::stop_token stop;
    std::function<void(const BoundProgress&)> onProgress; ///< told of each rise, on this thread
};

/** At the end of a block of time steps. */
struct BoundPoint
{
    double time_s = 0;
    double sigma_m2 = 0; ///< over the block, sum of sigma is nowhere less
    double zeta_m2s = 0; ///< zeta is not less by then
    bool operator==(const BoundPoint&) const = default;
};

/** A bound below this part of what is flown says nothing about how good that is. */
inline constexpr double kLeastUsefulBound = 0.2;
[[nodiscard]] inline bool isUsefulBound(double bound_m2s, double flown_m2s)
{
    return bound_m2s >= kLeastUsefulBound * flown_m2s;
}

struct ZetaBound
{
    double zeta_m2s = 0;
    std::vector<BoundPoint> curve; ///< from time 0 to the end of the run, at most 2001 points
    std::int64_t work = 0;
    bool cancelled = false; ///< the stop token ended it; the bound holds all the same

    /** Zeta at this time is not less. Non-negative time. */
    [[nodiscard]] double by_m2s(double time_s) const;
};

/**
 * A number that zeta, Eq. (24), of no flight of this scenario is below, whatever the policy.
 *
 * It holds for every path that gets through the air no faster than the airspeed from the UAV's
 * position at t = 0, with any turn radius, heading and endurance, and for the world that the
 * scenario draws: the true tracks, noise of its seed included, are those the simulation flies.
 * Icebergs added during the run only add to zeta; but one reported seen from outside breaks it.
 * Those that may leave the area are left out. A Kalman filter's sigma is at least what would be
 * left after looks at that one iceberg all the time (`SigmaFloor`): a curve over the time since it
 * was measured, in place of which a line below it is taken, near to it at the mean age; unseen it
 * is what was given, grown.
 *
 * Why. Sigma of an iceberg is q x (time since it was in view), or initial + q t. Fix an instant t
 * and a time w <= t, and let R_i hold every place from which iceberg i is in view at any instant of
 * [w, t], in a frame that moves with the icebergs' mean velocity (Body: the disk of half the
 * diagonal, which holds the rectangle at any heading). Let s_i be the last instant of [w, t] in
 * R_i; the age of i is at least t - s_i. Sorted by s_i, the way from one to the next takes at least
 * the least time of flight between the *edges* of the regions, because an s_i < t is a crossing of
 * the edge; those with s_i = t were all in view when the last of them was entered, or when the last
 * of the others was left. So sum of q_i (t - s_i) is at least the cheapest chain of edge points, a
 * leg costing its time x q of what was seen before it: a dynamic programme over (set seen, cell of
 * an edge), legs counted between the nearest points of cells. What is in no set pays initial + q t
 * (w = 0), or q (t - w) (w > 0). With w = 0 a set also has to be reached from the start by t: by
 * itself, and with several prices lambda on the way's length, cost + lambda (length - t). The bound
 * is the least over all sets, at each block of time steps, the most over windows w and refinements,
 * summed over disjoint groups of icebergs: what bounds one group says nothing of the others. The
 * groups are 14 icebergs each; from 113 icebergs on so many that one pass takes at most a third of
 * the work limit.
 *
 * A UAV with an endurance stands at home meanwhile (`groundCosts_m2s`), which counts besides where
 * it flies alone. `HoldHere` and orders home only lengthen that.
 *
 * Several UAVs: each iceberg of the set is last seen by one of them, and what is said above of the
 * set holds for each UAV and its share of it, in regions and times of its own. So the set costs at
 * least the least sum of chains over all ways to share it out (subset convolution, 3^n). Windows
 * with w > 0 take every UAV to begin anywhere, which is the weaker the more there are.
 *
 * The same bytes for the same scenario and work limit. More work never lowers it, with up to 112
 * icebergs; with more it may, where it makes the groups larger. The scenario must have no errors
 * (`validate`).
 */
[[nodiscard]] ZetaBound zetaLowerBound(const Scenario& scenario, const BoundOptions& options = {});

} // namespace berg
