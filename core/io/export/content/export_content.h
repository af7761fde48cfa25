#pragma once

#include "core/io/export/content/geo_shapes.h"
#include "core/io/export/content/track_points.h"
#include "core/io/results/result_csv.h"
#include "core/io/words/report_words.h"
#include "core/mission/mission.h"
#include "core/mission/visits.h"
#include "core/permit/operation.h"
#include "core/plan/solve/names.h"
#include "core/scenario/utc_time.h"
#include "core/study/zeta_prediction.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace berg {

/**
 * Input of an export: the scenario, the plan from its start and, for a run, the mission. A mission
 * is exported in its present state: the plan in force, and the flight until now.
 */
struct ExportSource
{
    const Scenario& scenario;
    const Plan& plan;                 ///< from `planFromStart`, or the first one of the mission
    const Mission* mission = nullptr; ///< null if nothing was flown
    /**
     * Flown tracks by UAV, which are moved from; if empty, those recorded by the mission are used.
     */
    std::span<TrackPoints> flown = {};
    std::optional<ZetaPrediction> predicted = {}; ///< made before take-off
    ReportWords words = {};                       ///< language of printed pages
};

/** Part of a flight or plan that is exported. */
enum class ExportScope
{
    FirstLeg, ///< leg to the first iceberg or cluster of the order
    Order,    ///< the whole present order, in straight legs
    Path,     ///< the present order as an aircraft with its turn radius flies it
    Track     ///< the path flown so far
};

/** Names of scopes on the command line. */
inline constexpr std::array<Named<ExportScope>, 4> kExportScopeNames{{
    {ExportScope::FirstLeg, "first-leg"},
    {ExportScope::Order, "order"},
    {ExportScope::Path, "path"},
    {ExportScope::Track, "track"},
}};

/** Choices of the user; missing ones have the values of the scenario. */
struct ExportOptions
{
    /** Without a value, the track of a mission or else the order is exported. */
    std::optional<ExportScope> what = {};
    std::optional<std::string> uav = {}; ///< id of the UAV; nullopt means all
    std::optional<double> altitude_m = {};
    std::optional<double> airspeed_mps = {};
    std::optional<double> acceptance_m = {}; ///< radius within which a waypoint counts as reached
    int loiterTurns = 0;                     ///< turns over each iceberg; 0 means flying over it
    /** Without a value, paths end at home with limited endurance or on a closed route. */
    std::optional<bool> returnHome = {};
    bool operator==(const ExportOptions&) const = default;
};

/** Largest number of turns that ArduPlane can store in its 8 bits. */
inline constexpr int kMostLoiterTurns = 255;

/** A UAV with its path. */
struct ExportUav
{
    std::size_t row = 0; ///< index in the scenario, which determines its colour
    Uav uav;             ///< state at the start of the path, with the chosen altitude and speed
    double start_s = 0;  ///< start time of the path
    /** landing place, or the start */
    Point home_m = Point::Zero();
    double reach_m = 0;       ///< requested acceptance radius over a single iceberg
    bool reachChosen = false; ///< chosen by the user, so it applies to clusters unchanged
    bool isAimed = false;     ///< flown with aim points, past the estimates and not over them
    std::vector<PlannedSearch> searches = {}; ///< search places on the aimed legs
    double circle_m = 0;                      ///< radius of the tightest circle over ground
    std::size_t laterSorties = 0;             ///< number of icebergs left for them
    std::optional<double> slot_s = {}; ///< end of its recovery slot; nullopt if it needs no slot
    std::vector<Visit> visits = {};    ///< future or past visits in order; home has iceberg −1
    TrackPoints track = {};            ///< track of `Path` and `Track`
    double flown_m = 0;                ///< distance through the air until now
    bool isAloft = false;              ///< flying already at the start of the path
};

/** State of an iceberg at the time of the export. */
enum class IcebergState
{
    Expected, ///< it has not appeared yet
    Tracked,
    Lost,
    GivenUp, ///< the search for it has ended without finding it
    Left     ///< it has left the area
};

/** Names of states in exported files. */
inline constexpr std::array<Named<IcebergState>, 5> kIcebergStateNames{{
    {IcebergState::Expected, "expected"},
    {IcebergState::Tracked, "tracked"},
    {IcebergState::Lost, "lost"},
    {IcebergState::GivenUp, "given up"},
    {IcebergState::Left, "left"},
}};

/** An iceberg at `ExportContent::now_s`. */
struct ExportIceberg
{
    Iceberg iceberg;                  ///< as entered
    Point position_m = Point::Zero(); ///< estimate; for scope `Track` the true position
    Point drift_mps = Point::Zero();  ///< estimated drift including the current, in the plane
    double sigma_m2 = 0;
    Track track; ///< tracking state, which determines the growth of sigma
    IcebergState state = IcebergState::Tracked;
    bool isListed = true; ///< present at `now_s`, or expected in a scenario that was not flown

    /** Returns sigma if the iceberg stays unseen for `dt_s` >= 0. */
    [[nodiscard]] double sigmaAfter_m2(double dt_s) const { return track.sigmaAfter_m2(dt_s); }
};

/** Input of the writers of exported files, built by `exportContent`. */
struct ExportContent
{
    ExportScope what = ExportScope::Order;
    ExportOptions options;
    std::string name;                         ///< name of the scenario
    std::shared_ptr<const Scenario> scenario; ///< as entered
    LocalFrame frame{LatLon{}};
    std::optional<UtcTime> start;        ///< instant of time 0; nullopt if times are relative
    double now_s = 0;                    ///< time of the icebergs' states
    std::vector<ExportUav> uavs;         ///< the chosen UAVs, at least one
    std::vector<ExportIceberg> icebergs; ///< by the indices that visits refer to
    std::vector<Point> area_m;
    bool geofence = false;
    std::vector<NoFlyArea> noFly; ///< as entered
    std::optional<Asset> asset;
    std::optional<NoFlyArea> standoff;        ///< stand-off ring of the asset
    std::optional<OperationVolume> operation; ///< at the chosen altitude and airspeed
    PlannerSettings planner;
    Plan plan;                               ///< plan in force, or the last one
    Point wind_mps = Point::Zero();          ///< at `now_s`, in the plane
    std::optional<double> zeta_m2s;          ///< of all UAVs until now, if flown
    std::optional<ZetaPrediction> predicted; ///< made before take-off; nullopt if there is none
    const Mission* mission = nullptr;        ///< for formats that are `flownOnly` only; borrowed
    ReportWords words;                       ///< language of printed pages
};

/**
 * Builds the content of an export. Throws `Error{InvalidInput}` with the option as subject for
 * options that cannot be satisfied: an unknown UAV, a track when nothing was flown, a number out of
 * range, an airspeed that is not above the wind. Throws `Error{Unsupported}` with the UAV or object
 * as subject for a time or place that no file can hold: not finite, or outside the plane. Throws as
 * `TrackPoints` for a track. A path is flown here (`flyOrder`): milliseconds for each hour of
 * flight.
 */
[[nodiscard]] ExportContent exportContent(const ExportSource& source,
                                          const ExportOptions& options = {});

/** First line of every document about an operation volume. */
inline constexpr const char* kVolumeTitle =
    "Operation volume: proposal, to be checked with your authority";

/** Throws `Error{InvalidInput}` for options that cannot be satisfied, as `exportContent` does. */
void checkExportOptions(const ExportSource& source, const ExportOptions& options);

/** Returns the no-fly areas and the stand-off ring. */
[[nodiscard]] std::vector<NoFlyArea> closedAreas(const ExportContent& content);

/** Returns true if the area is closed only above its floor or below its ceiling. */
[[nodiscard]] bool hasHeights(const NoFlyArea& area);

/**
 * Returns the probability that an iceberg of a planned visit is in view when the UAV is over its
 * estimate (`chanceInView`, for a cluster at the distance of its farthest member). On aimed legs,
 * returns for a lost iceberg the probability that one of the planned search places shows it.
 * Returns nullopt for other icebergs on aimed legs, which the UAV passes aside, and for a track.
 */
[[nodiscard]] std::optional<double> chanceInView(const ExportContent& content, const ExportUav& uav,
                                                 const Visit& visit, IcebergIndex iceberg);

/** Returns the ids of the icebergs in view at a visit, none for a visit to home. */
[[nodiscard]] std::vector<std::string> idsOf(const ExportContent& content, const Visit& visit);

/**
 * Returns the standard deviation of the velocity and the parameters of a changing drift, those that
 * the iceberg has, by their names in scenario files.
 */
[[nodiscard]] std::vector<std::pair<std::string_view, double>>
driftData(const ExportContent& content, const ExportIceberg& iceberg);

/**
 * Returns the name of a visit for people: name or id of the iceberg, ids of a cluster, or "Home".
 */
[[nodiscard]] std::string titleOf(const ExportContent& content, const Visit& visit);

/** Returns the name of the object, or its id if it has no name. */
[[nodiscard]] const std::string& titleOf(const Iceberg& iceberg);
[[nodiscard]] const std::string& titleOf(const Uav& uav);

/** Converts a velocity in the plane to true east and north at the place, rounded to 1e-9 m/s. */
[[nodiscard]] Point eastNorth_mps(const ExportContent& content, const Point& velocity_mps,
                                  const Point& at_m);

/**
 * Converts a heading in the plane to the true heading at the place, degrees in [0, 360), rounded to
 * 1e-6.
 */
[[nodiscard]] double trueHeading_deg(const ExportContent& content, double heading_deg,
                                     const Point& at_m);

/** Returns the position of the asset at `now_s`; the content must have an asset. */
[[nodiscard]] Point assetPlace_m(const ExportContent& content);

/**
 * Passes each point of the path to `take`: the track, or the start and each visit; at least one.
 */
void eachPoint(const ExportUav& uav, const PointSink& take);

/** Passes the path as longitude-latitude lines to `take`; see `eachPlace` of geo_shapes.h. */
void eachPlace(const ExportContent& content, const ExportUav& uav, const PlaceSink& take);

/** Returns the number of parts of the lines of `eachPlace`, which are cut at the antimeridian. */
[[nodiscard]] std::size_t partsOf(const ExportContent& content, const ExportUav& uav);

/** Returns the points of the path in memory, for use on a page or over an hour of flight. */
[[nodiscard]] std::vector<TimedPoint> pathOf(const ExportUav& uav);

/** Returns the last point of the path. */
[[nodiscard]] TimedPoint endOf(const ExportUav& uav);

} // namespace berg
