#include "widgets/print/export_picture.h"

#include "core/base/angles.h"
#include "core/scenario/priority.h"
#include "core/tracking/position_error.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/map/picture/plan_stops.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/print/printable_text.h"

#include <QCoreApplication>

namespace berg {

namespace {

struct ExportPicture
{
    Q_DECLARE_TR_FUNCTIONS(ExportPicture)
};

/** UAV at the start of its path, or at the end of its track. */
MapUav mapUavOf(const ExportUav& uav, const ExportContent& content)
{
    MapUav drawn = mapUav(*content.scenario, uav.row);
    drawn.position_m = uav.uav.position_m;
    drawn.psi_rad = psiFromHeading(uav.uav.heading_deg);
    if (content.what == ExportScope::Track && !uav.track.empty()) {
        drawn.position_m = uav.track.back().state.position_m;
        drawn.psi_rad = uav.track.back().state.psi_rad;
    }
    drawn.airspeed_mps = uav.uav.spec.airspeed_mps;
    drawn.altitude_m = uav.uav.spec.altitude_m;
    drawn.label = printable(drawn.label);
    return drawn;
}

MapRoute flownRoute(const ExportUav& uav)
{
    MapRoute route;
    for (const TrackPoint& point : uav.track)
        route.track.push_back({.position_m = point.state.position_m, .time_s = point.time_s});
    return route;
}

/** Turns on the leg that ends at `visit`, after the previous leg ended at `from_s`. */
std::vector<Point> cornersOf(const ExportUav& uav, double from_s, const Visit& visit)
{
    std::vector<Point> corners;
    for (const TrackPoint& point : uav.track)
        if (point.time_s > from_s && point.time_s < visit.time_s)
            corners.push_back(point.state.position_m);
    return corners;
}

MapRoute plannedRoute(const ExportUav& uav, const ShownPlaces& places)
{
    MapRoute route;
    double from_s = uav.start_s;
    for (const Visit& visit : uav.visits) {
        if (visit.iceberg) {
            const std::optional<MapPlace>& place = places[toIndex(*visit.iceberg)];
            if (!place)
                continue;
            route.plan.push_back(*place);
        } else {
            route.thisSortie = static_cast<int>(route.plan.size()); // followed by the flight home
        }
        route.planCorners.push_back(cornersOf(uav, from_s, visit));
        from_s = visit.time_s;
    }
    return route;
}

TrackStatus statusOf(IcebergState state)
{
    switch (state) {
    case IcebergState::Lost:
        return TrackStatus::Lost;
    case IcebergState::GivenUp:
        return TrackStatus::GivenUp;
    case IcebergState::Expected:
    case IcebergState::Tracked:
    case IcebergState::Left:
        return TrackStatus::Tracked;
    }
    return TrackStatus::Tracked;
}

MapIceberg mapIcebergOf(const ExportIceberg& iceberg, const ExportContent& content)
{
    MapIceberg drawn = mapIceberg(iceberg.iceberg, *content.scenario);
    drawn.position_m = iceberg.position_m;
    drawn.velocity_mps = iceberg.drift_mps;
    drawn.sigma_m2 = iceberg.sigma_m2;
    drawn.status = statusOf(iceberg.state);
    if (iceberg.state != IcebergState::Expected)
        drawn.appears_s = 0;
    if (drawn.circle_m > 0.0) // circles belong to estimates, which a track lacks
        drawn.circle_m = content.what == ExportScope::Track
                             ? std::nullopt
                             : std::optional(radius95_m(iceberg.sigma_m2));
    drawn.ringEntry_s = ringEntry_s(content, iceberg);
    drawn.id = printable(drawn.id);
    return drawn;
}

/** Adds the listed icebergs and returns the places of all. */
ShownPlaces addIcebergs(MapPicture& picture, const ExportContent& content)
{
    ShownPlaces places;
    for (const ExportIceberg& iceberg : content.icebergs) {
        std::optional<MapPlace>& place = places.emplace_back();
        if (!iceberg.isListed)
            continue;
        place = MapPlace::of(picture.icebergs.size());
        picture.icebergs.push_back(mapIcebergOf(iceberg, content));
    }
    picture.sigmaFull_m2 = sigmaEnd_m2(*content.scenario);
    return places;
}

void addUav(MapPicture& picture, const ExportContent& content, const ExportUav& uav,
            const ShownPlaces& places)
{
    const bool isFlown = content.what == ExportScope::Track;
    picture.uavs.push_back(mapUavOf(uav, content));
    picture.routes.push_back(isFlown ? flownRoute(uav) : plannedRoute(uav, places));
    if (picture.routes.back().thisSortie)
        picture.uavs.back().home_m = uav.home_m;
    for (const Visit& visit : uav.visits)
        if (!isFlown && !visit.members.empty())
            picture.clusters.push_back(placesOf(visit.members, places));
}

} // namespace

MapAir exportAir(const ExportContent& content)
{
    MapAir air = airOf(*content.scenario);
    air.wind_mps = content.wind_mps;
    air.limit_mps = content.uavs.front().uav.spec.airspeed_mps;
    for (const ExportUav& uav : content.uavs)
        air.limit_mps = std::min(air.limit_mps, uav.uav.spec.airspeed_mps);
    return air;
}

std::optional<double> ringEntry_s(const ExportContent& content, const ExportIceberg& iceberg)
{
    if (!content.asset || !iceberg.isListed || iceberg.state == IcebergState::Expected)
        return std::nullopt;
    const RelativeMotion motion =
        relativeToAsset(*content.asset, content.now_s, iceberg.position_m, iceberg.drift_mps);
    return entryTime_s(motion, alarmRadius_m(*content.asset), kApproachHorizon_s);
}

MapPicture exportPicture(const ExportContent& content)
{
    MapPicture picture;
    picture.origin = content.frame.origin();
    const ShownPlaces places = addIcebergs(picture, content);
    for (const ExportUav& uav : content.uavs)
        addUav(picture, content, uav, places);
    picture.area_m = content.area_m;
    picture.isFenced = content.geofence;
    picture.closed = closedOf(content.noFly, content.standoff);
    for (MapClosedArea& area : picture.closed)
        area.name = printable(area.name);
    picture.airspace = airspaceOf(*content.scenario);
    for (MapAirspace& area : picture.airspace)
        area.title = printable(area.title);
    picture.operation = content.operation;
    picture.asset = assetOf(content.asset, content.now_s);
    if (picture.asset)
        picture.asset->name = printable(picture.asset->name);
    picture.emptyTitle = ExportPicture::tr("No icebergs");
    return picture;
}

} // namespace berg
