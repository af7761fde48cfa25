#include "core/coverage/described_plan.h"

#include <algorithm>

namespace berg {

namespace {

std::vector<int> nodesBySighting(const PlanRequest& request,
                                 std::vector<CoverageSighting> sightings)
{
    std::stable_sort(sightings.begin(), sightings.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    const int count = static_cast<int>(request.ids.size());
    for (int i = 0; i < count; ++i)
        sightings.push_back({.iceberg = i});
    std::vector<bool> wanted = request.available;
    std::vector<int> nodes;
    for (const CoverageSighting& sighting : sightings) {
        const auto i = static_cast<std::size_t>(sighting.iceberg);
        if (wanted[i])
            nodes.push_back(sighting.iceberg + 1);
        wanted[i] = false;
    }
    return nodes;
}

/** An iceberg in view now comes into view again only if it leaves it, which is hard to predict. */
double firstSighting_s(const PlanRequest& request, const std::vector<CoverageSighting>& sightings,
                       double latest_s)
{
    double first_s = latest_s;
    for (const CoverageSighting& sighting : sightings)
        if (request.available[static_cast<std::size_t>(sighting.iceberg)])
            first_s = std::min(first_s, sighting.time_s);
    return first_s;
}

} // namespace

DescribedPlan describe(const CoverageModel& model, const PlanRequest& request,
                       const CoveragePlan& plan)
{
    DescribedPlan described;
    std::vector<CoverageSighting> all;
    std::vector<CoverageSighting> onLeg;
    CoverageState state = model.start();
    for (const CoverageLeg& leg : plan) {
        const CoverageModel::Course course = model.course(state, leg);
        onLeg.clear();
        model.fly(state, leg, &onLeg);
        described.legs.push_back({.iceberg = request.ids[static_cast<std::size_t>(leg.iceberg)],
                                  .turn_rad = course.turn.turn_rad,
                                  .from_m = course.turn.end.position_m,
                                  .abeam_m = course.abeam_m,
                                  .sighting_s = request.picture->time_s +
                                                firstSighting_s(request, onLeg, state.time_s)});
        all.insert(all.end(), onLeg.begin(), onLeg.end());
    }
    described.nodes = nodesBySighting(request, std::move(all));
    return described;
}

} // namespace berg
