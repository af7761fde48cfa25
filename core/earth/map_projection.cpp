#include "core/earth/map_projection.h"

#include "core/base/angles.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

struct Ellipsoid
{
    double radius_m = 0;
    double flattening = 0;
};

constexpr Ellipsoid kWgs84{.radius_m = 6378137, .flattening = 1 / 298.257223563};
constexpr double kHughes_m = 6378273;
/** Ellipsoid of the NSIDC grids, Hughes 1980. */
constexpr Ellipsoid kHughes{.radius_m = kHughes_m, .flattening = 1 - 6356889.449 / kHughes_m};

/** A polar stereographic projection, true to scale at a parallel or with a scale at the pole. */
struct PolarGrid
{
    int epsg = 0;
    Pole pole = Pole::North;
    double trueParallel_deg = 90; ///< 90 means UPS, with scale 0.994 at the pole
    double meridian_deg = 0;      ///< points down from the North Pole, up from the South Pole
    double offset_m = 0;          ///< false easting and northing
    Ellipsoid ellipsoid = kWgs84;
};

constexpr std::array kPolarGrids = {
    PolarGrid{3031, Pole::South, 71, 0, 0},
    PolarGrid{3032, Pole::South, 71, 70, 6e6},
    PolarGrid{3411, Pole::North, 70, -45, 0, kHughes},
    PolarGrid{3412, Pole::South, 70, 0, 0, kHughes},
    PolarGrid{3413, Pole::North, 70, -45, 0},
    PolarGrid{3976, Pole::South, 70, 0, 0},
    PolarGrid{3995, Pole::North, 71, 0, 0},
    PolarGrid{3996, Pole::North, 75, 0, 0},
    PolarGrid{5041, Pole::North, 90, 0, 2e6},
    PolarGrid{5042, Pole::South, 90, 0, 2e6},
    PolarGrid{32661, Pole::North, 90, 0, 2e6},
    PolarGrid{32761, Pole::South, 90, 0, 2e6},
};

double turnedLongitude(double longitude_deg)
{
    const double turned_deg = std::remainder(longitude_deg, 360.0);
    return turned_deg >= 180 ? turned_deg - 360 : turned_deg;
}

Unprojection ofPolarGrid(const PolarGrid& grid)
{
    constexpr double kScaleOfUps = 0.994;
    const bool isUps = grid.trueParallel_deg == 90;
    GeographicLib::PolarStereographic projection(grid.ellipsoid.radius_m, grid.ellipsoid.flattening,
                                                 isUps ? kScaleOfUps : 1);
    if (!isUps)
        projection.SetScale(grid.trueParallel_deg, 1);
    return [projection, grid](const Point& projected_m) {
        LatLon place;
        projection.Reverse(grid.pole == Pole::North, projected_m.x() - grid.offset_m,
                           projected_m.y() - grid.offset_m, place.latitude_deg,
                           place.longitude_deg);
        place.longitude_deg = turnedLongitude(place.longitude_deg + grid.meridian_deg);
        return place;
    };
}

Unprojection ofUtmZone(int zone, Pole hemisphere)
{
    return [zone, hemisphere](const Point& projected_m) {
        constexpr double kEast_m = 5e5;
        const double north_m = hemisphere == Pole::North ? 0 : 1e7;
        LatLon place;
        GeographicLib::TransverseMercator::UTM().Reverse(
            6.0 * zone - 183, projected_m.x() - kEast_m, projected_m.y() - north_m,
            place.latitude_deg, place.longitude_deg);
        place.longitude_deg = turnedLongitude(place.longitude_deg);
        return place;
    };
}

LatLon ofWebMercator(const Point& projected_m)
{
    const Point angle_rad = projected_m / kWgs84.radius_m;
    return {.latitude_deg = degFromRad(std::atan(std::sinh(angle_rad.y()))),
            .longitude_deg = turnedLongitude(degFromRad(angle_rad.x()))};
}

} // namespace

std::optional<Unprojection> unprojectionOf(int epsg)
{
    const auto* const grid = std::ranges::find(kPolarGrids, epsg, &PolarGrid::epsg);
    if (grid != kPolarGrids.end())
        return ofPolarGrid(*grid);
    const int zone = epsg % 100;
    const bool isZone = zone >= 1 && zone <= 60;
    const int family = epsg / 100;
    if (isZone && (family == 326 || family == 327))
        return ofUtmZone(zone, family == 326 ? Pole::North : Pole::South);
    if ((family == 258 && zone >= 28 && zone <= 38) || (family == 269 && zone >= 1 && zone <= 23))
        return ofUtmZone(zone, Pole::North);
    if (epsg == 3857 || epsg == 900913)
        return Unprojection(ofWebMercator);
    return std::nullopt;
}

bool isGeographic(int epsg)
{
    constexpr std::array kCodes = {4326, 4979, 4258, 4937, 4269, 4617, 4759, 4955};
    return std::ranges::find(kCodes, epsg) != kCodes.end();
}

} // namespace berg
