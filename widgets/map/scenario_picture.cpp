#include "widgets/map/scenario_picture.h"

#include "core/base/angles.h"
#include "core/scenario/priority.h"
#include "widgets/model/asset_approach.h"
#include "widgets/model/wind.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace berg {

MapIceberg mapIceberg(const Iceberg& iceberg, const Scenario& scenario)
{
    MapIceberg drawn{.id = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name),
                     .position_m = iceberg.position_m,
                     .velocity_mps = iceberg.velocity_mps + scenario.current_mps,
                     .sigma_m2 = initialSigma_m2(iceberg),
                     .radius_m = iceberg.radius_m,
                     .appears_s = iceberg.appears_s,
                     .key = iceberg.id};
    if (scenario.observer.model == ObserverModel::Kalman)
        drawn.circle_m = likelyRadius_m(drawn.sigma_m2);
    if (const std::optional<AssetApproach> approach = approachOf(scenario, iceberg))
        drawn.ringEntry_s = approach->entry_s;
    return drawn;
}

namespace {

std::vector<std::string> keysOf(const std::vector<int>& order, const MapPicture& picture)
{
    std::vector<std::string> keys;
    for (const int place : order)
        keys.push_back(keyOf(picture.icebergs[static_cast<std::size_t>(place)]));
    return keys;
}

std::vector<std::vector<std::string>> keysOf(const std::vector<std::vector<int>>& clusters,
                                             const MapPicture& picture)
{
    std::vector<std::vector<std::string>> keys;
    for (const std::vector<int>& members : clusters)
        keys.push_back(keysOf(members, picture));
    return keys;
}

/** Those of the keys that are there, in their order. */
std::vector<int> placesOf(const std::vector<std::string>& keys,
                          const std::unordered_map<std::string, int>& places)
{
    std::vector<int> order;
    for (const std::string& key : keys)
        if (const auto place = places.find(key); place != places.end())
            order.push_back(place->second);
    return order;
}

/** What the UAV sees at t = 0 is certain, unless it is measured with noise. */
void markInView(MapPicture& picture)
{
    if (!picture.uav)
        return;
    const FieldOfView field(picture.uav->sensor, picture.uav->position_m, picture.uav->psi_rad);
    for (MapIceberg& iceberg : picture.icebergs) {
        iceberg.inView = iceberg.appears_s <= 0 && field.contains(iceberg.position_m);
        if (iceberg.inView && iceberg.circle_m == 0)
            iceberg.sigma_m2 = 0;
    }
}

/** UAV and icebergs are where the picture has them, as far as it has any, in the same wind. */
bool isAsPlanned(const MapPicture& picture, const Scenario& scenario)
{
    if (picture.planWays.empty() && picture.formerWays.empty() && picture.planCorners.empty())
        return true;
    if (!picture.uav || scenario.uavs.empty() || picture.air.wind_mps != scenario.wind_mps ||
        picture.area_m != scenario.area_m ||
        picture.uav->position_m != scenario.uavs.front().position_m ||
        picture.uav->psi_rad != psiFromHeading(scenario.uavs.front().heading_deg))
        return false;
    std::unordered_map<std::string, Point> places_m;
    for (const Iceberg& iceberg : scenario.icebergs)
        places_m.emplace(iceberg.id, iceberg.position_m);
    return std::all_of(picture.icebergs.begin(), picture.icebergs.end(),
                       [&](const MapIceberg& iceberg) {
                           const auto place = places_m.find(keyOf(iceberg));
                           return place != places_m.end() && place->second == iceberg.position_m;
                       });
}

} // namespace

std::string keyOf(const MapIceberg& iceberg)
{
    return iceberg.key.empty() ? iceberg.id.toStdString() : iceberg.key;
}

std::optional<MapAsset> assetOf(const std::optional<Asset>& asset, double time_s)
{
    if (!asset)
        return std::nullopt;
    return MapAsset{.name = QString::fromStdString(asset->name),
                    .position_m = asset->position_m + asset->velocity_mps * time_s,
                    .velocity_mps = asset->velocity_mps,
                    .range_m = asset->range_m,
                    .alarm_m = alarmRadius_m(*asset)};
}

MapAir airOf(const Scenario& scenario)
{
    return {.wind_mps = scenario.wind_mps,
            .current_mps = scenario.current_mps,
            .limit_mps = slowestAirspeed_mps(scenario)};
}

std::optional<Point> homeOf(const Scenario& scenario)
{
    if (scenario.uavs.empty())
        return std::nullopt;
    const Uav& uav = scenario.uavs.front();
    if (uav.home_m || uav.spec.endurance_s <= 0)
        return uav.home_m;
    return uav.position_m;
}

double likelyRadius_m(double sigma_m2)
{
    constexpr double kSquareOf95 = 5.991; // chi-square with two degrees of freedom
    return std::sqrt(kSquareOf95 * sigma_m2);
}

MapPicture withScenario(MapPicture picture, const Scenario& scenario)
{
    if (!isAsPlanned(picture, scenario)) { // ways are places, an order holds until the next plan
        picture.planWays.clear();
        picture.formerWays.clear();
        picture.planCorners.clear();
    }
    const std::vector<std::string> planned = keysOf(picture.plan, picture);
    const std::vector<std::string> former = keysOf(picture.formerPlan, picture);

    const std::vector<std::vector<std::string>> clustered = keysOf(picture.clusters, picture);

    std::unordered_map<std::string, int> places;
    picture.icebergs.clear();
    for (const Iceberg& iceberg : scenario.icebergs) {
        places.emplace(iceberg.id, static_cast<int>(picture.icebergs.size()));
        picture.icebergs.push_back(mapIceberg(iceberg, scenario));
    }
    picture.plan = placesOf(planned, places);
    picture.formerPlan = placesOf(former, places);
    for (std::size_t k = 0; k < clustered.size(); ++k)
        picture.clusters[k] = placesOf(clustered[k], places);

    picture.search_m.clear();
    picture.uav.reset();
    if (!scenario.uavs.empty()) {
        const Uav& uav = scenario.uavs.front();
        picture.uav = MapUav{.position_m = uav.position_m,
                             .psi_rad = psiFromHeading(uav.heading_deg),
                             .sensor = {.fov_m = uav.fov_m, .shape = scenario.fovShape},
                             .key = uav.id,
                             .airspeed_mps = uav.spec.airspeed_mps};
    }
    markInView(picture);

    picture.origin = scenario.origin;
    picture.area_m = scenario.area_m;
    picture.isFenced = scenario.geofence;
    picture.home_m = homeOf(scenario);
    picture.asset = assetOf(scenario.asset, 0);
    picture.air = airOf(scenario);
    for (const MapIceberg& iceberg : picture.icebergs)
        picture.sigmaFull_m2 = std::max(picture.sigmaFull_m2, roundSigmaScale(iceberg.sigma_m2));
    return picture;
}

} // namespace berg
