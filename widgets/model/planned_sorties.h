#pragma once

#include "core/sim/sortie_outlook.h"
#include "widgets/model/mission_snapshot.h"

namespace berg {

/**
 * By UAV, what it is planned to fly from this instant on; none: it goes home or stands there, has
 * no plan, or one with aim points.
 */
[[nodiscard]] std::vector<std::optional<PlannedPath>> plannedPaths(const MissionSnapshot& now,
                                                                   const Scenario& scenario);

struct PlannedSortie
{
    SortieOutlook outlook;
    std::optional<double> lowMargin_s;
    std::optional<double> slot_s =
        {};               ///< home by then, in its recovery slot; none: it needs no slot
    std::string uav = {}; ///< its name, else its id
};

/** The same in what an operator must know of it, by UAV. */
[[nodiscard]] std::vector<std::optional<PlannedSortie>> plannedSorties(const MissionSnapshot& now,
                                                                       const Scenario& scenario);

/** Those with a recovery slot, the first to land first. */
[[nodiscard]] std::vector<PlannedSortie>
landingOrder(const std::vector<std::optional<PlannedSortie>>& sorties);

} // namespace berg
