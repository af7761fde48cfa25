#include "widgets/map/mission_picture.h"

#include "core/vehicle/geofence.h"
#include "widgets/map/map_legs.h"
#include "widgets/map/scenario_picture.h"
#include "widgets/model/asset_approach.h"
#include "widgets/model/domain_text.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MissionPicture
{
    Q_DECLARE_TR_FUNCTIONS(MissionPicture)
};

/** At the time shown; none: it is unlimited. */
std::optional<double> enduranceLeft_s(const FlightRecord& record)
{
    const std::vector<Uav>& uavs = record.scenario.uavs;
    if (uavs.empty() || uavs.front().spec.endurance_s <= 0)
        return std::nullopt;
    const WorldState& world = record.shown().world;
    const bool isOnGround = world.mode == FlightMode::Ground; // made ready for the next sortie
    return uavs.front().spec.endurance_s - (isOnGround ? 0 : world.aloft_s);
}

std::vector<MapReadout> readoutsOf(const FlightRecord& record, const QLocale& locale)
{
    const Metrics& metrics = record.shown().metrics;
    std::vector<MapReadout> readouts{{.caption = MissionPicture::tr("Time"),
                                      .value = clockText(record.shown().time_s),
                                      .unit = {}},
                                     {.caption = MissionPicture::tr("Zeta ζ"),
                                      .value = significantText(metrics.zeta_m2s, 4, locale),
                                      .unit = u"m² s"_s},
                                     {.caption = MissionPicture::tr("Visits"),
                                      .value = fixedText(metrics.visits, 0, locale),
                                      .unit = {}}};
    if (const std::optional<double> left_s = enduranceLeft_s(record))
        readouts.push_back({.caption = MissionPicture::tr("Endurance left"),
                            .value = clockText(*left_s),
                            .unit = {}});
    return readouts;
}

MapIceberg icebergOf(const FlightRecord& record, std::size_t i)
{
    const MissionSnapshot& shown = record.shown();
    const Iceberg& iceberg = shown.icebergs[i];
    const Track& track = shown.world.tracks[i];
    MapIceberg drawn{.id = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name),
                     .position_m = record.estimate_m(i),
                     .velocity_mps = track.velocity_mps,
                     .sigma_m2 = track.sigma_m2,
                     .radius_m = iceberg.radius_m,
                     .inView = track.inView,
                     .key = iceberg.id,
                     .status = track.status};
    if (record.scenario.observer.model == ObserverModel::Kalman) {
        drawn.circle_m = likelyRadius_m(track.sigma_m2);
        drawn.truth_m = shown.truth_m[i];
    }
    if (const std::optional<AssetApproach> approach = approachOf(shown, i))
        drawn.ringEntry_s = approach->entry_s;
    return drawn;
}

/** Icebergs that are there; `shown[i]` is the place of iceberg i in the picture or -1. */
std::vector<MapIceberg> icebergsOf(const FlightRecord& record, std::vector<int>& shown)
{
    std::vector<MapIceberg> icebergs;
    shown.assign(record.shown().icebergs.size(), -1);
    for (std::size_t i = 0; i < record.shown().icebergs.size(); ++i) {
        if (!record.shown().active[i] || record.shown().world.tracks[i].left)
            continue;
        shown[i] = static_cast<int>(icebergs.size());
        icebergs.push_back(icebergOf(record, i));
    }
    return icebergs;
}

/**
 * The way flown until the time shown: every sample of the last stretch, then every second, fourth,
 * ... of each twice as long one before. Which samples are left depends on their places alone, so
 * that the line stands still while it grows.
 */
std::vector<MapTrackPoint> trackOf(const FlightRecord& record)
{
    constexpr std::size_t kDetailed = 500;
    const MissionSnapshot& shown = record.shown();
    const std::vector<Sample>& samples = record.history.samples;
    const auto end = std::upper_bound(samples.begin(), samples.end(), shown.time_s,
                                      [](double t, const Sample& s) { return t < s.time_s; });
    const auto count = static_cast<std::size_t>(end - samples.begin());
    std::vector<MapTrackPoint> track;
    for (std::size_t i = 0; i < count;) {
        track.push_back({.position_m = samples[i].uav.position_m, .time_s = samples[i].time_s});
        const std::size_t stride =
            std::bit_floor(std::max<std::size_t>(1, (count - i) / kDetailed));
        i += stride - i % stride;
    }
    if (!track.empty() && track.back().time_s < shown.time_s)
        track.push_back({.position_m = shown.world.uav.position_m, .time_s = shown.time_s});
    return track;
}

/** Where the UAV was at each sample until the time shown, and is. */
std::vector<MapPose> posesOf(const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    std::vector<MapPose> poses;
    poses.reserve(record.history.samples.size() + 1);
    for (const Sample& sample : record.history.samples) {
        if (sample.time_s > shown.time_s)
            break;
        poses.push_back({.position_m = sample.uav.position_m,
                         .psi_rad = sample.uav.psi_rad,
                         .time_s = sample.time_s});
    }
    if (!poses.empty() && poses.back().time_s < shown.time_s)
        poses.push_back({.position_m = shown.world.uav.position_m,
                         .psi_rad = shown.world.uav.psi_rad,
                         .time_s = shown.time_s});
    return poses;
}

/** Icebergs of an order as places in the picture. */
std::vector<int> placesOf(const std::vector<int>& order, const std::vector<int>& shown)
{
    std::vector<int> places;
    for (const int iceberg : order)
        if (const int place = shown[static_cast<std::size_t>(iceberg)]; place >= 0)
            places.push_back(place);
    return places;
}

/** What is left of the pattern, which drifts with the iceberg's estimate. */
std::vector<Point> searchOf_m(const FlightRecord& record)
{
    const WorldState& world = record.shown().world;
    if (world.mode != FlightMode::Search || !world.search)
        return {};
    const Point datum_m = record.estimate_m(static_cast<std::size_t>(world.search->iceberg));
    const std::vector<Point>& offsets_m = world.search->way.corners_m();
    std::vector<Point> corners_m;
    for (std::size_t k = world.search->way.next(); k < offsets_m.size(); ++k)
        corners_m.emplace_back(datum_m + offsets_m[k]);
    return corners_m;
}

/** Of the straight legs of the plan; none without a geofence. */
std::vector<std::vector<Point>> cornersOf(const MapPicture& picture, const MissionSnapshot& shown)
{
    std::vector<std::vector<Point>> corners_m;
    if (!shown.fence)
        return corners_m;
    Point from_m = shown.world.uav.position_m;
    for (const Point& to_m : planStops_m(picture)) {
        corners_m.push_back(shown.fence->cornersBetween(from_m, to_m));
        from_m = to_m;
    }
    return corners_m;
}

std::vector<std::vector<int>> clustersOf(const PlanEvent& plan, const std::vector<int>& shown)
{
    std::vector<std::vector<int>> clusters;
    for (const std::vector<int>& members : plan.clusters)
        clusters.push_back(placesOf(members, shown));
    return clusters;
}

std::vector<MapWay> mapWays(const std::vector<AimedWay>& ways)
{
    std::vector<MapWay> drawn;
    for (const AimedWay& way : ways) {
        MapWay& next = drawn.emplace_back(MapWay{.path_m = {}, .aim_m = way.aim_m});
        for (const WayPoint& point : way.points)
            next.path_m.push_back(point.position_m);
    }
    return drawn;
}

} // namespace

double sigmaScaleEnd_m2(const FlightRecord& record)
{
    constexpr double kShare = 0.95;
    constexpr std::size_t kEnough = 20000; // values, to know a share of them well
    const std::vector<std::vector<IcebergSample>>& rows = record.history.rows;
    const std::size_t all = rows.empty() ? 0 : rows.size() * rows.back().size();
    const std::size_t stride = std::bit_ceil((all + kEnough - 1) / kEnough);
    std::vector<double> recorded_m2;
    recorded_m2.reserve(2 * kEnough);
    for (std::size_t row = 0; row < rows.size(); row += stride)
        for (const IcebergSample& sample : rows[row])
            recorded_m2.push_back(sample.sigma_m2);
    double end_m2 = 0;
    if (!recorded_m2.empty()) {
        const auto at =
            recorded_m2.begin() +
            static_cast<std::ptrdiff_t>(kShare * static_cast<double>(recorded_m2.size() - 1));
        std::nth_element(recorded_m2.begin(), at, recorded_m2.end());
        end_m2 = *at;
    }
    for (std::size_t i = 0; i < record.now.world.tracks.size(); ++i)
        if (record.now.active[i])
            end_m2 = std::max(end_m2, record.now.world.tracks[i].sigma_m2);
    return roundSigmaScale(end_m2);
}

void hideTruth(MapPicture& picture)
{
    for (MapIceberg& iceberg : picture.icebergs)
        iceberg.truth_m.reset();
    picture.hidesTruth = true;
}

MapPicture missionPicture(const FlightRecord& record, const QLocale& locale)
{
    const Scenario& scenario = record.scenario;
    const WorldState& state = record.shown().world;
    MapPicture picture;
    picture.title = QString::fromStdString(scenario.name);
    picture.subtitle = policyText(record.shown().planner, locale);
    picture.readouts = readoutsOf(record, locale);
    picture.origin = scenario.origin;
    if (!scenario.uavs.empty())
        picture.uav =
            MapUav{.position_m = state.uav.position_m,
                   .psi_rad = state.uav.psi_rad,
                   .sensor = {.fov_m = scenario.uavs.front().fov_m, .shape = scenario.fovShape},
                   .key = scenario.uavs.front().id,
                   .airspeed_mps = scenario.uavs.front().spec.airspeed_mps};
    std::vector<int> shown;
    picture.icebergs = icebergsOf(record, shown);
    if (const std::optional<PlanEvent>& plan = record.shown().plan) {
        picture.plan = placesOf(plan->order, shown);
        picture.thisSortie = plan->thisSortie;
        picture.clusters = clustersOf(*plan, shown);
    }
    picture.planWays = mapWays(waysAhead(record.shown()));
    if (const std::optional<ShownChange> change = record.changeShown()) {
        picture.formerPlan = placesOf(change->change.before, shown);
        picture.formerFrom_m = change->from_m;
        picture.formerWays = mapWays(change->ways);
    }
    picture.search_m = searchOf_m(record);
    picture.track = trackOf(record);
    picture.swept = posesOf(record);
    picture.area_m = scenario.area_m;
    picture.isFenced = scenario.geofence;
    picture.home_m = homeOf(scenario);
    picture.planCorners = cornersOf(picture, record.shown());
    picture.asset = assetOf(record.shown().asset, record.shown().time_s);
    picture.air = airOf(scenario);
    picture.air.wind_mps = record.shown().motion.wind_mps;
    picture.sigmaFull_m2 = sigmaScaleEnd_m2(record);
    picture.emptyTitle = MissionPicture::tr("No icebergs yet");
    picture.emptyHint =
        MissionPicture::tr("Add icebergs with their positions to the scenario file, "
                           "then draw the map again.");
    return picture;
}

} // namespace berg
