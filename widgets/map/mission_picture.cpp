#include "widgets/map/mission_picture.h"

#include "widgets/model/domain_text.h"
#include "widgets/theme/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct MissionPicture
{
    Q_DECLARE_TR_FUNCTIONS(MissionPicture)
};

std::vector<MapReadout> readoutsOf(const FlightRecord& record, const QLocale& locale)
{
    const Metrics& metrics = record.now.metrics;
    return {
        {.caption = MissionPicture::tr("Time"), .value = clockText(record.now.time_s), .unit = {}},
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
    shown.assign(record.now.icebergs.size(), -1);
    for (std::size_t i = 0; i < record.now.icebergs.size(); ++i) {
        if (!record.now.active[i])
            continue;
        const Iceberg& iceberg = record.now.icebergs[i];
        const Track& track = record.now.world.tracks[i];
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

} // namespace

double sigmaScaleEnd_m2(const FlightRecord& record)
{
    constexpr double kShare = 0.95;
    std::vector<double> recorded_m2;
    for (const std::vector<IcebergSample>& row : record.rows)
        for (const IcebergSample& sample : row)
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
    const WorldState& state = record.now.world;
    MapPicture picture;
    picture.title = QString::fromStdString(scenario.name);
    picture.subtitle = policyText(record.now.planner, locale);
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
    if (record.now.plan)
        for (const int iceberg : record.now.plan->order)
            if (const int place = shown[static_cast<std::size_t>(iceberg)]; place >= 0)
                picture.plan.push_back(place);
    for (const Sample& sample : record.samples)
        picture.track.push_back({.position_m = sample.uav.position_m, .time_s = sample.time_s});
    picture.area_m = scenario.area_m;
    if (scenario.asset)
        picture.asset = MapAsset{.name = QString::fromStdString(scenario.asset->name),
                                 .position_m = scenario.asset->position_m};
    picture.sigmaFull_m2 = sigmaScaleEnd_m2(record);
    picture.emptyTitle = MissionPicture::tr("No icebergs yet");
    picture.emptyHint =
        MissionPicture::tr("Add icebergs with their positions to the scenario file, "
                           "then draw the map again.");
    return picture;
}

} // namespace berg
