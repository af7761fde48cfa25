#include "core/coverage/own_pictures.h"

#include <limits>

namespace berg {

namespace {

/** Returns the UAV nearest to the iceberg, which is taken to have it in view. */
std::size_t viewerOf(const PlanRequest& request, std::size_t iceberg)
{
    std::size_t nearest = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t u = 0; u < request.uavs.size(); ++u) {
        const PredictionInput& picture = *request.uavs[u].prediction;
        const Point place_m = picture.tracks[iceberg].estimate_m(picture.time_s);
        const double away_m = (place_m - picture.uav.position_m).norm();
        if (away_m < nearest_m) {
            nearest = u;
            nearest_m = away_m;
        }
    }
    return nearest;
}

bool isInViewOf(const PredictionInput& picture, std::size_t iceberg)
{
    return FieldOfView(picture.sensor, picture.uav.position_m, picture.uav.psi_rad)
        .contains(picture.tracks[iceberg].estimate_m(picture.time_s));
}

/** Makes the places of lost icebergs known to all UAVs, whoever may search there. */
void sharePlaces(std::vector<PredictionInput>& pictures)
{
    std::vector<std::vector<SearchPlace>>& all = pictures.front().places;
    for (const PredictionInput& picture : pictures)
        for (std::size_t i = 0; i < all.size(); ++i)
            if (all[i].empty())
                all[i] = picture.places[i];
    for (PredictionInput& picture : pictures)
        picture.places = all;
}

} // namespace

std::vector<PredictionInput> ownPictures(const PlanRequest& request)
{
    std::vector<PredictionInput> own;
    for (const UavRequest& uav : request.uavs) {
        require(uav.prediction != nullptr, "CoveragePolicy: a UAV has no picture of its flight");
        own.push_back(*uav.prediction);
    }
    for (std::size_t i = 0; i < request.ids.size(); ++i) {
        if (!own.front().tracks[i].inView)
            continue;
        bool isClear = false;
        for (PredictionInput& picture : own) {
            picture.tracks[i].inView = isInViewOf(picture, i);
            isClear = isClear || picture.tracks[i].inView;
        }
        if (!isClear)
            own[viewerOf(request, i)].tracks[i].inView = true;
    }
    sharePlaces(own);
    return own;
}

std::vector<CoverageModel> modelsOf(std::span<const PredictionInput> pictures,
                                    CoverageHorizon horizon)
{
    std::vector<CoverageModel> models;
    for (const PredictionInput& picture : pictures) {
        horizon.flown_s = picture.until_s - picture.time_s;
        models.emplace_back(picture, horizon);
    }
    return models;
}

} // namespace berg
