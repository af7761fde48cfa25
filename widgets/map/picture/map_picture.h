#pragma once

#include "core/base/geodesy.h"
#include "core/scenario/operation.h"
#include "core/tracking/observer.h"
#include "widgets/theme/mission_clock.h"

#include <QString>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** One iceberg as the map shows it. */
struct MapIceberg
{
    QString id;
    Point position_m = Point::Zero();   ///< estimate
    Point velocity_mps = Point::Zero(); ///< over ground, current included
    double sigma_m2 = 0;
    double radius_m = 50; ///< decides the size class of the symbol
    bool inView = false;
    double appears_s = 0; ///< > 0: not there yet, drawn faint with this time
    std::string key;      ///< id in the scenario; empty: the same as `id`
    TrackStatus status = TrackStatus::Tracked;
    double circle_m = 0;            ///< it is within this of the estimate with 95 %; 0: not shown
    std::optional<Point> truth_m{}; ///< where it is in truth; none: not shown
    std::optional<double> ringEntry_s{}; ///< from now, into the inner ring of the asset; 0: inside
    int keptFor = -1; ///< place of the UAV that alone is to visit it; -1: any may, as the only one
};

struct MapUav
{
    Point position_m = Point::Zero();
    double psi_rad = 0; ///< from the x = east axis, counter-clockwise
    SensorSpec sensor;
    std::string key; ///< id in the scenario; empty: cannot be selected
    double airspeed_mps = 22;
    QString label{};               ///< beside its symbol; empty: it is the only one
    int place = 0;                 ///< among the UAVs of the scenario: decides its colour
    std::optional<Point> home_m{}; ///< where it lands; none: it never does
    double altitude_m = 100;
    bool isAloft = true;
};

/** What moves the air and the water of the whole map. */
struct MapAir
{
    Point wind_mps = Point::Zero();
    Point current_mps = Point::Zero();
    double limit_mps = 0; ///< the wind is slower: airspeed of the slowest UAV; 0: nothing flies
};

/** One point of the flown track. */
struct MapTrackPoint
{
    Point position_m = Point::Zero();
    double time_s = 0;
};

/** The UAV at one instant of its flight. */
struct MapPose
{
    Point position_m = Point::Zero();
    double psi_rad = 0; ///< in [-pi, pi]
    double time_s = 0;
    bool operator==(const MapPose&) const = default;
};

/** By time. A list that the pictures of one flight share: it grows with the flight. */
using SweptPointer = std::shared_ptr<const std::vector<MapPose>>;

struct MapAsset
{
    QString name;
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    double range_m = 0; ///< outer ring: so far it makes icebergs more urgent
    double alarm_m = 0; ///< inner ring
};

/** Where the radio link is kept from. */
struct MapStation
{
    Point position_m = Point::Zero();
    std::vector<double> ranges_m; ///< of the link, each once: it depends on a UAV's altitude
};

/** A number shown large in the title overlay, e.g. {"Zeta", "84 420", "m² s"}. */
struct MapReadout
{
    QString caption;
    QString value;
    QString unit;
};

/** One leg of a plan with aim points. */
struct MapPath
{
    std::vector<Point> path_m;  ///< as it is flown
    std::optional<Point> aim_m; ///< none: a hold
};

/** Where a lost iceberg may be, when it comes into view there. */
struct MapSearchPlace
{
    Point position_m = Point::Zero();
    double chance = 0; ///< of finding it there
};

/** What one UAV has flown and is going to fly. */
struct MapRoute
{
    std::vector<int> plan;             ///< indices of the icebergs in the order to be visited
    std::vector<int> formerPlan;       ///< what `plan` took the place of; empty: nothing to tell
    std::optional<Point> formerFrom_m; ///< where the UAV was then; none: where it is
    std::optional<int> thisSortie; ///< so many of `plan` are flown to before going home; none: all
    std::vector<std::vector<Point>> planCorners; ///< of the geofence that the legs go round, by
                                                 ///< leg, the way home last; empty: none do
    std::vector<MapPath> planPaths; ///< how `plan` is flown; empty: straight from symbol to symbol
    std::vector<MapPath> formerPaths; ///< how `formerPlan` would have been
    /** The point of no return and, before it, how the plan gets there from the place before; empty:
     * there is none. */
    std::vector<Point> toNoReturn_m;
    std::vector<MapSearchPlace> searchPlaces; ///< on legs of the plan
    std::vector<Point> search_m; ///< corners flown to find a lost iceberg; empty: no search
    SweptPointer swept; ///< round and between them the UAV has seen the water; null: none is shown
    std::vector<MapTrackPoint> track;
};

/** Where no UAV flies at some heights. */
struct MapClosedArea
{
    QString name;
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< none: without end
    bool isRing = false;             ///< the stand-off round the asset
    bool operator==(const MapClosedArea&) const = default;
};

/** Airspace with a rule: for information. */
struct MapAirspace
{
    QString title;
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< none: without end
};

/** Everything one picture of the map shows, as plain values. */
struct MapPicture
{
    QString title;
    QString subtitle;
    std::vector<MapReadout> readouts;
    TimesAhead times;       ///< writes the instants of the run
    LatLon origin{47, -48}; ///< of the local plane
    std::vector<MapUav> uavs;
    std::vector<MapRoute> routes; ///< by place in `uavs`, as many
    std::vector<MapIceberg> icebergs;
    std::vector<std::vector<int>> clusters; ///< indices of `icebergs` planned as one point each
    /** Of another run in the same world, by UAV. */
    std::vector<std::vector<MapTrackPoint>> comparisonTracks;
    QString comparisonName;            ///< what that run is, for the legend
    std::vector<Point> area_m;         ///< corners; empty: unbounded
    bool isFenced = false;             ///< the UAVs stay inside the area
    std::vector<MapClosedArea> closed; ///< no-fly areas as in the scenario, then the ring
    std::vector<MapAirspace> airspace;
    std::optional<OperationVolume> operation;
    double separation_m = 0; ///< UAVs of one altitude layer keep so far apart; 0: not watched
    std::optional<MapAsset> asset;
    std::optional<MapStation> station;
    MapAir air;
    bool hidesTruth = false;  ///< nothing is shown that the observer does not know
    double sigmaFull_m2 = 10; ///< end of the colour scale, > 0
    QString emptyTitle;       ///< shown when there is no iceberg
    QString emptyHint;        ///< what to do about it

    /** A UAV has such a route. */
    template <class Test>
    [[nodiscard]] bool anyRoute(const Test& test) const
    {
        return std::any_of(routes.begin(), routes.end(), test);
    }
    /** There is water seen to be shown. */
    [[nodiscard]] bool showsSwept() const
    {
        return anyRoute(
            [](const MapRoute& route) { return route.swept && route.swept->size() > 1; });
    }
};

} // namespace berg
