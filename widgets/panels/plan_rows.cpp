#include "widgets/panels/plan_rows.h"

#include "core/vehicle/dubins.h"

#include <algorithm>

namespace berg {

std::vector<PlanRow> planRows(const MissionSnapshot& now, const Scenario& scenario)
{
    std::vector<PlanRow> rows;
    if (!now.plan || scenario.uavs.empty())
        return rows;
    const double airspeed_mps = scenario.uavs.front().spec.airspeed_mps;
    Point from_m = now.world.uav.position_m;
    double arrival_s = 0;
    for (const int iceberg : now.plan->order) {
        const auto index = static_cast<std::size_t>(iceberg);
        require(iceberg >= 0 && index < now.icebergs.size() && index < now.world.tracks.size(),
                "plan names an iceberg that is not there");
        const Iceberg& planned = now.icebergs[index];
        const Track& track = now.world.tracks[index];
        const Point to_m = track.estimate_m(now.time_s);
        const Point leg_m = to_m - from_m;
        arrival_s += flightTime_s(leg_m, airspeed_mps, scenario.wind_mps);
        rows.push_back(
            {.id = planned.id,
             .name = QString::fromStdString(planned.name.empty() ? planned.id : planned.name),
             .leg_m = leg_m.norm(),
             .arrival_s = arrival_s,
             .sigma_m2 = track.sigma_m2,
             .arrivalSigma_m2 = track.sigma_m2 + track.q_m2ps * arrival_s}); // Eq. (22)
        from_m = to_m;
    }
    return rows;
}

std::optional<double> planChange_m(const FlightRecord& record)
{
    const std::vector<PlanEvent>& plans = record.history.plans;
    const std::size_t count = std::min(record.shown().planCount, plans.size());
    if (count < 2)
        return std::nullopt;
    return plans[count - 1].distance_m - plans[count - 2].distance_m;
}

} // namespace berg
