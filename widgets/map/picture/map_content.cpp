#include "widgets/map/picture/map_content.h"

#include "widgets/map/picture/footprint.h"
#include "widgets/map/picture/map_view_transform.h"

#include <algorithm>
#include <cmath>

namespace berg {
namespace {

constexpr double kFieldMargin_px = 6; // distance of the field of view from the edge

/** Adds the corners of the field of view, drawn in by `slack_m`: they may be nearer to the edge. */
void addField(std::vector<Point>& points_m, const MapUav& uav, double slack_m)
{
    const auto nearer = [slack_m](double d_m) {
        return std::copysign(std::max(0.0, std::abs(d_m) - slack_m), d_m);
    };
    for (const Point& corner_m : fieldCorners(uav)) {
        const Point d_m = corner_m - uav.position_m;
        points_m.emplace_back(uav.position_m + Point(nearer(d_m.x()), nearer(d_m.y())));
    }
}

/** Adds the extent of the rings, limited so that the rest is shown at half the scale or more. */
void addRings(std::vector<Point>& points_m, const MapAsset& asset)
{
    const WorldBounds rest = boundsOf(points_m);
    const Point margin_m = rest.size_m() / 2;
    const double radius_m = std::max(asset.range_m, asset.alarm_m);
    for (const Point& towards : {Point(1, 0), Point(-1, 0), Point(0, 1), Point(0, -1)})
        points_m.emplace_back((asset.position_m + radius_m * towards)
                                  .cwiseMin(rest.max_m + margin_m)
                                  .cwiseMax(rest.min_m - margin_m));
}

} // namespace

std::vector<Point> contentPoints(const MapPicture& picture, double driftTime_s, double scale_pxpm)
{
    std::vector<Point> points_m = picture.area_m;
    for (const MapClosedArea& area : picture.closed)
        points_m.insert(points_m.end(), area.corners_m.begin(), area.corners_m.end());
    if (picture.operation) {
        const std::vector<Point>& buffer_m = picture.operation->outline_m(VolumePart::Buffer);
        points_m.insert(points_m.end(), buffer_m.begin(), buffer_m.end());
    }
    for (const MapIceberg& iceberg : picture.icebergs) {
        points_m.push_back(iceberg.position_m);
        points_m.emplace_back(iceberg.position_m + iceberg.velocity_mps * driftTime_s);
    }
    const auto addTrack = [&](const std::vector<MapTrackPoint>& track) {
        for (const MapTrackPoint& point : track)
            points_m.push_back(point.position_m);
    };
    std::for_each(picture.comparisonTracks.begin(), picture.comparisonTracks.end(), addTrack);
    if (picture.asset)
        points_m.push_back(picture.asset->position_m);
    if (picture.station)
        points_m.push_back(picture.station->position_m);
    for (const MapRoute& route : picture.routes) {
        addTrack(route.track);
        for (const MapPath& path : route.planPaths) {
            points_m.insert(points_m.end(), path.path_m.begin(), path.path_m.end());
            if (path.aim_m)
                points_m.push_back(*path.aim_m);
        }
    }
    for (const MapUav& uav : picture.uavs) {
        points_m.push_back(uav.position_m);
        addField(points_m, uav, (kSymbolMargin_px - kFieldMargin_px) / scale_pxpm);
        if (uav.home_m)
            points_m.push_back(*uav.home_m);
    }
    if (picture.asset)
        addRings(points_m, *picture.asset);
    return points_m;
}

} // namespace berg
