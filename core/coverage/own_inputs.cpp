#include "core/coverage/own_inputs.h"

#include <limits>

namespace berg {

namespace {

/** Returns the UAV nearest to the iceberg, which is taken to have it in view. */
std::size_t viewerOf(const PlanRequest& request, std::size_t iceberg)
{
    std::size_t nearest = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t u = 0; u < request.uavs.size(); ++u) {
        const PredictionInput& input = *request.uavs[u].prediction;
        const Point place_m = input.tracks[iceberg].estimate_m(input.time_s);
        const double away_m = (place_m - input.uav.position_m).norm();
        if (away_m < nearest_m) {
            nearest = u;
            nearest_m = away_m;
        }
    }
    return nearest;
}

bool isInViewOf(const PredictionInput& input, std::size_t iceberg)
{
    return FieldOfView(input.sensor, input.uav.position_m, input.uav.psi_rad)
        .contains(input.tracks[iceberg].estimate_m(input.time_s));
}

/** Makes the places of lost icebergs known to all UAVs, whoever may search there. */
void sharePlaces(std::vector<PredictionInput>& inputs)
{
    std::vector<std::vector<SearchPlace>>& all = inputs.front().places;
    for (const PredictionInput& input : inputs)
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].empty())
                all[i] = input.places[i];
    for (PredictionInput& input : inputs)
        input.places = all;
}

} // namespace

std::vector<PredictionInput> ownInputs(const PlanRequest& request)
{
    std::vector<PredictionInput> own;
    for (const UavRequest& uav : request.uavs) {
        require(uav.prediction != nullptr, "CoveragePolicy: a UAV has no input of its flight");
        own.push_back(*uav.prediction);
    }
    for (std::size_t i = 0; i < request.ids.size(); ++i) {
        if (!own.front().tracks[i].inView)
            continue;
        bool isClear = false;
        for (PredictionInput& input : own) {
            input.tracks[i].inView = isInViewOf(input, i);
            isClear = isClear || input.tracks[i].inView;
        }
        if (!isClear)
            own[viewerOf(request, i)].tracks[i].inView = true;
    }
    sharePlaces(own);
    return own;
}

std::vector<CoverageModel> modelsOf(std::span<const PredictionInput> inputs,
                                    CoverageHorizon horizon)
{
    std::vector<CoverageModel> models;
    for (const PredictionInput& input : inputs) {
        horizon.flown_s = input.until_s - input.time_s;
        models.emplace_back(input, horizon);
    }
    return models;
}

} // namespace berg
