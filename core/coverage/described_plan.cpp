#include "core/coverage/described_plan.h"

#include <algorithm>

namespace berg {

namespace {

/** The available nodes in that order, and the times of the sightings there are. */
void orderBySighting(DescribedPlan& described, const UavRequest& request,
                     std::vector<CoverageSighting> sightings)
{
    std::stable_sort(sightings.begin(), sightings.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    std::vector<bool> wanted = request.available;
    for (const CoverageSighting& sighting : sightings) {
        const auto i = static_cast<std::size_t>(sighting.iceberg);
        if (!wanted[i])
            continue;
        described.nodes.push_back(sighting.iceberg + 1);
        described.outlook.sightings_s.push_back(request.picture->time_s + sighting.time_s);
        wanted[i] = false;
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i])
            described.nodes.push_back(static_cast<int>(i) + 1);
}

/** An iceberg in view now comes into view again only if it leaves it, which is hard to predict. */
double firstSighting_s(const UavRequest& request, const std::vector<CoverageSighting>& sightings,
                       double latest_s)
{
    double first_s = latest_s;
    for (const CoverageSighting& sighting : sightings)
        if (request.available[static_cast<std::size_t>(sighting.iceberg)])
            first_s = std::min(first_s, sighting.time_s);
    return first_s;
}

} // namespace

DescribedPlan describe(const CoverageModel& model, const UavRequest& request,
                       std::span<const int> ids, const CoveragePlan& plan)
{
    DescribedPlan described;
    std::vector<CoverageSighting> all;
    std::vector<CoverageSighting> onLeg;
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan) {
        const CoverageModel::Course course = model.course(state, leg);
        onLeg.clear();
        model.fly(state, leg, &onLeg);
        described.legs.push_back({.iceberg = ids[static_cast<std::size_t>(leg.iceberg)],
                                  .turn_rad = course.turn.turn_rad,
                                  .from_m = course.turn.end.position_m,
                                  .abeam_m = course.abeam_m,
                                  .sighting_s = request.picture->time_s +
                                                firstSighting_s(request, onLeg, state.time_s)});
        all.insert(all.end(), onLeg.begin(), onLeg.end());
    }
    orderBySighting(described, request, std::move(all));
    described.outlook.until_s = request.picture->time_s + model.horizon().length_s;
    state.time_s = model.horizon().length_s; // until then nothing else is seen
    described.outlook.zeta_m2s = model.costSoFar_m2s(state);
    return described;
}

} // namespace berg
