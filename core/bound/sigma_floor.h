#pragma once

#include "core/bound/true_motion.h"

#include <vector>

namespace berg {

/** A straight line below a curve: slope x age - offset. */
struct FloorLine
{
    double slope_m2ps = 0;
    double offset_m2 = 0;
    DriftVariances least; ///< what the curve starts from
};

/**
 * What sigma of one measured iceberg is not below, whatever is flown.
 *
 * More looks never leave a filter with more variance (Kalman; in the order of matrices). So no
 * flight knows position and velocity better at an instant than one that has had the iceberg in view
 * since it is there, with every look a hit. Its covariances P, C >= 0, V after each look are known
 * before any flight; unseen for `a` since, sigma is P + 2 C a + V a^2 + q a or what a velocity that
 * changes makes of them, not less than with C = 0 and the least P and V of all looks that can be
 * the last. One that is found again starts from what was given, which is no better.
 */
class SigmaFloor
{
public:
    SigmaFloor(const Scenario& scenario, const Iceberg& iceberg, const TrueMotion& motion);

    /** Never seen until then. */
    [[nodiscard]] double unseen_m2(double time_s) const;
    /** The least P and V, with C = 0, of the looks that are the last ones in a window of edges. */
    [[nodiscard]] DriftVariances least(int from, int end) const;
    /** Last seen so long ago, with that left. */
    [[nodiscard]] double seen_m2(const DriftVariances& least, double age_s) const
    {
        return grown(least, m_process, age_s).position_m2;
    }
    /** Below `seen_m2` at all ages up to `most_s`, and nearest to it about `age_s`. */
    [[nodiscard]] FloorLine lineAt(const DriftVariances& least, double age_s, double most_s) const;

private:
    DriftProcess m_process;
    DriftVariances m_given; ///< at time 0
    /** By edge: the least of the looks since the edge before, of those next to it where there are
     * none. */
    std::vector<DriftVariances> m_least;
};

} // namespace berg
