#pragma once

#include "core/io/export/geo_shapes.h"
#include "core/io/export/track_points.h"
#include "core/io/results/result_csv.h"
#include "core/io/text/report_words.h"
#include "core/io/text/utc_time.h"
#include "core/plan/solve/names.h"
#include "core/scenario/operation.h"
#include "core/sim/mission.h"
#include "core/sim/visits.h"
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
 * What there is to export: the scenario, the plan from its start and, for a run, the mission. A
 * mission is exported as it stands: its plan in force, and what was flown until now.
 */
struct ExportSource
{
    const Scenario& scenario;
    const PlanAnswer& plan;           ///< of `planFromStart`, or `startPlan` of the mission
    const Mission* mission = nullptr; ///< null: nothing flown
    /** By UAV, moved from; none: what the mission recorded. */
    std::span<TrackPoints> flown = {};
    std::optional<ZetaPrediction> predicted = {}; ///< before take-off; nullopt: not known
    ReportWords words = {};                       ///< of pages for people
};

enum class ExportWhat
{
    FirstLeg, ///< to the first iceberg of the order, or the first cluster
    Order,    ///< the whole present order, in straight legs
    Path,     ///< the present order as an aircraft with these turns flies it
    Track     ///< what was flown
};

inline constexpr std::array<Named<ExportWhat>, 4> kExportWhatNames{{
    {ExportWhat::FirstLeg, "first-leg"},
    {ExportWhat::Order, "order"},
    {ExportWhat::Path, "path"},
    {ExportWhat::Track, "track"},
}};

/** What a user chooses; what is left out is as the scenario says. */
struct ExportOptions
{
    std::optional<ExportWhat> what = {}; ///< none: the track of a mission, else the order
    std::string uav = {};                ///< id; empty: all
    std::optional<double> altitude_m = {};
    std::optional<double> airspeed_mps = {};
    std::optional<double> acceptance_m = {}; ///< radius within which a waypoint counts as passed
    int loiterTurns = 0;                     ///< over each iceberg; 0: fly over it
    std::optional<bool> returnHome = {};     ///< none: with limited endurance or on a closed route
    bool operator==(const ExportOptions&) const = default;
};

/** Turns that ArduPlane can store: 8 bits. */
inline constexpr int kMostLoiterTurns = 255;

/** One UAV with its way. */
struct ExportUav
{
    std::size_t row = 0; ///< in the scenario; writers choose its colour by it
    Uav uav;             ///< as the way begins: place, heading, altitude and speed chosen
    double start_s = 0;  ///< when it begins
    Point home_m = Point::Zero();
    double reach_m = 0;       ///< acceptance radius wanted over a single iceberg
    bool reachChosen = false; ///< by the options: the same over clusters
    bool isAimed = false;     ///< flown with aims: past the estimates, not over them
    std::vector<PlannedSearch> searches = {}; ///< for lost icebergs, on the aimed legs
    double circle_m = 0;                      ///< radius of the tightest circle over ground
    std::size_t laterSorties = 0;             ///< icebergs of the order that are left for them
    std::optional<double> slot_s = {}; ///< end of its recovery slot; nullopt if it needs no slot
    std::vector<Visit> visits = {};    ///< to come or made, in order; home is iceberg -1
    TrackPoints track = {};            ///< of `Path` and `Track`
    double flown_m = 0;                ///< through the air until now
};

enum class IcebergState
{
    Expected, ///< has not appeared yet
    Tracked,
    Lost,
    GivenUp, ///< the search for it has ended without it
    Left     ///< the area
};

inline constexpr std::array<Named<IcebergState>, 5> kIcebergStateNames{{
    {IcebergState::Expected, "expected"},
    {IcebergState::Tracked, "tracked"},
    {IcebergState::Lost, "lost"},
    {IcebergState::GivenUp, "given up"},
    {IcebergState::Left, "left"},
}};

/** One iceberg at `ExportContent::now_s`. */
struct ExportIceberg
{
    Iceberg iceberg;                  ///< as entered
    Point position_m = Point::Zero(); ///< estimate; of a track, where it truly is
    Point drift_mps = Point::Zero();  ///< believed, with the current, in the plane
    double sigma_m2 = 0;
    Track track; ///< what is known of it: how sigma goes on
    IcebergState state = IcebergState::Tracked;
    bool isListed = true; ///< there at `now_s`, or to come in a scenario that was not flown

    /** sigma after `dt_s` >= 0 unseen. */
    [[nodiscard]] double sigmaAfter_m2(double dt_s) const { return track.sigmaAfter_m2(dt_s); }
};

/** What the solver said of the plan. */
struct ExportPlan
{
    SolveStatus status = SolveStatus::None;
    std::optional<double> gap; ///< relative; none: no bound
    bool fellBack = false;     ///< the rest of the plan before
};

/** Everything that writers of exported files read, made once by `exportContent`. */
struct ExportContent
{
    ExportWhat what = ExportWhat::Order;
    ExportOptions options;
    std::string name;                         ///< of the scenario
    std::shared_ptr<const Scenario> scenario; ///< as entered
    LocalFrame frame{LatLon{}};
    std::optional<UtcTime> start;        ///< time 0; none: times are relative
    double now_s = 0;                    ///< time of the icebergs
    std::vector<ExportUav> uavs;         ///< those chosen, at least one
    std::vector<ExportIceberg> icebergs; ///< by the indices that visits name
    std::vector<Point> area_m;
    bool geofence = false;
    std::vector<NoFlyArea> noFly; ///< as entered
    std::optional<Asset> asset;
    std::optional<NoFlyArea> standoff;        ///< round the asset
    std::optional<OperationVolume> operation; ///< at the altitude and airspeed chosen
    PlannerSettings planner;
    ExportPlan plan;                         ///< in force, or the last one
    Point wind_mps = Point::Zero();          ///< at `now_s`, in the plane
    std::optional<double> zeta_m2s;          ///< until now, of all UAVs; none: nothing was flown
    std::optional<ZetaPrediction> predicted; ///< before take-off; nullopt: not known
    const Mission* mission = nullptr;        ///< for formats that are `flownOnly` alone; borrowed
    ReportWords words;                       ///< of pages for people
};

/**
 * The content of an export. Throws `Error{InvalidInput}` for options that cannot be met, subject =
 * the option: a UAV that is not there, a track when nothing was flown, a number out of range; and
 * `Error{Unsupported}` of what no file can hold, subject = whose it is: a time or place that is not
 * finite or off the plane. A path is flown here (`flyOrder`): milliseconds for each hour of flight.
 */
[[nodiscard]] ExportContent exportContent(const ExportSource& source,
                                          const ExportOptions& options = {});

/** What every paper about an operation volume says first. */
inline constexpr const char* kVolumeTitle =
    "Operation volume: proposal, to be checked with your authority";

/** Refuses options that cannot be met, as `exportContent` does. */
void checkExportOptions(const ExportSource& source, const ExportOptions& options);

/** No-fly areas and the stand-off ring, `closedAreas` of the content. */
[[nodiscard]] std::vector<NoFlyArea> closedAreas(const ExportContent& content);

/** Whether it is open below or above some altitude. */
[[nodiscard]] bool hasHeights(const NoFlyArea& area);

/**
 * Chance that an iceberg of a planned visit is in view when the UAV is over its estimate
 * (`chanceInView`; of a cluster, as far out as its farthest member); of a lost one that legs with
 * aims search for, that one of the places shows it. None where the UAV does not fly over it, or has
 * done so.
 */
[[nodiscard]] std::optional<double> chanceInView(const ExportContent& content, const ExportUav& uav,
                                                 const Visit& visit, int iceberg);

/** Ids of the icebergs in view at a visit. */
[[nodiscard]] std::vector<std::string> idsOf(const ExportContent& content, const Visit& visit);

/** How its drift changes, where it does, by the names that scenario files have for it. */
[[nodiscard]] std::vector<std::pair<std::string_view, double>>
driftData(const ExportContent& content, const ExportIceberg& iceberg);

/** Name of what is visited for people: name or id of the iceberg, ids of a cluster, "Home". */
[[nodiscard]] std::string titleOf(const ExportContent& content, const Visit& visit);

/** Its name, or its id when it has none. */
[[nodiscard]] const std::string& titleOf(const Iceberg& iceberg);
[[nodiscard]] const std::string& titleOf(const Uav& uav);

/** A velocity in the plane as east and north at the place, to 1e-9 m/s. */
[[nodiscard]] Point eastNorth_mps(const ExportContent& content, const Point& velocity_mps,
                                  const Point& at_m);

/** Heading in the plane as true heading at the place, degrees in [0, 360). */
[[nodiscard]] double trueHeading_deg(const ExportContent& content, double heading_deg,
                                     const Point& at_m);

/** Where the asset is at `now_s`; there must be one. */
[[nodiscard]] Point assetPlace_m(const ExportContent& content);

/** Each point of the way in turn: its track, or the start and each visit; at least one. */
void eachPoint(const ExportUav& uav, const PointSink& take);

/** The way as a line of the map: `eachPlace`. */
void eachPlace(const ExportContent& content, const ExportUav& uav, const PlaceSink& take);

/** Of that line. */
[[nodiscard]] std::size_t partsOf(const ExportContent& content, const ExportUav& uav);

/** The way in memory, for what is of one page or one hour. */
[[nodiscard]] std::vector<TimedPoint> pathOf(const ExportUav& uav);

/** Its last point. */
[[nodiscard]] TimedPoint endOf(const ExportUav& uav);

} // namespace berg
