#pragma once

#include "core/scenario/scenario.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/** Progress of `zetaLowerBound`. */
struct BoundProgress
{
    double zeta_m2s = 0; ///< Best bound so far.
    double share = 0;    ///< Spent share of the work limit, 0 to 1.
};

/** Limits and callbacks of `zetaLowerBound`. */
struct ZetaBoundOptions
{
    /**
     * Work in units of half a nanosecond to a whole one; the default takes 5 to 10 s on an idle
     * core and 13 to 27 s under load. The icebergs' motion and `frequencyBound` are not counted;
     * the latter takes 2 s at most and is left out below 1e6 units.
     */
    std::int64_t workLimit = 10'000'000'000;
    std::stop_token stop;
    /** Called after each step, on the calling thread. */
    std::function<void(const BoundProgress&)> onProgress;
};

/** The bound at the end of a block of time steps. */
struct BoundPoint
{
    double time_s = 0;
    double sigma_m2 = 0; ///< Lower bound on the sum of sigma over the whole block.
    double zeta_m2s = 0; ///< Lower bound on zeta by then.
    /** `zeta_m2s` follows from visit rates (`frequencyBound`), else from sequences of visits. */
    bool isFromRates = false;
    bool operator==(const BoundPoint&) const = default;
};

/** A bound below this share of a flown zeta does not show how good that zeta is. */
inline constexpr double kLeastUsefulBound = 0.2;
/** Returns whether a bound is close enough to a flown zeta to show how good that is. */
[[nodiscard]] inline bool isUsefulBound(double bound_m2s, double flown_m2s)
{
    return bound_m2s >= kLeastUsefulBound * flown_m2s;
}

/** Result of `zetaLowerBound`. */
struct ZetaBound
{
    double zeta_m2s = 0;
    /** Points from time 0 to the end of the run, at most 2001 of them. */
    std::vector<BoundPoint> curve;
    std::optional<double> frequency_m2s; ///< `frequencyBound` alone; nullopt if it does not apply.
    std::int64_t work = 0;
    /** The stop token ended the calculation; the bound is valid all the same. */
    bool cancelled = false;

    /**
     * Returns the lower bound on zeta in m2 s at the last point of the curve that is no later than
     * `time_s`, which must not be negative.
     */
    [[nodiscard]] double by_m2s(double time_s) const { return by(time_s).zeta_m2s; }
    /** Returns the last point of the curve that is no later than `time_s`. */
    [[nodiscard]] BoundPoint by(double time_s) const;
};

/**
 * Returns a lower bound on zeta, Eq. (24), of every flight of this scenario, whatever the policy.
 * It is the greater of the bound that is proven here and of `frequencyBound`, which is the better
 * one in runs of several rounds.
 *
 * If a forecast lets the wind change, UAVs count as flying in calm air at their airspeed plus
 * the strongest wind of the run, which no flight exceeds over ground. Icebergs whose drift a
 * forecast changes are left out if the area is bounded.
 *
 * It holds for every path that gets through the air no faster than the airspeed from the UAV's
 * position at t = 0, with any turn radius, heading and endurance, and for the world that the
 * scenario draws: the true tracks, noise of its seed included, are those the simulation flies.
 * Icebergs added during the run only add to zeta; but one reported seen from outside breaks it.
 * Icebergs that may leave the area are left out. A Kalman filter's sigma is at least the one left
 * after samples of that one iceberg all the time (`SigmaFloor`), a curve over the time since the
 * last sample. A line below that curve, near to it at the mean age, takes its place. An iceberg
 * that is never seen has its given variances, grown.
 *
 * Proof. Sigma of an iceberg is q x (time since it was in view), or initial + q t. Fix an instant t
 * and a time w <= t, and let R_i hold every place from which iceberg i is in view at any instant of
 * [w, t], in a frame that moves with the icebergs' mean velocity (Body: the disk of half the
 * diagonal, which holds the rectangle at any heading). Let s_i be the last instant of [w, t] in
 * R_i; the age of i is at least t - s_i. Sorted by s_i, the path from one to the next takes at
 * least the least time of flight between the *edges* of the regions, because an s_i < t is a
 * crossing of the edge; those with s_i = t were all in view when the last of them was entered, or
 * when the last of the others was left. So sum of q_i (t - s_i) is at least the cheapest chain of
 * edge points, a leg costing its time x q of the icebergs seen before it. A dynamic programme finds
 * it over (set seen, cell of an edge), legs counted between the nearest points of cells. Icebergs
 * in no set pay initial + q t (w = 0), or q (t - w) (w > 0). With w = 0 a set also has to be
 * reached from the start by t: by itself, and with several multipliers lambda on the path's length,
 * cost + lambda (length - t). The bound is the least over all sets, at each block of time steps,
 * the most over windows w and refinements, summed over disjoint groups of icebergs, whose bounds
 * are independent of each other. Each group has 14 icebergs; from 113 icebergs on groups are so
 * small that one pass takes at most a third of the work limit.
 *
 * A UAV with an endurance stands at home meanwhile (`groundCosts_m2s`), which counts besides where
 * it flies alone. `HoldHere` and orders home only lengthen that.
 *
 * Several UAVs: each iceberg of the set is last seen by one of them, and the argument above holds
 * for each UAV and its share of it, in regions and times of its own. So the set costs at least the
 * least sum of chains over all partitions of the set (subset convolution, 3^n). Windows with w > 0
 * take every UAV to begin anywhere, which is the weaker the more there are.
 *
 * Equal scenarios and work limits give equal bytes. More work never lowers it, with up to 112
 * icebergs; with more it may, where it makes the groups larger. The scenario must have no errors
 * (`validate`).
 */
[[nodiscard]] ZetaBound zetaLowerBound(const Scenario& scenario,
                                       const ZetaBoundOptions& options = {});

} // namespace berg
