#include "widgets/panels/plan_rows.h"

#include <algorithm>
#include <utility>

namespace berg {
namespace {

QString nameOf(const Iceberg& iceberg)
{
    return QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name);
}

PlanForecast forecastOf(const MissionSnapshot& now, const Scenario& scenario)
{
    return forecastPlan(forecastStart(now), now.plan->order,
                        std::max(0.0, scenario.duration_s - now.time_s), now.plan->clusters);
}

/** What the row says of the iceberg as it is now. */
PlanRow rowOf(const MissionSnapshot& now, int iceberg)
{
    const auto index = static_cast<std::size_t>(iceberg);
    return {.id = now.icebergs[index].id,
            .name = nameOf(now.icebergs[index]),
            .sigma_m2 = now.world.tracks[index].sigma_m2};
}

std::vector<PlanRow> straightRows(const MissionSnapshot& now, const Scenario& scenario)
{
    std::vector<PlanRow> rows;
    for (const ForecastVisit& visit : forecastOf(now, scenario).visits) {
        PlanRow& row = rows.emplace_back(rowOf(now, visit.iceberg));
        row.leg_m = visit.leg_m;
        row.arrival_s = visit.arrival_s;
        row.arrivalSigma_m2 = visit.arrivalSigma_m2;
    }
    return rows;
}

/** What comes after the way home has no times yet. */
void leaveForNextSortie(std::vector<PlanRow>& rows, const PlanEvent& plan)
{
    const auto flown = static_cast<std::size_t>(
        std::max(0, plan.thisSortie.value_or(static_cast<int>(rows.size()))));
    for (std::size_t k = flown; k < rows.size(); ++k) {
        PlanRow& row = rows[k];
        row.isSeen = false;
        row.leg_m = row.arrival_s = row.arrivalSigma_m2 = 0;
    }
}

std::vector<PlanRow> aimedRows(const MissionSnapshot& now)
{
    const std::vector<AimedWay> ways = waysAhead(now);
    const std::vector<double>& sightings_s = now.plan->outlook->sightings_s;
    std::vector<PlanRow> rows;
    double before_m = 0;
    for (std::size_t k = 0; k < now.plan->order.size(); ++k) {
        const int iceberg = now.plan->order[k];
        PlanRow& row = rows.emplace_back(rowOf(now, iceberg));
        row.isSeen = k < sightings_s.size();
        if (!row.isSeen)
            continue;
        const double way_m = lengthUntil_m(ways, sightings_s[k]);
        const Track& track = now.world.tracks[static_cast<std::size_t>(iceberg)];
        row.leg_m = way_m - std::exchange(before_m, way_m);
        row.arrival_s = std::max(0.0, sightings_s[k] - now.time_s);
        row.arrivalSigma_m2 = track.sigmaAfter_m2(row.arrival_s);
    }
    return rows;
}

PlanOutlook aimedOutlook(const MissionSnapshot& shown, const Scenario& scenario)
{
    constexpr double kRounding_s = 1e-6; // times are whole steps
    const AimedOutlook& aimed = *shown.plan->outlook;
    PlanOutlook outlook{.zeta_m2s = shown.plan->zeta_m2s + aimed.zeta_m2s, .isAimed = true};
    if (aimed.until_s < scenario.duration_s - kRounding_s)
        outlook.until_s = aimed.until_s;
    else if (shown.time_s > aimed.until_s - kRounding_s)
        outlook.zeta_m2s = shown.metrics.zeta_m2s; // flown
    return outlook;
}

/** Beside a prediction for a time before the end only when the whole curve is known. */
void addBound(PlanOutlook& outlook, const KnownBound& bound)
{
    if (bound.zeta_m2s <= 0 || (outlook.until_s && !bound.whole))
        return;
    outlook.bound_m2s = outlook.until_s ? bound.whole->by_m2s(*outlook.until_s) : bound.zeta_m2s;
    outlook.boundShare = bound.share;
}

std::optional<PlanOutlook> predictedOutlook(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    if (!shown.plan || record.scenario.uavs.empty())
        return std::nullopt;
    if (shown.plan->outlook)
        return aimedOutlook(shown, record.scenario);
    if (!shown.plan->legs.empty())
        return std::nullopt; // straight legs would foretell too much
    PlanOutlook outlook{.zeta_m2s =
                            shown.metrics.zeta_m2s + forecastOf(shown, record.scenario).zeta_m2s};
    const std::optional<ShownChange> change = record.changeShown();
    if (change && change->ways.empty()) { // else straight legs are no measure of the plan before
        outlook.change = change->change;
        outlook.changed_s = change->time_s;
        for (const int iceberg : change->change.before)
            outlook.before << nameOf(shown.icebergs[static_cast<std::size_t>(iceberg)]);
    }
    return outlook;
}

} // namespace

std::vector<PlanRow> planRows(const MissionSnapshot& now, const Scenario& scenario)
{
    if (!now.plan || scenario.uavs.empty())
        return {};
    std::vector<PlanRow> rows = now.plan->outlook ? aimedRows(now) : straightRows(now, scenario);
    leaveForNextSortie(rows, *now.plan);
    return rows;
}

std::optional<PlanOutlook> planOutlook(const FlightRecord& record)
{
    std::optional<PlanOutlook> outlook = predictedOutlook(record);
    if (outlook)
        addBound(*outlook, record.boundOfFlight());
    return outlook;
}

} // namespace berg
