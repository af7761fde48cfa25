#pragma once

#include "core/bound/true_motion.h"
#include "core/bound/view_cells.h"

#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** A range of the run between two edges of blocks, in which legs begin and end. */
struct EdgeRange
{
    int from = 0;
    int to = 0;
};

/**
 * Lower bounds on the time between having one iceberg in view and having another one in view, in
 * either direction, for any UAV of the scenario. Both instants lie in one range of edges.
 * `frequencyBound` uses them as the distances between visits.
 */
class LegTimes
{
public:
    /**
     * Calculates the times for all pairs. `icebergs` are indices in the scenario; `range.from` must
     * be before `range.to`. A requested stop leaves the object unusable, so callers check the token
     * afterwards.
     */
    LegTimes(const Scenario& scenario, const TrueMotion& motion, std::span<const int> icebergs,
             EdgeRange range, const std::stop_token& stop = {});

    /** Returns the number of icebergs. */
    [[nodiscard]] int size() const { return m_size; }
    /**
     * Returns a lower bound on the time, in seconds and not negative, between views of the icebergs
     * `a` and `b`, which are positions in the list of icebergs.
     */
    [[nodiscard]] double between_s(int a, int b) const
    {
        return m_legs_s[static_cast<std::size_t>(a) * static_cast<std::size_t>(m_size) +
                        static_cast<std::size_t>(b)];
    }

private:
    int m_size;
    std::vector<double> m_legs_s;
};

/**
 * Returns a lower bound on the time, in seconds and not negative, from the start of a UAV to its
 * first view of an iceberg. It holds for views before the edge `to`, which must be positive.
 */
[[nodiscard]] double firstLeg_s(const Scenario& scenario, const TrueMotion& motion, const Uav& uav,
                                int iceberg, int to);

} // namespace berg
