#pragma once

#include "core/bound/true_motion.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace berg {

/** A curve below zeta: no flight has a smaller zeta at any of these times. */
struct FrequencyBound
{
    std::vector<double> times_s; ///< Times, ascending from 0 to the end of the run.
    std::vector<double> zeta_m2s;

    /**
     * Returns the bound, in m2 s, at the latest point that is no later than `time_s`, which must
     * not be negative.
     */
    [[nodiscard]] double by_m2s(double time_s) const;
};

/**
 * Returns a lower bound on zeta from how often icebergs can be visited; it is useful for runs of
 * several rounds. `motion` must be made from the same scenario. Returns nullopt with the Kalman
 * filter, with fewer than two icebergs whose sigma grows, with too many icebergs (about 1400), or
 * after a stop.
 *
 * Proof. Sigma of iceberg i is q_i x (time since it was in view), so a gap of length g between two
 * sightings costs q_i g^2 / 2. Charge R_i for each visit of it and w_i mu for each second of a
 * stay; whatever is flown, the cost of i with these charges is at least V_i, the least over all
 * schedules of stays (`revisitCosts_m2s`). So zeta >= sum V_i - charges. The charges of a flight
 * are bounded by its time. Order its instants with an iceberg in view by time. Icebergs are in
 * groups, and a run of instants with icebergs of one group is one stay at that group, which counts
 * as a stay at each iceberg of it (that only lowers their cost). Between the last instant of a stay
 * and the first of the next, at another group, it flies from one view to another, which takes at
 * least the least time d_GH between the two (`LegTimes`). Let each group have a zone of radius y_G,
 * y_G + y_H <= d_GH for all pairs (`visitZones`), R_G = 2 mu y_G the sum of R_i in it, and the sum
 * of w_i in it 1. Each leg pays mu d_GH >= R_G / 2 + R_H / 2: half of each visit at its ends. Each
 * second of a stay pays mu. Stays and legs do not overlap, so the charges are at most mu T and two
 * halves: of the first visit, less mu x the time to get there from the start, and of the last one.
 * Several UAVs have m times as much; the fastest and its view stand for all. A UAV that flies to
 * and fro within a set of icebergs pays one leg for each visit, so the bound covers that case. For
 * equal distances d and n icebergs this is n^2 q d / 2 a second, which is exactly the cost of a
 * tour.
 *
 * The run is cut into slices, each with its own distances, groups, zones, R and mu, because
 * icebergs move. At most one leg or stay leads over the edge between two slices. Its losses are:
 * - for a leg from G to H, R_G / 2 + R_H / 2 - (the lesser mu) x (d_GH of both slices together);
 * - for a stay that continues at a group H which shares icebergs with G, R_G / 2 - R_H / 2 + (R of
 *   the icebergs of H that are not in G), because the shared ones keep their stay;
 * - for a leg or stay that began before the slice, at G, R_G / 2 + R_H / 2 - (mu x the lengths of
 *   all slices between) - (the losses at the edges between).
 *
 * The greatest loss is taken off at each edge. The bound holds for each choice of R and mu. The
 * zones come from a convex programme, the scale of mu from a search.
 *
 * Instants are time steps dt: a gap of n steps has n - 1 steps out of view, so q g dt / 2 and one
 * step of the first sigma are taken off, and a billionth of all sums for their rounding.
 */
[[nodiscard]] std::optional<FrequencyBound> frequencyBound(const Scenario& scenario,
                                                           const TrueMotion& motion,
                                                           const std::stop_token& stop = {});

} // namespace berg
