#pragma once

#include "core/base/geodesy.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/limits.h"
#include "core/tracking/drift.h"
#include "core/tracking/observer.h"
#include "core/vehicle/uav_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace berg {

// Everything a user can set, as plain values. Angles are kept in the degrees the user typed (and
// the file holds), so that saving never changes a number; the simulation converts.
// `extraJson` keeps members of the file that this version does not know: the text of a JSON
// object, empty when there are none; they are written back unchanged.

/** Weather that a UAV is not flown in. */
struct WeatherLimits
{
    std::optional<double> wind_mps;
    std::optional<double> gust_mps;
    bool icing = false; ///< it may be flown in icing conditions
    bool operator==(const WeatherLimits&) const = default;
};

struct Uav
{
    std::string id;
    std::string name;
    Point position_m = Point::Zero();
    double heading_deg = 45; ///< clockwise from north
    UavSpec spec;
    Point fov_m = Point(600, 600); ///< field of view along and across the heading
    std::optional<Point> home_m;   ///< where it lands; none: where it starts
    double turnaround_s = 600;     ///< on the ground between two sorties
    WeatherLimits weather;
    std::string extraJson;
    bool operator==(const Uav&) const = default;
};

struct Iceberg
{
    std::string id;
    std::string name;
    Point position_m = Point::Zero();   ///< estimate at t = 0, and truth in the simple model
    Point velocity_mps = Point::Zero(); ///< known part
    double velocitySd_mps = 0;          ///< of what it is known to when last seen, along each axis
    double velocitySpread_mps = 0;      ///< of the velocity in the long run, along each axis
    double velocityTime_s = 0; ///< in which its own velocity fades to 1/e; 0: it is constant
    double q_m2ps = 0.025;
    double sigma0_m2 = 5;
    double observed_s = 0; ///< age of the last observation at t = 0, since when sigma0 has grown
    double appears_s = 0;
    double radius_m = 50;
    std::string uav;     ///< id of the UAV that alone is to visit it; empty: any
    RecordedTrack track; ///< true motion where it is known; empty: drawn from velocity and q
    std::string trackExtraJson;
    std::string extraJson;
    bool operator==(const Iceberg&) const = default;
};

/** Platform or ship to protect: icebergs near it, or coming near, are visited first (`priority`).
 */
struct Asset
{
    std::string name;
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    double range_m = 10000;
    double gain = 5;
    double alarm_m = 0;                      ///< radius of the inner ring; 0: half the range
    double standoff_m = 0;                   ///< no UAV comes nearer; 0: any may
    std::optional<double> standoffCeiling_m; ///< above which it may; none: at no height
    std::string extraJson;
    bool operator==(const Asset&) const = default;
};

/** A simple polygon that no UAV flies into whose altitude lies within the heights. */
struct NoFlyArea
{
    std::string name;
    std::vector<Point> corners_m;
    double floor_m = 0;              ///< above the sea, as the altitude of a UAV
    std::optional<double> ceiling_m; ///< none: without end
    std::string extraJson;
    bool operator==(const NoFlyArea&) const = default;
};

/** Where the link to the UAVs is kept from. */
struct GroundStation
{
    Point position_m = Point::Zero();
    double antenna_m = 2;          ///< above the sea
    std::optional<double> range_m; ///< of the link; none: to the radio horizon
    std::string extraJson;
    bool operator==(const GroundStation&) const = default;
};

/** What is known of the weather besides the wind; temperatures are those at the sea. */
struct Weather
{
    std::optional<double> gust_mps;
    std::optional<double> temperature_degC;
    std::optional<double> dewPoint_degC;
    std::string extraJson;
    bool operator==(const Weather&) const = default;
};

/** What moves and what sees it: all that zeta of a flight depends on, whoever plans it. */
struct ScenarioMotion
{
    double duration_s = 1000;
    std::int64_t seed = 1;
    double dt_s = 0.1;
    bool noise = true;
    Point wind_mps = Point::Zero();
    Point current_mps = Point::Zero(); ///< carries every iceberg in addition to its own velocity
    std::vector<Point> area_m;         ///< icebergs outside are not monitored; empty: unbounded
    ObserverSpec observer;
    FovShape fovShape = FovShape::Body; ///< file: planner.fov_shape
    std::vector<Uav> uavs;
    std::vector<Iceberg> icebergs;
    bool operator==(const ScenarioMotion&) const = default;
};

/** All but how it is planned: runs in equal worlds can be set beside each other. */
struct ScenarioWorld : ScenarioMotion
{
    LatLon origin{47, -48};
    std::string startUtc;  ///< ISO 8601 with Z; empty: times are relative
    bool geofence = false; ///< the UAVs stay inside the area
    std::vector<NoFlyArea> noFly;
    /** UAVs of one altitude layer are kept so far apart, horizontally; 0: they are not. */
    double separation_m = 200;
    Weather weather;
    std::optional<GroundStation> groundStation;
    std::optional<Asset> asset;
    double planningTime_s = 0; ///< file: planner.planning_delay_s; a plan is in force so late
    bool clusters = false;     ///< file: planner.clusters; several in one view: a point
    std::optional<double> reachRadius_m; ///< file: planner.reach_radius_m; none: reached in view
    std::string plannerExtraJson;
    std::string originExtraJson;
    std::string observerExtraJson;
    std::string extraJson;
    bool operator==(const ScenarioWorld&) const = default;
};

/**
 * What an application for a permit is made of: constants of the volume that the flights are kept
 * within (`operationVolume`, which has the formulas and their source), and what people fill in.
 */
struct Operation
{
    double margin_m = 500; ///< round the places that plans lead to, for turns and changes
    double span_m = 3;     ///< largest dimension of a UAV
    double positionError_m = 3;
    double pathError_m = 3; ///< of the autopilot
    double mapError_m = 1;
    double reaction_s = 1;
    double turnBank_deg = 30; ///< in the turn back
    double heightError_m = 4;
    double climbPart = 0.707; ///< of the speed that leads upwards until there is a reaction
    double pullUpPart = 0.3;  ///< of v^2/g that levelling out takes
    double bufferRatio = 1;   ///< width of the buffer by the height it is fallen from
    double adjacent_s = 180;  ///< of flight, within the next two
    double adjacentLeast_m = 5000;
    double adjacentMost_m = 35000;
    std::string crew;
    std::string callSign;
    std::string contacts;
    std::string link; ///< how UAVs are commanded
    std::string checklist;
    std::string extraJson;
    bool operator==(const Operation&) const = default;
};

/** Airspace that has a rule: told when the operation enters it, but flown into all the same. */
struct AirspaceArea
{
    std::string name;
    std::string kind; ///< class or type, as its source has it: "D", "R", "TRA", ...
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< none: without end
    std::string fromUtc;             ///< ISO 8601 with Z; empty: since ever
    std::string untilUtc;            ///< likewise
    std::string extraJson;
    bool operator==(const AirspaceArea&) const = default;
};

/** What only people read. */
struct ScenarioLabels
{
    std::string name;
    std::string notes;
    std::optional<Operation> operation; ///< none: no permit is applied for
    std::vector<AirspaceArea> airspace;
    bool operator==(const ScenarioLabels&) const = default;
};

struct Scenario : ScenarioLabels, ScenarioWorld
{
    PlannerSettings planner;
    bool operator==(const Scenario&) const = default;
};

/** sigma at t = 0: sigma0 and what position and velocity have changed since the last observation.
 */
[[nodiscard]] double initialSigma_m2(const Iceberg& iceberg);
/**
 * The iceberg at t = 0, carried by the current, to which its velocity fades. With measurements its
 * velocity is as uncertain as given, and since the last observation so is its position along with
 * it.
 */
[[nodiscard]] Track initialTrack(const Iceberg& iceberg, ObserverModel model,
                                 const Point& current_mps = Point::Zero());

} // namespace berg
