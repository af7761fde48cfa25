#include "widgets/map/mission_picture.h"

#include "widgets/map/scenario_picture.h"
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

std::vector<MapReadout> readoutsOf(const FlightRecord& record, const QLocale& locale)
{
    const Metrics& metrics = record.shown().metrics;
    return {{.caption = MissionPicture::tr("Time"),
             .value = clockText(record.shown().time_s),
             .unit = {}},
            {.caption = MissionPicture::tr("Zeta ζ"),
             .value = significantText(metrics.zeta_m2s, 4, locale),
             .unit = u"m² s"_s},
            {.caption = MissionPicture::tr("Visits"),
             .value = fixedText(metrics.visits, 0, locale),
             .unit = {}}};
}

/** Icebergs that have appeared; `shown[i]` is the place of iceberg i in the picture or -1. */
std::vector<MapIceberg> icebergsOf(const FlightRecord& record, std::vector<int>& shown)
{
    std::vector<MapIceberg> icebergs;
    shown.assign(record.shown().icebergs.size(), -1);
    for (std::size_t i = 0; i < record.shown().icebergs.size(); ++i) {
        if (!record.shown().active[i])
            continue;
        const Iceberg& iceberg = record.shown().icebergs[i];
        const Track& track = record.shown().world.tracks[i];
        shown[i] = static_cast<int>(icebergs.size());
        icebergs.push_back(
            {.id = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name),
             .position_m = record.estimate_m(i),
             .velocity_mps = iceberg.velocity_mps + record.scenario.current_mps,
             .sigma_m2 = track.sigma_m2,
             .radius_m = iceberg.radius_m,
             .inView = track.inView,
             .key = iceberg.id});
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
                   .key = scenario.uavs.front().id};
    std::vector<int> shown;
    picture.icebergs = icebergsOf(record, shown);
    if (record.shown().plan)
        picture.plan = placesOf(record.shown().plan->order, shown);
    picture.planWays = mapWays(waysAhead(record.shown(), scenario));
    if (const std::optional<ShownChange> change = record.changeShown()) {
        picture.formerPlan = placesOf(change->change.before, shown);
        picture.formerFrom_m = change->from_m;
        picture.formerWays = mapWays(change->ways);
    }
    picture.track = trackOf(record);
    picture.swept = posesOf(record);
    picture.area_m = scenario.area_m;
    picture.asset = assetOf(record.shown().asset, record.shown().time_s);
    picture.sigmaFull_m2 = sigmaScaleEnd_m2(record);
    picture.emptyTitle = MissionPicture::tr("No icebergs yet");
    picture.emptyHint =
        MissionPicture::tr("Add icebergs with their positions to the scenario file, "
                           "then draw the map again.");
    return picture;
}

} // namespace berg
