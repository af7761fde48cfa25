#pragma once

#include "core/base/geodesy.h"
#include "core/tracking/observer.h"

#include <QString>

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
};

struct MapUav
{
    Point position_m = Point::Zero();
    double psi_rad = 0; ///< from the x = east axis, counter-clockwise
    SensorSpec sensor;
    std::string key; ///< id in the scenario; empty: cannot be selected
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

struct MapAsset
{
    QString name;
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    double range_m = 0; ///< outer ring: so far it makes icebergs more urgent
    double alarm_m = 0; ///< inner ring
};

/** A number shown large in the title overlay, e.g. {"Zeta", "84 420", "m² s"}. */
struct MapReadout
{
    QString caption;
    QString value;
    QString unit;
};

/** One leg of a plan with aim points. */
struct MapWay
{
    std::vector<Point> path_m; ///< as it is flown
    Point aim_m = Point::Zero();
};

/** Everything one picture of the map shows, as plain values. */
struct MapPicture
{
    QString title;
    QString subtitle;
    std::vector<MapReadout> readouts;
    LatLon origin{47, -48}; ///< of the local plane
    std::optional<MapUav> uav;
    std::vector<MapIceberg> icebergs;
    std::vector<int> plan;             ///< indices of `icebergs` in the order to be visited
    std::vector<int> formerPlan;       ///< what `plan` took the place of; empty: nothing to tell
    std::optional<Point> formerFrom_m; ///< where the UAV was then; none: where it is
    std::vector<MapWay> planWays;   ///< how `plan` is flown; empty: straight from symbol to symbol
    std::vector<MapWay> formerWays; ///< how `formerPlan` would have been
    std::vector<MapPose> swept;     ///< by time; round and between them the UAV has seen the water
    std::vector<MapTrackPoint> track;
    std::vector<MapTrackPoint> comparisonTrack; ///< of another run in the same world
    QString comparisonName;                     ///< what that run is, for the legend
    std::vector<Point> area_m;                  ///< corners; empty: unbounded
    std::optional<MapAsset> asset;
    double sigmaFull_m2 = 10; ///< end of the colour scale, > 0
    QString emptyTitle;       ///< shown when there is no iceberg
    QString emptyHint;        ///< what to do about it

    /** There is water seen to be shown. */
    [[nodiscard]] bool showsSwept() const { return uav.has_value() && swept.size() > 1; }
};

/** Smallest "round" end of a sigma scale at or above `sigma_m2`: 1, 2, 5, 10, 15, 20, 30, ... */
[[nodiscard]] double roundSigmaScale(double sigma_m2);

} // namespace berg
