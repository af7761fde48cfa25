#pragma once

#include "core/sim/simulation.h"

#include <algorithm>

namespace berg {

/** One iceberg and the UAV that alone is to visit it. */
struct Assignment
{
    std::string iceberg; ///< id
    std::string uav;     ///< id; empty: any may
    bool operator==(const Assignment&) const = default;
};

/** What one UAV is told to do. */
struct UavCommand
{
    std::string uav; ///< id
    FlightOrder order = FlightOrder::None;
    bool operator==(const UavCommand&) const = default;
};

/** A change made in flight, replayed from the run file. Empty members change nothing. */
struct Intervention
{
    double time_s = 0;
    std::optional<double> tau;
    std::optional<PolicyKind> policy;
    std::optional<Point> wind_mps;      ///< from now on
    std::optional<Asset> asset;         ///< protected from now on; its position is that at time 0
    std::optional<Iceberg> appears;     ///< a new iceberg, here and now
    std::optional<std::string> seen;    ///< id of one that somebody else sees now, or saw
    double seenAge_s = 0;               ///< so long ago
    std::optional<std::string> removed; ///< id of one that is none, or is not to be watched
    std::optional<Assignment> assigned;
    std::optional<UavCommand> commanded;
    std::string extraJson = {}; ///< members of its object in the file that are not known
    bool operator==(const Intervention&) const = default;
};

/** The settings with those that the intervention changes. */
[[nodiscard]] PlannerSettings withChanges(PlannerSettings settings,
                                          const Intervention& intervention);

/** -1: there is none of that id. */
template <class Entry>
[[nodiscard]] int indexOfId(const std::vector<Entry>& entries, const std::string& id)
{
    const auto it = std::ranges::find(entries, id, &Entry::id);
    return it == entries.end() ? -1 : static_cast<int>(it - entries.begin());
}

/**
 * Changes the world: the one place where that is done, in flight and when looking back. The
 * intervention fits it (`Mission::intervene` checks). `icebergs` are those of the mission, by
 * index; `uavs` those of the scenario.
 */
void apply(const Intervention& intervention, Simulation& world,
           const std::vector<Iceberg>& icebergs, const std::vector<Uav>& uavs);

} // namespace berg
