#pragma once

#include "core/bound/chain_costs.h"
#include "core/bound/sigma_floor.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** Which part of the run is bounded (blocks from `begin` to before `end`) and from where on flights
 * are looked at for it: `from` <= `begin`; 0 is the start. */
struct BoundWindow
{
    int from = 0;
    int begin = 0;
    int end = 0;
    double age_s = 0; ///< at which the floors of measured icebergs are taken most truly
};

/**
 * A lower bound of the sum of sigma over some icebergs in each block of the run, for any flight of
 * the UAVs.
 * Every call of `raise` can only raise it, and it is valid before and after each.
 */
class GroupFloor
{
public:
    /** At most 16 icebergs, by index in the scenario. `floors`: of all measured ones; empty in the
     * simple model, where sigma is linear in the age. */
    GroupFloor(const Scenario& scenario, const TrueMotion& motion,
               const std::vector<SigmaFloor>& floors, std::vector<int> icebergs);

    /**
     * Looks at one window with `perRegion` cells for each iceberg. Does nothing when the work is
     * not to be done.
     */
    void raise(const BoundWindow& window, int perRegion, WorkMeter& meter);

    [[nodiscard]] const std::vector<double>& floor_m2() const { return m_floor_m2; }
    /** How far an iceberg gets from the middle of its way in a window, over the reach of the view.
     */
    [[nodiscard]] double spread(const BoundWindow& window) const;
    /** Work of `raise`. */
    [[nodiscard]] std::int64_t workOf(const BoundWindow& window, int perRegion) const;
    /**
     * The largest, over the windows looked at, of how long ago icebergs were last seen on average
     * (weighted by q) when that is as recent as it can be. s
     */
    [[nodiscard]] double meanAge_s() const { return m_meanAge_s; }

private:
    /** What a set of icebergs costs that are out of view since the window began: base + rate t. */
    struct Unseen
    {
        double base_m2 = 0;
        double rate_m2ps = 0;
    };
    /** Sigma grown plus `perSecond` for each second since the start, by set last seen. */
    struct PricedChains
    {
        double perSecond = 0;
        std::vector<double> cost_m2;
    };
    /** What is known of the ways of one UAV that end having seen each set. */
    struct Chains
    {
        std::vector<double> soonest_s; ///< empty: the start does not matter
        std::vector<PricedChains> priced;
    };

    [[nodiscard]] std::vector<int> present(const BoundWindow& window) const;
    [[nodiscard]] Point meanVelocity_mps(const std::vector<int>& icebergs,
                                         const BoundWindow& window) const;
    [[nodiscard]] ViewRegion region(const Circle& enclosure, const Uav& uav) const;
    [[nodiscard]] double growth_m2ps(int iceberg) const;
    /** By iceberg, from the age since it was last seen. */
    [[nodiscard]] std::vector<FloorLine> linesOf(const std::vector<int>& icebergs,
                                                 const BoundWindow& window) const;
    /** By UAV. */
    [[nodiscard]] std::optional<std::vector<Chains>>
    chainsOf(const std::vector<int>& icebergs, const std::vector<FloorLine>& lines,
             const BoundWindow& window, int perRegion, WorkMeter& meter) const;
    /** Adds what it takes to be there in time. */
    static void reachFromStart(Chains& chains, const ViewCells& cells, const Point& start_m,
                               ChainPrice price, WorkMeter& meter);
    /** What is in view at the start and ever since costs nothing: no edge was crossed. */
    static void seeAtStart(Chains& chains, const std::vector<ViewRegion>& regions,
                           const Point& start_m);
    /** By set: what it costs one UAV to have seen it by then; infinite when it cannot. Without a
     * time: when the start does not matter. */
    [[nodiscard]] static std::vector<double> seenBy(const Chains& chains,
                                                    std::optional<double> time_s);
    /** The same for all UAVs together, each iceberg being seen last by one of them. Of no use when
     * the work is not to be done any more. */
    [[nodiscard]] static std::vector<double>
    sharedOut(const std::vector<Chains>& chains, std::optional<double> time_s, WorkMeter& meter);
    /** For so many blocks `sharedOut` is asked for once. */
    [[nodiscard]] int blocksPerLook(const BoundWindow& window) const;
    [[nodiscard]] std::vector<Unseen> unseenSets(const std::vector<int>& icebergs,
                                                 bool sinceStart) const;
    /** Adds to the cost of each set's chain what the floors of its icebergs add, and what the other
     * icebergs cost, unseen since the window began. */
    void addOthers(std::vector<double>& cost_m2, const std::vector<int>& icebergs,
                   const std::vector<FloorLine>& lines, const BoundWindow& window,
                   double first_s) const;
    void raiseBlocks(const BoundWindow& window, const std::vector<int>& icebergs,
                     const std::vector<FloorLine>& lines, const std::vector<Chains>& chains,
                     WorkMeter& meter);

    const Scenario& m_scenario;
    const TrueMotion& m_motion;
    const std::vector<SigmaFloor>& m_floors;
    std::vector<int> m_icebergs;
    std::vector<double> m_floor_m2; ///< by block
    double m_meanAge_s = 0;
};

} // namespace berg
