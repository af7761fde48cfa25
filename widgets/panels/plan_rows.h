#pragma once

#include "widgets/model/flight_record.h"

#include <QString>

#include <string>
#include <vector>

namespace berg {

/** One iceberg of the plan, in visiting order. */
struct PlanRow
{
    std::string id;
    QString name;               ///< never empty: the id where there is no name
    double leg_m = 0;           ///< over ground, from the one before or the UAV
    double arrival_s = 0;       ///< from now
    double sigma_m2 = 0;        ///< now
    double arrivalSigma_m2 = 0; ///< when the UAV is there, unless it is seen on the way
    bool operator==(const PlanRow&) const = default;
};

/**
 * The present plan with the estimates of this instant, all taken to stand still: straight legs
 * flown at the airspeed of the first UAV in the scenario's wind. Empty without a plan.
 */
[[nodiscard]] std::vector<PlanRow> planRows(const MissionSnapshot& now, const Scenario& scenario);

/**
 * By how much the plan shown is longer than the one it took the place of in flight, m: each as long
 * as it was when it was made. None before there are two.
 */
[[nodiscard]] std::optional<double> planChange_m(const FlightRecord& record);

} // namespace berg
