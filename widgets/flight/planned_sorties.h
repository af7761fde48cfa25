#pragma once

#include "core/mission/sortie_outlook.h"
#include "widgets/flight/mission_snapshot.h"

namespace berg {

/**
 * Returns the path that each UAV is planned to fly from this instant on; nullopt if it returns home
 * or stands there, has no plan, or has one with aim points.
 */
[[nodiscard]] std::vector<std::optional<PlannedPath>> plannedPaths(const MissionSnapshot& now,
                                                                   const Scenario& scenario);

/** Forecast of a UAV's sortie for the operator. */
struct PlannedSortie
{
    SortieOutlook outlook;
    std::optional<double> lowMargin_s;
    /** Latest time home in its recovery slot, s; nullopt if it needs no slot. */
    std::optional<double> slot_s = {};
    std::string uav = {}; ///< name of the UAV, or its id if it has none
};

/** Returns the planned sortie of each UAV; nullopt where `plannedPaths` has none. */
[[nodiscard]] std::vector<std::optional<PlannedSortie>> plannedSorties(const MissionSnapshot& now,
                                                                       const Scenario& scenario);

/** Returns the sorties with a recovery slot, in order of landing. */
[[nodiscard]] std::vector<PlannedSortie>
landingOrder(const std::vector<std::optional<PlannedSortie>>& sorties);

} // namespace berg
