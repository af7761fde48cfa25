#pragma once

#include "core/sim/simulation.h"

#include <functional>
#include <optional>
#include <span>

namespace berg {

/** Assigns one iceberg to one UAV, which alone may visit it. */
struct Assignment
{
    std::string iceberg; ///< iceberg id
    std::string uav;     ///< UAV id; empty means any UAV
    bool operator==(const Assignment&) const = default;
};

/** An operator's order to one UAV. */
struct UavCommand
{
    std::string uav; ///< UAV id
    FlightOrder order = FlightOrder::None;
    bool operator==(const UavCommand&) const = default;
};

/** Moves the home of one UAV, as a ship carries it. */
struct HomeMove
{
    std::string uav; ///< UAV id
    Point place_m = Point::Zero();
    bool operator==(const HomeMove&) const = default;
};

/**
 * A change made in flight. The run file stores it and a replay applies it again. Members without a
 * value change nothing.
 */
struct Intervention
{
    double time_s = 0; ///< run time of the change, s
    std::optional<double> tau;
    std::optional<PolicyKind> policy;
    std::optional<Point> wind_mps; ///< wind over ground from now on
    /** Protected asset from now on; its position is the one at time 0. */
    std::optional<Asset> asset;
    std::optional<Iceberg> appears;     ///< new iceberg that appears now
    std::optional<std::string> seen;    ///< id of an iceberg that somebody else has sighted
    double seenAge_s = 0;               ///< age of that sighting, s
    std::optional<std::string> removed; ///< id of an iceberg to monitor no longer
    std::optional<Assignment> assigned;
    std::optional<UavCommand> commanded;
    std::optional<HomeMove> home; ///< the UAV lands there from now on
    std::string extraJson = {};   ///< unknown members of its object in the run file
    bool operator==(const Intervention&) const = default;
};

/** The last group of interventions that were made together: of one kind and at one instant. */
struct LastChange
{
    Intervention first;     ///< first of them
    std::size_t before = 0; ///< number of interventions before `first`
};

/** Returns the last change among a mission's interventions, or nullopt if there are none. */
[[nodiscard]] std::optional<LastChange> lastChangeOf(std::span<const Intervention> interventions);

/** Returns `settings` with the tau and policy of the intervention, where it has them. */
[[nodiscard]] PlannerSettings withChanges(PlannerSettings settings,
                                          const Intervention& intervention);

/** Which icebergs an intervention may name at its time, by id. */
struct NameableIcebergs
{
    std::function<bool(const std::string&)> isMonitored;
    std::function<bool(const std::string&)> isRemovable; ///< it may have left the area already
};

/** Returns an error for each iceberg and UAV that the intervention names but that is not there. */
[[nodiscard]] std::vector<Issue> unknownNames(const Intervention& intervention,
                                              const std::vector<Uav>& uavs,
                                              const NameableIcebergs& icebergs);

/** Returns the index of the UAV with this id, or nullopt if there is none. */
[[nodiscard]] std::optional<int> indexOfId(const std::vector<Uav>& uavs, const std::string& id);
/** Returns the index of the iceberg with this id, or nullopt if there is none. */
[[nodiscard]] std::optional<IcebergIndex> indexOfId(const std::vector<Iceberg>& icebergs,
                                                    const std::string& id);

/**
 * Applies the intervention to the simulation, in flight and when an earlier instant is restored; no
 * other code does so. Its ids must exist (`unknownNames`). `icebergs` are the
 * mission's, by index, and `uavs` the scenario's.
 */
void apply(const Intervention& intervention, Simulation& world,
           const std::vector<Iceberg>& icebergs, const std::vector<Uav>& uavs);

} // namespace berg
