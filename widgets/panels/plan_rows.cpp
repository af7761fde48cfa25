#include "widgets/panels/plan_rows.h"

#include <algorithm>

namespace berg {
namespace {

QString nameOf(const Iceberg& iceberg)
{
    return QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name);
}

PlanForecast forecastOf(const MissionSnapshot& now, const Scenario& scenario)
{
    return forecastPlan(forecastStart(now, scenario), now.plan->order,
                        std::max(0.0, scenario.duration_s - now.time_s));
}

} // namespace

std::vector<PlanRow> planRows(const MissionSnapshot& now, const Scenario& scenario)
{
    std::vector<PlanRow> rows;
    if (!now.plan || scenario.uavs.empty())
        return rows;
    for (const ForecastVisit& visit : forecastOf(now, scenario).visits) {
        const auto index = static_cast<std::size_t>(visit.iceberg);
        rows.push_back({.id = now.icebergs[index].id,
                        .name = nameOf(now.icebergs[index]),
                        .leg_m = visit.leg_m,
                        .arrival_s = visit.arrival_s,
                        .sigma_m2 = now.world.tracks[index].sigma_m2,
                        .arrivalSigma_m2 = visit.arrivalSigma_m2});
    }
    return rows;
}

std::optional<PlanOutlook> planOutlook(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    if (!shown.plan || record.scenario.uavs.empty())
        return std::nullopt;
    if (!shown.plan->legs.empty())
        return std::nullopt; // passes icebergs at an offset: straight legs foretell too much
    PlanOutlook outlook{.zeta_m2s =
                            shown.metrics.zeta_m2s + forecastOf(shown, record.scenario).zeta_m2s};
    if (const std::optional<ShownChange> change = record.changeShown()) {
        outlook.change = change->change;
        outlook.changed_s = change->time_s;
        for (const int iceberg : change->change.before)
            outlook.before << nameOf(shown.icebergs[static_cast<std::size_t>(iceberg)]);
    }
    return outlook;
}

} // namespace berg
