#pragma once

#include "core/earth/forecast_field.h"
#include "core/earth/geodesy.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/ice_chart.h"
#include "core/scenario/limits.h"
#include "core/tracking/drift.h"
#include "core/tracking/observer.h"
#include "core/vehicle/aircraft_profile.h"
#include "core/vehicle/uav_spec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace berg {

// Everything a user can set, as plain values. Angles stay in the degrees that the user typed (and
// the file holds), so saving never changes a number; the simulation converts them. `extraJson` is
// the text of a JSON object with the members of the file that this version does not know, or empty;
// they are written back unchanged.

/** Weather limits of a UAV. */
struct WeatherLimits
{
    /** Strongest permitted wind; nullopt means no limit. */
    std::optional<double> wind_mps;
    std::optional<double> gust_mps;
    /** Shortest permitted visibility; nullopt means no limit. */
    std::optional<double> visibility_m;
    /** Lowest permitted cloud base above the sea; nullopt means no limit. */
    std::optional<double> ceiling_m;
    bool icing = false; ///< true if it may fly in icing conditions
    bool operator==(const WeatherLimits&) const = default;
};

/** One UAV with its start, camera and limits. */
struct Uav
{
    std::string id;
    std::string name;
    Point position_m = Point::Zero();
    double heading_deg = 45; ///< clockwise from north
    UavSpec spec;
    Point fov_m = Point(600, 600); ///< field of view along and across the heading
    std::optional<Point> home_m;   ///< landing place; nullopt means the start
    double turnaround_s = 600;     ///< time on the ground between two sorties
    WeatherLimits weather;
    AircraftProfile aircraft; ///< for missions that autopilots fly
    std::string extraJson;
    bool operator==(const Uav&) const = default;
};

/** One iceberg: estimate, uncertainty and drift model. */
struct Iceberg
{
    std::string id;
    std::string name;
    Point position_m = Point::Zero();   ///< estimate at t = 0, and truth in the simple model
    Point velocity_mps = Point::Zero(); ///< known drift without the current
    /** Standard deviation of `velocity_mps` when last seen, along each axis. */
    double velocitySd_mps = 0;
    /** Long-term standard deviation of the velocity, along each axis. */
    double velocitySpread_mps = 0;
    /** Time in which its own velocity fades to 1/e; 0 means a constant velocity. */
    double velocityTime_s = 0;
    double q_m2ps = 0.025;
    double sigma0_m2 = 5;
    double observed_s = 0; ///< age of the last observation at t = 0; sigma0 has grown since
    /** Run time from which it is known, s. */
    double appears_s = 0;
    double radius_m = 50;
    /** Length at the waterline; if given, wind and current carry it (`driftLaw`), else the current.
     */
    std::optional<double> length_m;
    std::string uav;     ///< id of the only UAV that may visit it; empty means any
    RecordedTrack track; ///< recorded true motion; if empty it is drawn from velocity and q
    std::string trackExtraJson;
    std::string extraJson;
    bool operator==(const Iceberg&) const = default;
};

/**
 * Protected platform or ship. Icebergs near it, or approaching it, are visited first (`priority`).
 */
struct Asset
{
    std::string name;
    Point position_m = Point::Zero();
    Point velocity_mps = Point::Zero();
    double range_m = 10000;
    double gain = 5;
    std::optional<double> alarm_m = {}; ///< radius of the inner ring; nullopt means half the range
    double standoff_m = 0;              ///< distance that every UAV keeps
    /** Height above which UAVs may cross the ring; nullopt means no height. */
    std::optional<double> standoffCeiling_m;
    std::string extraJson;
    bool operator==(const Asset&) const = default;
};

/** A simple polygon that no UAV may enter whose altitude is between floor and ceiling. */
struct NoFlyArea
{
    std::string name;
    std::vector<Point> corners_m;
    double floor_m = 0;              ///< above sea level, like the altitude of a UAV
    std::optional<double> ceiling_m; ///< nullopt means unlimited
    std::string extraJson;
    bool operator==(const NoFlyArea&) const = default;
};

/** The ground station of the link to the UAVs. */
struct GroundStation
{
    Point position_m = Point::Zero();
    double antenna_m = 2;          ///< above sea level
    std::optional<double> range_m; ///< range of the link; nullopt means the radio horizon
    std::string extraJson;
    bool operator==(const GroundStation&) const = default;
};

/** Known weather besides the wind; temperatures are at sea level. */
struct Weather
{
    std::optional<double> gust_mps;
    std::optional<double> temperature_degC;
    std::optional<double> dewPoint_degC;
    std::string extraJson;
    bool operator==(const Weather&) const = default;
};

/** Motion and sensing: everything on which zeta of a flight depends, whatever the plan. */
struct ScenarioPhysics
{
    double duration_s = 1000;
    std::int64_t seed = 1;
    double dt_s = 0.1;
    bool noise = true;
    Point wind_mps = Point::Zero();
    Point current_mps = Point::Zero(); ///< carries every iceberg in addition to its own velocity
    /** Replaces a constant quantity where and when it gives one. Needs `startUtc`. */
    std::optional<ForecastField> forecast;
    std::vector<Point> area_m; ///< icebergs outside are not monitored; empty means unbounded
    ObserverSpec observer;
    FovShape fovShape = FovShape::Body; ///< file: planner.fov_shape
    std::vector<Uav> uavs;
    std::vector<Iceberg> icebergs;
    bool operator==(const ScenarioPhysics&) const = default;
};

/** Everything but the planner: runs in equal worlds can be compared. */
struct ScenarioWorld : ScenarioPhysics
{
    LatLon origin{47, -48};
    std::string startUtc;  ///< ISO 8601 with Z; if empty, times are relative
    bool geofence = false; ///< true if UAVs stay inside the area
    std::vector<NoFlyArea> noFly;
    /** Least horizontal distance of UAVs in one altitude layer; 0 disables separation. */
    double separation_m = 200;
    Weather weather;
    std::optional<GroundStation> groundStation;
    std::optional<Asset> asset;
    /** File: planner.planning_delay_s; delay after which a plan is in force. */
    double planningTime_s = 0;
    /** File: planner.clusters; icebergs that fit one view are planned as one point. */
    bool clusters = false;
    /** File: planner.reach_radius_m; if empty, an iceberg is reached once in view. */
    std::optional<double> reachRadius_m;
    std::string plannerExtraJson;
    std::string originExtraJson;
    std::string observerExtraJson;
    std::string extraJson;
    bool operator==(const ScenarioWorld&) const = default;
};

/**
 * Basis of a permit application: constants of the volume in which flights stay (`operationVolume`
 * has the formulas and their source), and texts to fill in.
 */
struct Operation
{
    double margin_m = 500; ///< around the places of the plans, for turns and replanning
    double span_m = 3;     ///< largest dimension of a UAV
    double positionError_m = 3;
    double pathError_m = 3; ///< path-keeping error of the autopilot
    double mapError_m = 1;
    double reaction_s = 1;
    double turnBank_deg = 30; ///< bank angle in the turn back
    double heightError_m = 4;
    double climbPart = 0.707; ///< share of the speed that is climb during the reaction time
    double pullUpPart = 0.3;  ///< share of v^2/g used by levelling out
    double bufferRatio = 1;   ///< width of the buffer divided by the height of the fall
    double adjacent_s = 180;  ///< flight time to the edge, limited by the next two
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

/** Regulated airspace. Entering it is reported, but plans may lead through it. */
struct AirspaceArea
{
    std::string name;
    std::string kind; ///< class or type as given by the source: "D", "R", "TRA", ...
    std::vector<Point> corners_m;
    double floor_m = 0;
    std::optional<double> ceiling_m; ///< nullopt means unlimited
    std::string fromUtc;             ///< ISO 8601 with Z; if empty, active from any time
    std::string untilUtc;            ///< ISO 8601 with Z; if empty, active without end
    std::string extraJson;
    bool operator==(const AirspaceArea&) const = default;
};

/** Members that do not affect the flight. */
struct ScenarioLabels
{
    std::string name;
    std::string notes;
    std::optional<Operation> operation; ///< nullopt if no permit is applied for
    std::vector<AirspaceArea> airspace;
    std::optional<IceChart> iceChart;
    bool operator==(const ScenarioLabels&) const = default;
};

/** A complete scenario as stored in a .berg file. */
struct Scenario : ScenarioLabels, ScenarioWorld
{
    PlannerSettings planner;
    bool operator==(const Scenario&) const = default;
};

/**
 * Returns sigma at time 0, which is sigma0 plus the growth of position and velocity uncertainty
 * since the last observation.
 */
[[nodiscard]] double initialSigma_m2(const Iceberg& iceberg);
/**
 * Returns the track of the iceberg at t = 0. It moves with the current, to which its own velocity
 * fades. Since the last observation the uncertainty of its velocity has spread to its position.
 * From t = 0 on the Kalman observer has the given velocity uncertainty, while the simple observer
 * knows the velocity.
 */
[[nodiscard]] Track initialTrack(const Iceberg& iceberg, ObserverModel model,
                                 const Point& current_mps = Point::Zero());

} // namespace berg
