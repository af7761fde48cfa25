#pragma once

#include "core/bound/leg_times.h"

#include <span>
#include <vector>

namespace berg {

/**
 * Icebergs in groups, and the radius of a zone about each group. The radii of two groups sum to no
 * more than the time of flight between any icebergs of the two. A sighting of one iceberg of a
 * group counts as one of all of them.
 */
struct VisitZones
{
    std::vector<int> groupOf;        ///< Group of each iceberg.
    std::vector<double> growth_m2ps; ///< Sum of q of each group.
    std::vector<double> radius_s;    ///< Radius of the zone of each group.
    double rootSum = 0;              ///< Sum of sqrt(growth x radius) over the groups.

    /** Returns the number of groups. */
    [[nodiscard]] int groups() const { return static_cast<int>(radius_s.size()); }
};

/**
 * Returns zones with a large sum of sqrt(growth x radius); its square bounds the mean sum of sigma
 * over a long patrol of one UAV from below. `growth_m2ps` holds q of each iceberg of `legs`, in its
 * order; all must be positive. A requested stop ends the improvement early, and the result is then
 * empty or less good.
 *
 * The zones are the dual of a convex programme: minimise sum growth_G / (4 x_G) + sum x_GH d_GH
 * over the rates x_GH >= 0 of legs between groups, x_G = sum over H of x_GH. Multiplicative steps,
 * each of which minimises a function above the objective, lead to y_G = growth_G / (4 x_G^2). The
 * radii are then cut to the legs, so the zones are valid whether or not the steps have converged.
 * Groups are merged while that raises the sum.
 */
[[nodiscard]] VisitZones visitZones(const LegTimes& legs, std::span<const double> growth_m2ps,
                                    const std::stop_token& stop = {});

/**
 * Returns the least time in seconds between icebergs of each group of `a` and each group of `b`,
 * row by row with one row for each group of `a`. The two may group the icebergs of `legs`
 * differently; groups that share an iceberg have 0.
 */
[[nodiscard]] std::vector<double> groupLegs_s(const LegTimes& legs, const VisitZones& a,
                                              const VisitZones& b);

} // namespace berg
