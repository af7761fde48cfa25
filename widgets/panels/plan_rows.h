#pragma once

#include "widgets/model/mission_runner.h"

#include <QString>

#include <string>
#include <vector>

namespace berg {

/** One iceberg of the plan, in visiting order. */
struct PlanRow
{
    std::string id;
    QString name;         ///< never empty: the id where there is no name
    double leg_m = 0;     ///< over ground, from the one before or the UAV
    double arrival_s = 0; ///< from now
    double sigma_m2 = 0;  ///< now
    bool operator==(const PlanRow&) const = default;
};

/**
 * The present plan with the estimates of this instant, all taken to stand still: straight legs
 * flown at the airspeed of the first UAV in the scenario's wind. Empty without a plan.
 */
[[nodiscard]] std::vector<PlanRow> planRows(const MissionSnapshot& now, const Scenario& scenario);

} // namespace berg
