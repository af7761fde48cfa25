#pragma once

#include "core/bound/true_motion.h"

#include <vector>

namespace berg {

/** A straight line below sigma as a function of the age, slope x age - offset. */
struct FloorLine
{
    double slope_m2ps = 0;
    double offset_m2 = 0;
    DriftVariances least; ///< Variances at age 0.
};

/**
 * Lower bound on sigma of one measured iceberg in every flight.
 *
 * More samples never leave a filter with more variance (Kalman; in the order of matrices). So no
 * flight knows position and velocity better at an instant than one that has had the iceberg in view
 * since it appeared, with a hit in every sample. Its covariances P, C >= 0, V after each sample are
 * known before any flight. After `a` seconds out of view, sigma is P + 2 C a + V a^2 + q a or what
 * a velocity that changes makes of them, not less than with C = 0 and the least P and V of all
 * samples that can be the last. An iceberg that is found again starts from the given variances,
 * which are no smaller.
 */
class SigmaFloor
{
public:
    /**
     * Runs the filter of the iceberg over the whole run with a hit in every sample. `motion` must
     * be made from the scenario; nothing is borrowed.
     */
    SigmaFloor(const Scenario& scenario, const Iceberg& iceberg, const TrueMotion& motion);

    /** Returns the bound on sigma at `time_s` in m2 if the iceberg is not seen until then. */
    [[nodiscard]] double unseen_m2(double time_s) const;
    /**
     * Returns the least P and V, with C = 0, of the samples that can be the last ones in the window
     * between two edges, `from` <= `end`.
     */
    [[nodiscard]] DriftVariances least(int from, int end) const;
    /**
     * Returns the bound on sigma in m2 if the iceberg was last seen `age_s` ago and these variances
     * were left.
     */
    [[nodiscard]] double seen_m2(const DriftVariances& least, double age_s) const
    {
        return grown(least, m_process, age_s).position_m2;
    }
    /**
     * Returns a line that is below `seen_m2` at all ages up to `most_s`, and nearest to it about
     * `age_s`.
     */
    [[nodiscard]] FloorLine lineAt(const DriftVariances& least, double age_s, double most_s) const;

private:
    DriftProcess m_process;
    DriftVariances m_given; ///< Variances at time 0.
    /**
     * Least variances of the samples since the edge before, for each edge. An edge without samples
     * has those of the nearest samples.
     */
    std::vector<DriftVariances> m_least;
};

} // namespace berg
