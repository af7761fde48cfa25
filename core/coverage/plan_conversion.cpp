#include "core/coverage/plan_conversion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace berg {

namespace {

/** Sets the available nodes in the order of their first sighting, with its time. */
void orderBySighting(DescribedPlan& described, const UavRequest& request,
                     std::vector<CoverageSighting> sightings)
{
    std::stable_sort(sightings.begin(), sightings.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    std::vector<bool> wanted = request.available;
    for (const CoverageSighting& sighting : sightings) {
        const std::size_t i = toIndex(sighting.iceberg);
        if (!wanted[i])
            continue;
        described.nodes.push_back(nodeOf(sighting.iceberg));
        described.outlook.sightings_s.push_back(request.prediction->time_s + sighting.time_s);
        wanted[i] = false;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i])
            described.nodes.push_back(nodeOf(ModelPlace::of(i)));
}

/**
 * Returns the time of the first sighting that can end the leg. An iceberg in view now comes into
 * view again only after it has left the view, which is hard to predict. With an acceptance radius
 * no sighting ends a leg whose target is in view.
 */
double firstSighting_s(const UavRequest& request, const std::vector<CoverageSighting>& sightings,
                       ModelPlace target, double latest_s)
{
    double near_s = std::numeric_limits<double>::infinity();
    for (const CoverageSighting& sighting : sightings)
        if (request.prediction->reachRadius_m && sighting.iceberg == target)
            near_s = std::min(near_s, sighting.time_s);
    double first_s = latest_s;
    for (const CoverageSighting& sighting : sightings)
        if (request.available[toIndex(sighting.iceberg)] && sighting.time_s < near_s)
            first_s = std::min(first_s, sighting.time_s);
    return first_s;
}

/** Adds the first view of each place of lost icebergs. */
void addSearches(DescribedPlan& described, const CoverageModel& model, const UavRequest& request,
                 std::span<const IcebergIndex> ids, std::vector<CoverageView> views)
{
    std::ranges::stable_sort(views, {}, &CoverageView::enter_s);
    const CoverageState start = model.start();
    for (const CoverageView& view : views) {
        if (!model.isSearched(view.iceberg) ||
            std::ranges::find(described.searched, view.iceberg) != described.searched.end())
            continue;
        const std::size_t iceberg = toIndex(model.icebergAt(view.iceberg));
        const double time_s = request.prediction->time_s + view.enter_s;
        described.searched.push_back(view.iceberg);
        described.outlook.searches.push_back(
            {.iceberg = ids[iceberg],
             .place_m = request.prediction->tracks[iceberg].estimate_m(time_s) +
                        model.offset_m(view.iceberg),
             .time_s = time_s,
             .chance = model.chanceAt(start, view.iceberg)});
    }
}

/** Adds the first visit of each iceberg by the patrol after the legs that end in this state. */
void addFirstOfPatrol(std::vector<CoverageSighting>& sightings, const CoverageModel& model,
                      const CoverageState& state)
{
    if (!model.tail())
        return;
    const double shift_s = model.tail()->shift_s(state.uav, state.time_s);
    for (std::size_t i = 0; i < model.tail()->nextOwn_s.size(); ++i) {
        const double time_s = std::max(state.time_s, model.tail()->nextOwn_s[i] + shift_s);
        if (time_s < model.horizon().length_s)
            sightings.push_back({.iceberg = ModelPlace::of(i), .time_s = time_s});
    }
}

/** Returns the iceberg of a leg; a hold has that of the next leg with one, or of the first. */
ModelPlace placeOf(const CoveragePlan& plan, std::size_t leg)
{
    const auto isAim = [](const CoverageLeg& other) { return !other.isHold(); };
    const auto from = plan.begin() + static_cast<std::ptrdiff_t>(leg);
    const auto next = std::find_if(from, plan.end(), isAim);
    return next != plan.end() ? next->iceberg : firstIceberg(plan).value_or(ModelPlace());
}

} // namespace

DescribedPlan describe(const CoverageModel& model, const UavRequest& request,
                       std::span<const IcebergIndex> ids, const CoveragePlan& plan)
{
    DescribedPlan described;
    std::vector<CoverageSighting> all;
    std::vector<CoverageSighting> onLeg;
    std::vector<CoverageView> views;
    CoverageState state = model.start();
    for (std::size_t k = 0; k < plan.size(); ++k) {
        CoverageLeg leg = plan[k];
        const CoverageModel::Course course = model.course(state, leg);
        onLeg.clear();
        const double stay_s = leg.isHold() ? 0 : std::exchange(leg.stay_s, 0);
        model.fly(state, leg, &onLeg, &views);
        const ModelPlace iceberg = model.icebergAt(placeOf(plan, k));
        described.legs.push_back(
            {.iceberg = ids[toIndex(iceberg)],
             .turn_rad = course.turn.turn_rad,
             .from_m = course.turn.end.position_m,
             .abeam_m = course.abeam_m,
             .sighting_s = request.prediction->time_s +
                           firstSighting_s(request, onLeg, leg.iceberg, state.time_s)});
        if (leg.isHold())
            described.legs.back().end_s = request.prediction->time_s + state.time_s;
        if (stay_s > 0)
            model.fly(state, holdOf(stay_s), &onLeg, &views);
        all.insert(all.end(), onLeg.begin(), onLeg.end());
    }
    addFirstOfPatrol(all, model, state);
    orderBySighting(described, request, std::move(all));
    addSearches(described, model, request, ids, std::move(views));
    described.outlook.until_s = request.prediction->time_s + model.horizon().length_s;
    state.time_s = model.horizon().length_s; // No further sightings are predicted until then.
    described.outlook.zeta_m2s = model.costSoFar_m2s(state);
    return described;
}

namespace {

/** Returns the time at which a UAV's own plan first sees each available iceberg, or infinity. */
std::vector<double> sightingsOf(const DescribedPlan& described, std::size_t icebergs)
{
    std::vector<double> times_s(icebergs, std::numeric_limits<double>::infinity());
    for (std::size_t j = 0; j < described.outlook.sightings_s.size(); ++j)
        times_s[toIndex(placeOf(described.nodes[j]))] = described.outlook.sightings_s[j];
    return times_s;
}

/**
 * Assigns an iceberg to each UAV whose plan sees only the places that it searches. It gets the
 * nearest iceberg that it may have, that no other UAV's plan begins with, and that is not the only
 * one of another UAV. So each UAV is sent out by its plan, unless there are too few icebergs.
 */
void assignToEach(std::vector<std::optional<int>>& owner, std::span<const CoverageModel> models,
                  const PlanRequest& request, std::span<const CoveragePlan> plans)
{
    std::vector<bool> isFirst(owner.size(), false);
    std::vector<int> count(plans.size(), 0);
    for (const std::optional<int>& uav : owner)
        if (uav)
            ++count[static_cast<std::size_t>(*uav)];
    const auto mayLose = [&](const std::optional<int>& uav) {
        return !uav || count[static_cast<std::size_t>(*uav)] > 1;
    };
    for (std::size_t u = 0; u < plans.size(); ++u)
        if (const std::optional<ModelPlace> iceberg = firstIceberg(plans[u]))
            isFirst[toIndex(models[u].icebergAt(*iceberg))] = true;
    for (std::size_t u = 0; u < plans.size(); ++u) {
        const UavRequest& own = request.uavs[u];
        std::optional<std::size_t> nearest;
        bool hasOne = plans[u].empty();
        for (std::size_t k = 0; k < owner.size(); ++k) {
            hasOne = hasOne || (owner[k] == static_cast<int>(u) && own.available[k]);
            if (own.available[k] && !isFirst[k] && mayLose(owner[k]) &&
                (!nearest || own.distance_m(0, static_cast<Eigen::Index>(k) + 1) <
                                 own.distance_m(0, static_cast<Eigen::Index>(*nearest) + 1)))
                nearest = k;
        }
        if (hasOne || !nearest)
            continue;
        std::optional<int>& uav = owner[*nearest];
        if (uav)
            --count[static_cast<std::size_t>(*uav)];
        uav = static_cast<int>(u);
        ++count[u];
        isFirst[*nearest] = true;
    }
}

/** Returns, for each iceberg, the UAV whose order has it; nullopt if no order has it. */
std::vector<std::optional<int>> owners(std::span<const CoverageModel> models,
                                       const PlanRequest& request,
                                       std::span<const CoveragePlan> plans,
                                       const std::vector<std::vector<double>>& sightings_s)
{
    std::vector<std::optional<int>> owner(request.ids.size());
    for (std::size_t k = 0; k < request.ids.size(); ++k)
        for (std::size_t u = 0; u < plans.size(); ++u) {
            if (!request.uavs[u].available[k])
                continue;
            const auto away_m = [&](std::size_t v) {
                return request.uavs[v].distance_m(0, static_cast<Eigen::Index>(k) + 1);
            };
            const auto was = static_cast<std::size_t>(owner[k].value_or(0));
            if (!owner[k] || sightings_s[u][k] < sightings_s[was][k] ||
                (sightings_s[u][k] == sightings_s[was][k] && away_m(u) < away_m(was)))
                owner[k] = static_cast<int>(u);
        }
    for (std::size_t u = 0; u < plans.size(); ++u)
        if (const std::optional<ModelPlace> iceberg = firstIceberg(plans[u]))
            owner[toIndex(models[u].icebergAt(*iceberg))] = static_cast<int>(u);
    assignToEach(owner, models, request, plans);
    return owner;
}

/** Assigns each place to the UAV that has it in view first. */
void shareSearches(std::vector<DescribedPlan>& described)
{
    std::map<ModelPlace, double> first_s;
    for (const DescribedPlan& plan : described)
        for (std::size_t k = 0; k < plan.searched.size(); ++k) {
            const double time_s = plan.outlook.searches[k].time_s;
            const auto known = first_s.emplace(plan.searched[k], time_s).first;
            known->second = std::min(known->second, time_s);
        }
    for (DescribedPlan& plan : described) {
        std::vector<PlannedSearch> own;
        for (std::size_t k = 0; k < plan.searched.size(); ++k)
            if (plan.outlook.searches[k].time_s <= first_s[plan.searched[k]])
                own.push_back(plan.outlook.searches[k]);
        plan.outlook.searches = std::move(own);
    }
}

template <typename IsOwn>
UavPlan answerOf(DescribedPlan described, std::span<const double> sightings_s,
                 const PlanRequest& request, const IsOwn& isOwn)
{
    UavPlan answer{.legs = std::move(described.legs),
                   .outlook = AimedOutlook{.until_s = described.outlook.until_s,
                                           .searches = std::move(described.outlook.searches)}};
    for (const NodeIndex node : described.nodes) {
        const std::size_t k = toIndex(placeOf(node));
        if (!isOwn(k))
            continue;
        answer.order.push_back(request.ids[k]);
        if (std::isfinite(sightings_s[k]))
            answer.outlook->sightings_s.push_back(sightings_s[k]);
    }
    return answer;
}

} // namespace

std::vector<PlannedVisit> laterVisits(const CoverageModel& model, const PlanRequest& request,
                                      const CoveragePlan& plan, std::span<const PatrolVisit> patrol)
{
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan)
        model.fly(state, leg);
    const double shift_s = model.tail()->shift_s(state.uav, state.time_s);
    std::vector<PlannedVisit> visits;
    for (const PatrolVisit& visit : patrol) {
        const double time_s = std::max(state.time_s, visit.time_s + shift_s);
        if (time_s < model.horizon().length_s)
            visits.push_back({.iceberg = request.ids[toIndex(visit.iceberg)],
                              .time_s = request.uavs.front().prediction->time_s + time_s});
    }
    return visits;
}

std::vector<bool> availableToAny(const PlanRequest& request)
{
    std::vector<bool> any(request.ids.size(), false);
    for (const UavRequest& uav : request.uavs)
        for (std::size_t k = 0; k < any.size(); ++k)
            any[k] = any[k] || uav.available[k];
    return any;
}

std::vector<UavPlan> describeFleet(std::span<const CoverageModel> models,
                                   const PlanRequest& request, std::span<const CoveragePlan> plans)
{
    UavRequest own;
    own.available = availableToAny(request);
    std::vector<DescribedPlan> described;
    std::vector<std::vector<double>> sightings_s;
    for (std::size_t u = 0; u < models.size(); ++u) {
        own.prediction = request.uavs[u].prediction;
        described.push_back(describe(models[u], own, request.ids, plans[u]));
        sightings_s.push_back(sightingsOf(described[u], request.ids.size()));
    }
    shareSearches(described);
    const std::vector<std::optional<int>> owner = owners(models, request, plans, sightings_s);
    std::vector<UavPlan> answers;
    for (std::size_t u = 0; u < models.size(); ++u) {
        const auto isOwn = [&](std::size_t k) { return owner[k] == static_cast<int>(u); };
        answers.push_back(answerOf(std::move(described[u]), sightings_s[u], request, isOwn));
    }
    return answers;
}

} // namespace berg
