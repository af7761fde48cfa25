#include "app/export_picture.h"

#include "core/base/angles.h"
#include "widgets/map/scenario_picture.h"

#include <QCoreApplication>

namespace berg {

namespace {

struct ExportPicture
{
    Q_DECLARE_TR_FUNCTIONS(ExportPicture)
};

MapUav mapUavOf(const ExportUav& uav, bool isOneOfSeveral)
{
    return {.position_m = uav.uav.position_m,
            .psi_rad = psiFromHeading(uav.uav.heading_deg),
            .sensor = {.fov_m = uav.uav.fov_m},
            .airspeed_mps = uav.uav.spec.airspeed_mps,
            .label = isOneOfSeveral ? QString::fromStdString(titleOf(uav.uav)) : QString(),
            .place = static_cast<int>(uav.row),
            .altitude_m = uav.uav.spec.altitude_m};
}

MapRoute flownRoute(const ExportUav& uav)
{
    MapRoute route;
    for (const TrackPoint& point : uav.track)
        route.track.push_back({.position_m = point.state.position_m, .time_s = point.time_s});
    return route;
}

/** Where the path turns on the leg that ends at `visit`, after that which ended at `from_s`. */
std::vector<Point> cornersOf(const ExportUav& uav, double from_s, const Visit& visit)
{
    std::vector<Point> corners;
    for (const TrackPoint& point : uav.track)
        if (point.time_s > from_s && point.time_s < visit.time_s)
            corners.push_back(point.state.position_m);
    return corners;
}

/** `places`: of each iceberg of the content in the picture, -1: not in it. */
MapRoute plannedRoute(const ExportUav& uav, const std::vector<int>& places)
{
    MapRoute route;
    double from_s = uav.start_s;
    for (const Visit& visit : uav.visits) {
        const int place = visit.iceberg < 0 ? -1 : places[static_cast<std::size_t>(visit.iceberg)];
        if (place < 0 && visit.iceberg >= 0)
            continue;
        route.planCorners.push_back(cornersOf(uav, from_s, visit));
        from_s = visit.time_s;
        if (place >= 0)
            route.plan.push_back(place);
        else
            route.thisSortie = static_cast<int>(route.plan.size()); // and then home
    }
    return route;
}

std::vector<int> placesOf(const std::vector<int>& members, const std::vector<int>& places)
{
    std::vector<int> shown;
    for (const int member : members)
        if (const int place = places[static_cast<std::size_t>(member)]; place >= 0)
            shown.push_back(place);
    return shown;
}

/** Icebergs that are listed; where each is in the picture. */
std::vector<int> addIcebergs(MapPicture& picture, const ExportPreview& preview)
{
    std::vector<int> places;
    double fullScale_m2 = 0;
    for (std::size_t row = 0; row < preview.listed.size(); ++row) {
        places.push_back(preview.listed[row] ? static_cast<int>(picture.icebergs.size()) : -1);
        if (!preview.listed[row])
            continue;
        const ExportIceberg& iceberg = preview.content.icebergs[row];
        picture.icebergs.push_back({.id = QString::fromStdString(titleOf(iceberg.iceberg)),
                                    .position_m = iceberg.position_m,
                                    .velocity_mps = iceberg.drift_mps,
                                    .sigma_m2 = iceberg.sigma_m2,
                                    .radius_m = iceberg.iceberg.radius_m});
        fullScale_m2 = std::max(fullScale_m2, iceberg.sigma_m2);
    }
    picture.sigmaFull_m2 = roundSigmaScale(fullScale_m2);
    return places;
}

void addUav(MapPicture& picture, const ExportContent& content, const ExportUav& uav,
            const std::vector<int>& places)
{
    const bool isFlown = content.what == ExportWhat::Track;
    picture.uavs.push_back(mapUavOf(uav, content.uavs.size() > 1));
    picture.routes.push_back(isFlown ? flownRoute(uav) : plannedRoute(uav, places));
    if (picture.routes.back().thisSortie)
        picture.uavs.back().home_m = uav.home_m;
    for (const Visit& visit : uav.visits)
        if (!isFlown && !visit.members.empty())
            picture.clusters.push_back(placesOf(visit.members, places));
}

} // namespace

MapPicture exportPicture(const ExportPreview& preview)
{
    const ExportContent& content = preview.content;
    MapPicture picture;
    picture.origin = content.frame.origin();
    const std::vector<int> places = addIcebergs(picture, preview);
    for (const ExportUav& uav : content.uavs)
        addUav(picture, content, uav, places);
    picture.area_m = content.area_m;
    picture.isFenced = content.geofence;
    picture.asset = assetOf(content.asset, content.now_s);
    picture.emptyTitle = ExportPicture::tr("No icebergs");
    return picture;
}

} // namespace berg
