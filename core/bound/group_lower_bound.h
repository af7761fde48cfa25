#pragma once

#include "core/bound/chain_costs.h"
#include "core/bound/sigma_floor.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/**
 * The part of the run that a call of `GroupLowerBound::raise` bounds, as the blocks from `begin` to
 * before `end`. Flights are considered from the edge `from` <= `begin` on; edge 0 is the start of
 * the run.
 */
struct BoundWindow
{
    int from = 0;
    int begin = 0;
    int end = 0;
    double age_s = 0; ///< At this age the lines of measured icebergs are closest to their floors.
};

/**
 * A lower bound of the sum of sigma over some icebergs in each block of the run, for any flight of
 * the UAVs. A call of `raise` never lowers the bound, which is valid before and after each call.
 * The scenario, motion and floors are borrowed. `zetaLowerBound` explains the method.
 */
class GroupLowerBound
{
public:
    /**
     * Starts with a bound of 0 in every block. `icebergs` are at most 16 indices in the scenario.
     * `floors` has one entry per iceberg with measurements and is empty in the simple model, where
     * sigma is linear in the age.
     */
    GroupLowerBound(const Scenario& scenario, const TrueMotion& motion,
                    const std::vector<SigmaFloor>& floors, std::vector<int> icebergs);

    /**
     * Raises the bound in the blocks of one window, with `perRegion` cells (a multiple of 4) for
     * each iceberg. Leaves some or all blocks unchanged if the work limit or a stop ends the call.
     * Changes nothing if no iceberg has appeared by the window's first step.
     */
    void raise(const BoundWindow& window, int perRegion, WorkMeter& meter);

    /** Returns the lower bound on the sum of sigma in each block of the run, in m2. */
    [[nodiscard]] const std::vector<double>& floor_m2() const { return m_floor_m2; }
    /**
     * Returns the mean radius of the icebergs' tracks in a window, in a frame that moves with their
     * mean velocity, divided by the reach of the first UAV's view; 0 without icebergs.
     */
    [[nodiscard]] double spread(const BoundWindow& window) const;
    /** Returns the largest work that `raise` with these arguments may spend. */
    [[nodiscard]] std::int64_t workOf(const BoundWindow& window, int perRegion) const;
    /**
     * Returns the mean age of the last sightings in seconds, weighted by the growth of sigma, when
     * that is as recent as it can be; the largest of all windows raised so far.
     */
    [[nodiscard]] double meanAge_s() const { return m_meanAge_s; }

private:
    /** Sigma of icebergs that have been out of view since the window began, as base + rate t. */
    struct Unseen
    {
        double base_m2 = 0;
        double rate_m2ps = 0;
    };
    /**
     * For each set of icebergs last seen, the sigma that has grown plus `perSecond` for each second
     * since the start.
     */
    struct WeightedChains
    {
        double perSecond = 0;
        std::vector<double> cost_m2;
    };
    /** Bounds on the paths of one UAV that have seen each set by their end. */
    struct Chains
    {
        /** Least times to see each set; the vector is empty if the start does not matter. */
        std::vector<double> soonest_s;
        std::vector<WeightedChains> priced;
    };

    /** Returns the icebergs of the group that have appeared by the first step of the window. */
    [[nodiscard]] std::vector<int> present(const BoundWindow& window) const;
    /** Returns the mean velocity of the icebergs between the first and last edge of the window. */
    [[nodiscard]] Point meanVelocity_mps(const std::vector<int>& icebergs,
                                         const BoundWindow& window) const;
    /**
     * Returns a region that holds all positions of the UAV with an iceberg of the enclosure in
     * view.
     */
    [[nodiscard]] ViewRegion region(const Circle& enclosure, const Uav& uav) const;
    [[nodiscard]] double growth_m2ps(int iceberg) const;
    /** Returns, for each iceberg, a line below sigma as a function of the age. */
    [[nodiscard]] std::vector<FloorLine> linesOf(const std::vector<int>& icebergs,
                                                 const BoundWindow& window) const;
    /**
     * Returns the chains of each UAV, or nullopt if the work limit or a stop ends the calculation.
     */
    [[nodiscard]] std::optional<std::vector<Chains>>
    chainsOf(const std::vector<int>& icebergs, const std::vector<FloorLine>& lines,
             const BoundWindow& window, int perRegion, WorkMeter& meter) const;
    /** Adds the times and costs of reaching each set from the start. */
    static void reachFromStart(Chains& chains, const ViewCells& cells, const Point& start_m,
                               StageCost price, WorkMeter& meter);
    /** Sets the costs of icebergs in view at the start to 0: no edge was crossed. */
    static void seeAtStart(Chains& chains, const std::vector<ViewRegion>& regions,
                           const Point& start_m);
    /**
     * Returns the least cost of having seen each set by a time, for one UAV; it is infinite if the
     * UAV cannot. Without a time the start does not matter.
     */
    [[nodiscard]] static std::vector<double> seenBy(const Chains& chains,
                                                    std::optional<double> time_s);
    /**
     * Returns the least cost for all UAVs together, where each iceberg is last seen by one of them.
     * The result is unusable after the work limit.
     */
    [[nodiscard]] static std::vector<double>
    sharedOut(const std::vector<Chains>& chains, std::optional<double> time_s, WorkMeter& meter);
    /** Returns the number of blocks that share one call of `sharedOut`. */
    [[nodiscard]] int blocksPerPart(const BoundWindow& window) const;
    /** Returns, for each set of icebergs that has been seen, the sigma of all others. */
    [[nodiscard]] std::vector<Unseen> unseenSets(const std::vector<int>& icebergs,
                                                 bool sinceStart) const;
    /**
     * For measured icebergs, applies the offsets and least values of the lines to the cost of each
     * set, and adds the sigma of the other icebergs, which are unseen since the window began.
     */
    void addOthers(std::vector<double>& cost_m2, const std::vector<int>& icebergs,
                   const std::vector<FloorLine>& lines, const BoundWindow& window,
                   double first_s) const;
    /** Raises the bound of each block of the window by the least cost over all sets. */
    void raiseBlocks(const BoundWindow& window, const std::vector<int>& icebergs,
                     const std::vector<FloorLine>& lines, const std::vector<Chains>& chains,
                     WorkMeter& meter);

    const Scenario& m_scenario;
    const TrueMotion& m_motion;
    const std::vector<SigmaFloor>& m_floors;
    std::vector<int> m_icebergs;
    std::vector<double> m_floor_m2; ///< Bound in each block.
    double m_meanAge_s = 0;
};

} // namespace berg
