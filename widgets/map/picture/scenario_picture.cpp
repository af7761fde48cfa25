#include "widgets/map/picture/scenario_picture.h"

#include "core/base/angles.h"
#include "core/mission/sortie_outlook.h"
#include "core/permit/airspace.h"
#include "core/scenario/fence.h"
#include "core/scenario/priority.h"
#include "core/tracking/position_error.h"
#include "widgets/document/wind.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/flight/weather_course.h"
#include "widgets/map/picture/ice_picture.h"
#include "widgets/words/forecast_text.h"
#include "widgets/words/object_names.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

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
        drawn.circle_m = radius95_m(drawn.sigma_m2);
    if (const std::optional<AssetApproach> approach = approachOf(scenario, iceberg))
        drawn.ringEntry_s = approach->entry_s;
    const auto uav = std::ranges::find(scenario.uavs, iceberg.uav, &Uav::id);
    if (areDistinguished(scenario.uavs) && uav != scenario.uavs.end())
        drawn.assignedUav = static_cast<int>(uav - scenario.uavs.begin());
    return drawn;
}

namespace {

/** Returns those of the icebergs `before` that still exist, at their new places. */
MapPlaces stillThere(const MapPlaces& order, const std::vector<MapIceberg>& before,
                     const std::unordered_map<std::string, MapPlace>& places)
{
    MapPlaces there;
    for (const MapPlace old : order)
        if (const auto place = places.find(keyOf(before[toIndex(old)])); place != places.end())
            there.push_back(place->second);
    return there;
}

/** Marks icebergs in view at t = 0. Their position is certain unless it is measured with noise. */
void markInView(MapPicture& picture)
{
    std::vector<FieldOfView> fields;
    for (const MapUav& uav : picture.uavs)
        fields.emplace_back(uav.sensor, uav.position_m, uav.psi_rad);
    for (MapIceberg& iceberg : picture.icebergs) {
        iceberg.inView = iceberg.appears_s <= 0 &&
                         std::any_of(fields.begin(), fields.end(), [&](const FieldOfView& field) {
                             return field.contains(iceberg.position_m);
                         });
        if (iceberg.inView && !iceberg.circle_m)
            iceberg.sigma_m2 = 0;
    }
}

/** Closed areas with the stand-off ring of `asset`, which in flight may differ from the scenario's.
 */
std::vector<MapClosedArea> closedOf(const Scenario& scenario, const std::optional<Asset>& asset)
{
    return closedOf(scenario.noFly,
                    asset ? standoffArea(*asset, scenario.duration_s) : std::nullopt);
}

std::optional<MapStation> stationOf(const Scenario& scenario)
{
    if (!scenario.groundStation)
        return std::nullopt;
    MapStation station{.position_m = scenario.groundStation->position_m, .ranges_m = {}};
    for (const Uav& uav : scenario.uavs)
        station.ranges_m.push_back(linkRange_m(*scenario.groundStation, uav.spec.altitude_m));
    std::ranges::sort(station.ranges_m);
    station.ranges_m.erase(std::unique(station.ranges_m.begin(), station.ranges_m.end()),
                           station.ranges_m.end());
    return station;
}

/** Returns nullopt if the scenario has no operation volume. */
std::optional<OperationVolume> operationOf(const Scenario& scenario)
{
    if (!scenario.operation || scenario.uavs.empty())
        return std::nullopt;
    return operationVolume(scenario, *scenario.operation);
}

bool isAt(const MapUav& drawn, const Uav& uav)
{
    return drawn.position_m == uav.position_m && drawn.psi_rad == psiFromHeading(uav.heading_deg);
}

/** Returns whether UAVs, icebergs, wind and areas still are as the picture's paths assume. */
bool isAsPlanned(const MapPicture& picture, const Scenario& scenario)
{
    if (!picture.anyRoute([](const MapRoute& route) {
            return !route.planPaths.empty() || !route.formerPaths.empty() ||
                   !route.planCorners.empty() || !route.toNoReturn_m.empty();
        }))
        return true;
    if (picture.uavs.empty() || picture.uavs.size() > scenario.uavs.size() ||
        (picture.air.wind_mps != scenario.wind_mps && usableForecast(scenario) == nullptr) ||
        picture.area_m != scenario.area_m || picture.closed != closedOf(scenario, scenario.asset) ||
        !std::equal(picture.uavs.begin(), picture.uavs.end(), scenario.uavs.begin(), isAt))
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

/** Routes by UAV of the scenario; a new UAV gets an empty one. */
std::vector<MapRoute> routesFor(const Scenario& scenario, const MapPicture& picture)
{
    std::vector<MapRoute> routes;
    for (const Uav& uav : scenario.uavs) {
        const auto known = std::ranges::find(picture.uavs, uav.id, &MapUav::key);
        const auto place = static_cast<std::size_t>(known - picture.uavs.begin());
        routes.push_back(known == picture.uavs.end() ? MapRoute() : picture.routes[place]);
    }
    return routes;
}

/** Keeps only the parts of a route that hold wherever the UAV is. */
void forgetPlaces(MapRoute& route)
{
    route.planPaths.clear();
    route.searchPlaces.clear();
    route.formerPaths.clear();
    route.planCorners.clear();
    route.toNoReturn_m.clear();
}

} // namespace

std::string keyOf(const MapIceberg& iceberg)
{
    return iceberg.key ? *iceberg.key : iceberg.id.toStdString();
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

std::vector<MapClosedArea> closedOf(const std::vector<NoFlyArea>& noFly,
                                    const std::optional<NoFlyArea>& ring)
{
    std::vector<MapClosedArea> closed;
    const auto add = [&](const NoFlyArea& area, bool isRing) {
        closed.push_back({.name = QString::fromStdString(area.name),
                          .corners_m = area.corners_m,
                          .floor_m = area.floor_m,
                          .ceiling_m = area.ceiling_m,
                          .isRing = isRing});
    };
    for (const NoFlyArea& area : noFly)
        add(area, false);
    if (ring)
        add(*ring, true);
    return closed;
}

std::vector<MapAirspace> airspaceOf(const Scenario& scenario)
{
    std::vector<MapAirspace> airspace;
    for (const AirspaceArea& area : scenario.airspace)
        airspace.push_back({.title = QString::fromStdString(titleOf(area)),
                            .corners_m = area.corners_m,
                            .floor_m = area.floor_m,
                            .ceiling_m = area.ceiling_m});
    return airspace;
}

MapAir airOf(const Scenario& scenario)
{
    MapAir air{.wind_mps = scenario.wind_mps,
               .current_mps = scenario.current_mps,
               .limit_mps = slowestAirspeed_mps(scenario)};
    const ForecastField* forecast = usableForecast(scenario);
    if (forecast == nullptr)
        return air;
    const CoursePoint weather = weatherAtStart(scenario);
    air.wind_mps = weather.wind_mps.value_or(air.wind_mps);
    air.current_mps = weather.current_mps.value_or(air.current_mps);
    air.gust_mps = weather.gust_mps;
    air.forecast = forecastText(*forecast, forecastStartOf(scenario), QLocale());
    air.isFixed = true;
    return air;
}

void setSurroundings(MapPicture& picture, const Scenario& scenario,
                     const std::optional<Asset>& asset, double time_s)
{
    picture.origin = scenario.origin;
    picture.area_m = scenario.area_m;
    picture.isFenced = scenario.geofence;
    picture.closed = closedOf(scenario, asset);
    picture.airspace = airspaceOf(scenario);
    picture.iceChart = iceChartOf(scenario);
    picture.operation = operationOf(scenario);
    picture.separation_m = scenario.separation_m;
    picture.asset = assetOf(asset, time_s);
    picture.station = stationOf(scenario);
    picture.air = airOf(scenario);
}

MapUav mapUav(const Scenario& scenario, std::size_t i)
{
    const Uav& uav = scenario.uavs[i];
    MapUav drawn{.position_m = uav.position_m,
                 .psi_rad = psiFromHeading(uav.heading_deg),
                 .sensor = {.fov_m = uav.fov_m, .shape = scenario.fovShape},
                 .key = uav.id,
                 .airspeed_mps = uav.spec.airspeed_mps,
                 .label = nameInFleet(scenario.uavs, static_cast<int>(i)),
                 .place = static_cast<int>(i),
                 .home_m = uav.home_m,
                 .altitude_m = uav.spec.altitude_m};
    if (!uav.home_m && uav.spec.endurance_s > 0)
        drawn.home_m = uav.position_m;
    return drawn;
}

MapPicture withScenario(MapPicture picture, const Scenario& scenario)
{
    if (!isAsPlanned(picture, scenario)) // paths depend on positions
        std::for_each(picture.routes.begin(), picture.routes.end(), forgetPlaces);
    picture.routes = routesFor(scenario, picture);
    const std::vector<MapIceberg> before = std::exchange(picture.icebergs, {});

    std::unordered_map<std::string, MapPlace> places;
    for (const Iceberg& iceberg : scenario.icebergs) {
        places.emplace(iceberg.id, MapPlace::of(picture.icebergs.size()));
        picture.icebergs.push_back(mapIceberg(iceberg, scenario));
    }
    const auto follow = [&](MapPlaces& order) { order = stillThere(order, before, places); };
    std::for_each(picture.clusters.begin(), picture.clusters.end(), follow);
    for (MapRoute& route : picture.routes) {
        follow(route.plan);
        follow(route.formerPlan);
        route.search_m.clear();
    }

    picture.uavs.clear();
    for (std::size_t i = 0; i < scenario.uavs.size(); ++i)
        picture.uavs.push_back(mapUav(scenario, i));
    markInView(picture);

    setSurroundings(picture, scenario, scenario.asset, 0);
    picture.weather = mapWeatherAt(scenario, 0);
    picture.times = {.clock = clockOf(scenario)};
    if (before.empty()) // otherwise colours and rings are steady while dragging
        picture.sigmaFull_m2 = sigmaEnd_m2(scenario);
    return picture;
}

} // namespace berg
