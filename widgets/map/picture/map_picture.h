#pragma once

#include "core/base/index.h"
#include "core/earth/geodesy.h"
#include "core/io/import/maps/map_shapes.h"
#include "core/permit/operation.h"
#include "core/scenario/ice_chart.h"
#include "core/tracking/observer.h"
#include "widgets/map/picture/map_live.h"
#include "widgets/map/picture/map_weather.h"
#include "widgets/theme/mission_clock.h"

#include <QString>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** An iceberg as the map shows it. */
struct MapIceberg
{
    QString id;
    Point position_m = Point::Zero();   ///< estimate
    Point velocity_mps = Point::Zero(); ///< over ground, current included
    double sigma_m2 = 0;
    double radius_m = 50; ///< decides the size class of the symbol
    bool inView = false;
    double appears_s = 0; ///< start time if it is still to appear: drawn faint, with this time
    std::optional<std::string> key{}; ///< id in the scenario, if it differs from `id`
    TrackStatus status = TrackStatus::Tracked;
    std::optional<double> circle_m{}; ///< radius of the 95 % position circle, if it is shown
    std::optional<Point> truth_m{};   ///< true position, if it is shown
    /** Time until it enters the asset's inner ring, zero inside; nullopt if it does not. */
    std::optional<double> ringEntry_s{};
    std::optional<int> assignedUav; ///< index of the only UAV that may visit it
};

/** A UAV as the map shows it. */
struct MapUav
{
    Point position_m = Point::Zero();
    double psi_rad = 0; ///< from the x = east axis, counter-clockwise
    SensorSpec sensor;
    std::optional<std::string> key{}; ///< id in the scenario; nullopt if it cannot be selected
    double airspeed_mps = 22;
    QString label{};               ///< text beside its symbol; empty for a single UAV
    int place = 0;                 ///< index in the scenario; sets its colour
    std::optional<Point> home_m{}; ///< landing place, if it has one
    double altitude_m = 100;
    bool isAloft = true;
};

/** Wind and current of the flight. */
struct MapAir
{
    Point wind_mps = Point::Zero();
    Point current_mps = Point::Zero();
    double limit_mps = 0; ///< airspeed of the slowest UAV; wind must be below it. Zero without UAVs
    std::optional<double> gust_mps{};
    QString forecast{};      ///< source and issue of the forecast; empty without one
    bool isReported = false; ///< the crew has reported the wind, in place of the forecast's
    bool isFixed = false;    ///< a forecast decides the wind, so that it cannot be dragged
};

/** A point of a flown track. */
struct MapTrackPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/** Position and heading of a UAV at one instant. */
struct MapPose
{
    Point position_m = Point::Zero();
    double psi_rad = 0; ///< in [-pi, pi]
    double time_s = 0;
    bool operator==(const MapPose&) const = default;
};

/** Poses by time. The pictures of one flight share the list, which grows with the flight. */
using SweptPointer = std::shared_ptr<const std::vector<MapPose>>;

/** The protected asset. */
struct MapAsset
{
    QString name;
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    double range_m = 0; ///< outer ring: icebergs inside become more urgent
    double alarm_m = 0; ///< inner ring
};

/** The ground station of the radio link. */
struct MapStation
{
    Point position_m = Point::Zero();
    std::vector<double>
        ranges_m; ///< distinct link ranges, ascending: the range depends on a UAV's altitude
};

/** A number shown large in the title overlay, e.g. {"Zeta", "84 420", "m² s"}. */
struct MapReadout
{
    QString caption;
    QString value;
    QString unit;
    int rank = 0; ///< if there is no room for all readouts, the lowest ranks are shown
};

/** A leg of a plan with aim points. */
struct MapPath
{
    std::vector<Point> path_m;  ///< the flown path
    std::optional<Point> aim_m; ///< aim point; nullopt for a hold
};

/** A possible position of a lost iceberg, at the time when it comes into view. */
struct MapSearchPlace
{
    Point position_m = Point::Zero();
    double chance = 0; ///< probability of finding it there
};

/** An iceberg of a picture: its place in `MapPicture::icebergs`. */
using MapPlace = Index<class MapPlaceKind>;
using MapPlaces = std::vector<MapPlace>;

/** The flown track and the plan of one UAV. */
struct MapRoute
{
    MapPlaces plan;       ///< icebergs in visiting order
    MapPlaces formerPlan; ///< plan that `plan` replaced; empty if there is none to show
    std::optional<Point>
        formerFrom_m; ///< UAV position at the replacement; nullopt means its position now
    std::optional<int>
        thisSortie; ///< icebergs of `plan` visited before flying home; nullopt means all
    /** Corners of the geofence that the legs follow, by leg, the flight home last; empty if none.
     */
    std::vector<std::vector<Point>> planCorners;
    std::vector<MapPath> planPaths;   ///< paths of `plan`; empty if legs are straight lines
    std::vector<MapPath> formerPaths; ///< paths of `formerPlan`
    /** Path from the last visit before the point of no return to that point; empty without one. */
    std::vector<Point> toNoReturn_m;
    /** Places of the patrol's later visits, from the end of `planPaths` on. */
    std::vector<Point> laterVisits_m;
    std::vector<MapSearchPlace>
        searchPlaces; ///< possible positions of lost icebergs on the plan's legs
    std::vector<Point>
        search_m;       ///< remaining corners of a search pattern; empty if it is not searching
    SweptPointer swept; ///< poses whose fields of view cover the water seen; null if not shown
    std::vector<MapTrackPoint> track;
};

/** An area that no UAV may enter between two heights. */
struct MapClosedArea
{
    QString name;
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< nullopt means unlimited height
    bool isRing = false;             ///< the stand-off round the asset
    bool operator==(const MapClosedArea&) const = default;
};

/** Airspace with a rule, shown for information. */
struct MapAirspace
{
    QString title;
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< nullopt means unlimited height
};

/** The ice chart below the icebergs. */
struct MapIceChart
{
    IceChart chart; ///< in the plane of the picture
    LatLon origin;
    bool isOld = false;                                  ///< much older than the start of the run
    std::shared_ptr<const std::vector<MapShape>> shapes; ///< areas in the colours of their classes
};
using IceChartPointer = std::shared_ptr<const MapIceChart>;

/** Content of one picture of the map, as plain values. */
struct MapPicture
{
    QString title;
    QString subtitle;
    std::vector<MapReadout> readouts;
    TimesAhead times;       ///< formats the times of the run
    LatLon origin{47, -48}; ///< geographic position of the local origin
    std::vector<MapUav> uavs;
    std::vector<MapRoute> routes; ///< same size and order as `uavs`
    std::vector<MapIceberg> icebergs;
    std::vector<MapPlaces> clusters; ///< icebergs planned as one point each
    /** Tracks of another run in the same world, by UAV. */
    std::vector<std::vector<MapTrackPoint>> comparisonTracks;
    QString comparisonName;            ///< name of that run for the legend
    std::vector<Point> area_m;         ///< corners; empty if unbounded
    bool isFenced = false;             ///< the UAVs stay inside the area
    std::vector<MapClosedArea> closed; ///< no-fly areas as in the scenario, then the ring
    std::vector<MapAirspace> airspace;
    IceChartPointer iceChart; ///< null without one
    std::optional<OperationVolume> operation;
    double separation_m =
        0; ///< minimum distance of UAVs in one altitude layer; zero if not monitored
    std::optional<MapAsset> asset;
    std::optional<MapStation> station;
    MapAir air;
    MapWeatherPointer weather; ///< forecast at the time shown; null without one
    MapLive live;
    bool hidesTruth = false;  ///< shows only what the observer has estimated
    double sigmaFull_m2 = 10; ///< end of the colour scale, > 0
    QString emptyTitle;       ///< shown if there is no iceberg
    QString emptyHint;        ///< advice below `emptyTitle`

    /** Returns true if `test` accepts the route of any UAV. */
    template <class Test>
    [[nodiscard]] bool anyRoute(const Test& test) const
    {
        return std::any_of(routes.begin(), routes.end(), test);
    }
    /** Returns true if there is an area seen by the UAVs to show. */
    [[nodiscard]] bool showsSwept() const
    {
        return anyRoute(
            [](const MapRoute& route) { return route.swept && route.swept->size() > 1; });
    }
};

} // namespace berg
