#include "widgets/map/picture/mission_picture.h"

#include "core/tracking/position_error.h"
#include "core/vehicle/geofence.h"
#include "widgets/flight/asset_approach.h"
#include "widgets/flight/planned_sorties.h"
#include "widgets/flight/sigma_end.h"
#include "widgets/map/picture/plan_stops.h"
#include "widgets/map/picture/scenario_picture.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/policy_words.h"

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

/** Flying time left at the time shown, until the reserve; the full one on the ground. */
double enduranceLeft_s(const FlightRecord& record, std::size_t uav)
{
    const UavState& state = record.shown().world.uavs[uav];
    const bool isOnGround = state.mode == FlightMode::Ground; // made ready for the next sortie
    return usableEndurance_s(record.scenario.uavs[uav].spec) - (isOnGround ? 0 : state.aloft_s);
}

/** Shows the least endurance left in the fleet; nullopt if all UAVs have an unlimited one. */
std::optional<MapReadout> enduranceReadout(const FlightRecord& record,
                                           const std::vector<MapUav>& uavs)
{
    std::optional<std::size_t> least;
    for (std::size_t uav = 0; uav < uavs.size(); ++uav)
        if (record.scenario.uavs[uav].spec.endurance_s > 0 &&
            (!least || enduranceLeft_s(record, uav) < enduranceLeft_s(record, *least)))
            least = uav;
    if (!least)
        return std::nullopt;
    return MapReadout{.caption = MissionPicture::tr("Until the reserve"),
                      .value = clockText(enduranceLeft_s(record, *least)),
                      .unit = uavs[*least].label,
                      .rank = 2};
}

/**
 * Shows the smallest margin above the reserve in the fleet, or a dash if no UAV is in the air or
 * all were sent home; nullopt if all have unlimited endurance. The readout is there before
 * take-off, too, so that the panel keeps its size.
 */
std::optional<MapReadout> homeMarginReadout(const FlightRecord& record)
{
    std::optional<double> least_s;
    const std::vector<std::optional<double>>& margins_s = record.shown().homeMargins_s;
    const std::size_t uavs = std::min(margins_s.size(), record.scenario.uavs.size());
    for (std::size_t uav = 0; uav < uavs; ++uav)
        if (margins_s[uav] && record.scenario.uavs[uav].spec.endurance_s > 0)
            least_s = std::min(least_s.value_or(*margins_s[uav]), *margins_s[uav]);
    const auto isUnlimited = [](const Uav& uav) { return uav.spec.endurance_s <= 0; };
    if (std::ranges::all_of(record.scenario.uavs, isUnlimited))
        return std::nullopt;
    return MapReadout{.caption = MissionPicture::tr("Above the reserve"),
                      .value = least_s ? marginText(*least_s) : u"–"_s,
                      .unit = MissionPicture::tr("if home now"),
                      .rank = 1};
}

/** Returns nullopt if UAVs in one altitude layer have stayed well apart. */
std::optional<MapReadout> closestReadout(const FlightRecord& record, const QLocale& locale)
{
    constexpr double kNear = 2; // times the required separation
    const std::optional<double> closest_m = record.shown().world.closest_m;
    if (!closest_m || *closest_m >= kNear * record.scenario.separation_m)
        return std::nullopt;
    const ShownUnit unit = distanceUnit();
    return MapReadout{.caption = MissionPicture::tr("Closest so far"),
                      .value = significantText(unit.fromSi(*closest_m), 3, locale),
                      .unit = unit.name,
                      .rank = 1};
}

std::vector<MapReadout> readoutsOf(const FlightRecord& record, const std::vector<MapUav>& uavs,
                                   const QLocale& locale)
{
    const Metrics& metrics = record.shown().metrics;
    const ShownUnit zeta = zetaUnit(metrics.zeta_m2s);
    std::vector<MapReadout> readouts{
        {.caption = MissionPicture::tr("Time"),
         .value = clockOf(record.scenario).text(record.shown().time_s),
         .unit = {}},
        {.caption = MissionPicture::tr("Zeta ζ"),
         .value = significantText(zeta.fromSi(metrics.zeta_m2s), 4, locale),
         .unit = zeta.name,
         .rank = 3},
        {.caption = MissionPicture::tr("Visits"),
         .value = fixedText(metrics.visits, 0, locale),
         .unit = {},
         .rank = 4}};
    for (const std::optional<MapReadout>& more :
         {enduranceReadout(record, uavs), homeMarginReadout(record),
          closestReadout(record, locale)})
        if (more)
            readouts.push_back(*more);
    return readouts;
}

MapIceberg icebergOf(const FlightRecord& record, IcebergIndex index)
{
    const std::size_t i = toIndex(index);
    const MissionSnapshot& shown = record.shown();
    const Iceberg& iceberg = shown.icebergs[i];
    const Track& track = shown.world.tracks[i];
    MapIceberg drawn{.id = QString::fromStdString(iceberg.name.empty() ? iceberg.id : iceberg.name),
                     .position_m = record.estimate_m(index),
                     .velocity_mps = track.velocity_mps,
                     .sigma_m2 = track.sigma_m2,
                     .radius_m = iceberg.radius_m,
                     .inView = track.inView,
                     .key = iceberg.id,
                     .status = track.status,
                     .assignedUav = shown.assigned[i]};
    if (record.scenario.observer.model == ObserverModel::Kalman) {
        drawn.circle_m = radius95_m(track.sigma_m2);
        drawn.truth_m = shown.truth_m[i];
    }
    if (const std::optional<AssetApproach> approach = approachOf(shown, index))
        drawn.ringEntry_s = approach->entry_s;
    return drawn;
}

/** Returns the icebergs present now and sets `shown` to their places. */
std::vector<MapIceberg> icebergsOf(const FlightRecord& record, ShownPlaces& shown)
{
    std::vector<MapIceberg> icebergs;
    shown.assign(record.shown().icebergs.size(), std::nullopt);
    for (const IcebergIndex i : IcebergRange(record.shown().icebergs.size())) {
        if (!record.shown().active[toIndex(i)] || record.shown().world.tracks[toIndex(i)].left)
            continue;
        shown[toIndex(i)] = MapPlace::of(icebergs.size());
        icebergs.push_back(icebergOf(record, i));
    }
    return icebergs;
}

/**
 * Track flown until the time shown: every sample of the last stretch, then every second, fourth,
 * ... sample of older stretches of twice the length each. A sample is chosen by its index alone, so
 * that the line does not jitter while it grows.
 */
std::vector<MapTrackPoint> trackOf(const FlightRecord& record, std::size_t uav)
{
    constexpr std::size_t kDetailed = 500;
    const MissionSnapshot& shown = record.shown();
    const std::vector<Sample>& samples = record.history.samples;
    const auto end = std::upper_bound(samples.begin(), samples.end(), shown.time_s,
                                      [](double t, const Sample& s) { return t < s.time_s; });
    const auto count = static_cast<std::size_t>(end - samples.begin());
    std::vector<MapTrackPoint> track;
    for (std::size_t i = 0; i < count;) {
        track.push_back(
            {.position_m = samples[i].uavs[uav].pose.position_m, .time_s = samples[i].time_s});
        const std::size_t stride =
            std::bit_floor(std::max<std::size_t>(1, (count - i) / kDetailed));
        i += stride - i % stride;
    }
    if (!track.empty() && track.back().time_s < shown.time_s)
        track.push_back(
            {.position_m = shown.world.uavs[uav].pose.position_m, .time_s = shown.time_s});
    return track;
}

MapPose mapPose(const DubinsState& pose, double time_s)
{
    return {.position_m = pose.position_m, .psi_rad = pose.psi_rad, .time_s = time_s};
}

/** Appends the poses after the first `samples` ones until the time shown; returns their number. */
std::size_t addPoses(std::vector<MapPose>& poses, std::size_t samples, const FlightRecord& record,
                     std::size_t uav)
{
    const MissionSnapshot& shown = record.shown();
    const std::vector<Sample>& all = record.history.samples;
    poses.resize(samples);
    for (; samples < all.size() && all[samples].time_s <= shown.time_s; ++samples)
        poses.push_back(mapPose(all[samples].uavs[uav].pose, all[samples].time_s));
    if (!poses.empty() && poses.back().time_s < shown.time_s)
        poses.push_back(mapPose(shown.world.uavs[uav].pose, shown.time_s));
    return samples;
}

/** Remaining corners of the search pattern, which drifts with the iceberg's estimate. */
std::vector<Point> searchOf_m(const FlightRecord& record, std::size_t uav)
{
    const UavState& state = record.shown().world.uavs[uav];
    if (state.mode != FlightMode::Search || !state.search)
        return {};
    const Point datum_m = record.estimate_m(state.search->iceberg);
    const std::vector<Point>& offsets_m = state.search->path.corners_m();
    std::vector<Point> corners_m;
    for (std::size_t k = state.search->path.next(); k < offsets_m.size(); ++k)
        corners_m.emplace_back(datum_m + offsets_m[k]);
    return corners_m;
}

/** Geofence corners that each straight leg of the plan follows; empty without a geofence. */
std::vector<std::vector<Point>> cornersOf(const MapPicture& picture, const MissionSnapshot& shown,
                                          std::size_t uav)
{
    std::vector<std::vector<Point>> corners_m;
    const Geofence* fence = shown.fences[uav].get();
    if (fence == nullptr)
        return corners_m;
    Point from_m = shown.world.uavs[uav].pose.position_m;
    for (const Point& to_m : planStops_m(picture, uav)) {
        corners_m.push_back(fence->cornersBetween(from_m, to_m));
        from_m = to_m;
    }
    return corners_m;
}

/** Clusters of the newest plan in force, of its first UAV. */
std::vector<MapPlaces> clustersOf(const MissionSnapshot& now, const ShownPlaces& shown)
{
    std::vector<MapPlaces> clusters;
    const UavPlan* newest = nullptr;
    double newest_s = -1;
    for (std::size_t uav = 0; uav < now.plans.size(); ++uav)
        if (now.plans[uav] && now.plans[uav]->time_s > newest_s) {
            newest = planOf(now, static_cast<int>(uav));
            newest_s = now.plans[uav]->time_s;
        }
    if (newest != nullptr)
        for (const IcebergList& members : newest->clusters)
            clusters.push_back(placesOf(members, shown));
    return clusters;
}

std::vector<MapPath> mapPaths(const std::vector<AimedPath>& paths)
{
    std::vector<MapPath> drawn;
    for (const AimedPath& path : paths) {
        MapPath& next = drawn.emplace_back(MapPath{.path_m = {}, .aim_m = path.aim_m});
        for (const PathPoint& point : path.points)
            next.path_m.push_back(point.position_m);
    }
    return drawn;
}

std::vector<MapSearchPlace> searchPlacesOf(const UavPlan& plan, double time_s)
{
    std::vector<MapSearchPlace> places;
    if (plan.outlook)
        for (const PlannedSearch& search : plan.outlook->searches)
            if (search.time_s > time_s)
                places.push_back({.position_m = search.place_m, .chance = search.chance});
    return places;
}

MapUav uavOf(const FlightRecord& record, std::size_t uav)
{
    const UavState& state = record.shown().world.uavs[uav];
    MapUav drawn = mapUav(record.scenario, uav);
    const Point& home_m = record.shown().homes_m[uav];
    if (drawn.home_m || home_m != drawn.position_m) // else its start, with unlimited endurance
        drawn.home_m = home_m;
    drawn.position_m = state.pose.position_m;
    drawn.psi_rad = state.pose.psi_rad;
    drawn.isAloft = state.mode != FlightMode::Ground;
    return drawn;
}

/** Sets the points of no return on the plans of UAVs with a limited endurance. */
void markNoReturn(MapPicture& picture, const FlightRecord& record)
{
    const std::vector<Uav>& uavs = record.scenario.uavs;
    if (std::ranges::all_of(uavs, [](const Uav& uav) { return uav.spec.endurance_s == 0; }))
        return;
    const auto paths = plannedPaths(record.shown(), record.scenario);
    for (std::size_t uav = 0; uav < picture.routes.size(); ++uav) {
        if (!paths[uav])
            continue;
        SortieOutlook outlook = sortieOutlook(record.scenario, uavs[uav], *paths[uav]);
        if (outlook.noReturn && !record.isOver())
            picture.routes[uav].toNoReturn_m = std::move(outlook.noReturn->path_m);
    }
}

/** Returns the places where a patrol will meet its icebergs, by their present estimates. */
std::vector<Point> laterVisits_m(const UavPlan& plan, const WorldState& world, double now_s)
{
    std::vector<Point> places_m;
    for (const PlannedVisit& visit : plan.laterVisits)
        if (visit.time_s > now_s)
            places_m.push_back(world.tracks.at(toIndex(visit.iceberg)).estimate_m(visit.time_s));
    return places_m;
}

/** Route without the geofence corners, which depend on other parts of the picture. */
MapRoute routeOf(const FlightRecord& record, std::size_t uav, const ShownPlaces& shown,
                 SweptPaths& swept)
{
    const int place = static_cast<int>(uav);
    MapRoute route;
    const UavState& state = record.shown().world.uavs[uav];
    const UavPlan* plan = planOf(record.shown(), place);
    if (plan != nullptr && state.isPlanned() &&
        !record.isOver()) { // else others visit its icebergs
        route.plan = placesOf(plan->order, shown);
        route.thisSortie = plan->thisSortie;
        route.planPaths = mapPaths(pathsAhead(record.shown(), place));
        route.laterVisits_m = laterVisits_m(*plan, record.shown().world, record.shown().time_s);
        route.searchPlaces = searchPlacesOf(*plan, record.shown().time_s);
    } else if (state.mode == FlightMode::Home && !record.isOver()) {
        route.thisSortie = 0; // straight home
    }
    if (const std::optional<ShownChange> change = record.changeShown(place)) {
        route.formerPlan = placesOf(change->change.before, shown);
        route.formerFrom_m = change->from_m;
        route.formerPaths = mapPaths(change->paths);
    }
    route.search_m = searchOf_m(record, uav);
    route.track = trackOf(record, uav);
    route.swept = swept.of(record, uav);
    return route;
}

/** Sets wind and current of the flight at the time shown. */
void setAir(MapAir& air, const FlightRecord& record)
{
    const MissionSnapshot& shown = record.shown();
    if (!shown.motions.empty())
        air.wind_mps = shown.motions.front().wind_mps;
    air.isFixed = false;
    if (air.forecast.isEmpty())
        return;
    const std::shared_ptr<const WeatherCourse> course = weatherOfRun(record);
    const CoursePoint weather = course->at(shown.time_s);
    air.current_mps = weather.current_mps.value_or(record.scenario.current_mps);
    air.gust_mps = weather.gust_mps;
    air.isReported = course->reported_s && *course->reported_s <= shown.time_s;
}

} // namespace

void hideTruth(MapPicture& picture)
{
    for (MapIceberg& iceberg : picture.icebergs)
        iceberg.truth_m.reset();
    picture.hidesTruth = true;
}

void addComparison(MapPicture& picture, const ComparedRun& run, double until_s,
                   const QLocale& locale)
{
    picture.comparisonName = runName(run, locale);
    picture.comparisonTracks.assign(run.scenario.uavs.size(), {});
    for (const Sample& sample : run.samples) {
        if (sample.time_s > until_s)
            break;
        for (std::size_t uav = 0; uav < picture.comparisonTracks.size(); ++uav)
            picture.comparisonTracks[uav].push_back(
                {.position_m = sample.uavs[uav].pose.position_m, .time_s = sample.time_s});
    }
}

SweptPointer SweptPaths::of(const FlightRecord& record, std::size_t uav)
{
    if (record.instant) { // the shared list continues past this instant
        std::vector<MapPose> poses;
        addPoses(poses, 0, record, uav);
        return std::make_shared<const std::vector<MapPose>>(std::move(poses));
    }
    if (record.now.generation != m_generation || record.history.rewrites != m_rewrites)
        m_paths.clear();
    m_generation = record.now.generation;
    m_rewrites = record.history.rewrites;
    m_paths.resize(std::max(m_paths.size(), uav + 1));
    Path& path = m_paths[uav];
    if (!path.poses || path.samples > record.history.samples.size())
        path = {.poses = std::make_shared<std::vector<MapPose>>()};
    path.samples = addPoses(*path.poses, path.samples, record, uav);
    return path.poses;
}

MapWeatherPointer SweptPaths::weatherOf(const FlightRecord& record)
{
    return m_weather.at(record.scenario, record.now.generation, record.shown().time_s);
}

MapPicture mapPicture(const FlightRecord& record, const QLocale& locale, SweptPaths& swept)
{
    MapPicture picture = missionPicture(record, locale, swept);
    return record.inFlight() ? picture : withScenario(std::move(picture), record.scenario);
}

MapPicture missionPicture(const FlightRecord& record, const QLocale& locale)
{
    SweptPaths swept;
    return missionPicture(record, locale, swept);
}

MapPicture missionPicture(const FlightRecord& record, const QLocale& locale, SweptPaths& swept)
{
    const Scenario& scenario = record.scenario;
    MapPicture picture;
    picture.title = QString::fromStdString(scenario.name);
    picture.subtitle = policyText(record.shown().planner, locale);
    picture.times = timesOf(record);
    ShownPlaces shown;
    picture.icebergs = icebergsOf(record, shown);
    picture.clusters = clustersOf(record.shown(), shown);
    // An edited scenario may have more or fewer UAVs than the mission until it is planned.
    const std::size_t uavs = std::min(scenario.uavs.size(), record.shown().world.uavs.size());
    for (std::size_t uav = 0; uav < uavs; ++uav) {
        picture.uavs.push_back(uavOf(record, uav));
        picture.routes.push_back(routeOf(record, uav, shown, swept));
        picture.routes[uav].planCorners = cornersOf(picture, record.shown(), uav);
    }
    picture.readouts = readoutsOf(record, picture.uavs, locale);
    setSurroundings(picture, scenario, record.shown().asset, record.shown().time_s);
    markNoReturn(picture, record);
    setAir(picture.air, record);
    picture.weather = swept.weatherOf(record);
    picture.sigmaFull_m2 = sigmaEnd_m2(scenario);
    picture.emptyTitle = MissionPicture::tr("No icebergs yet");
    picture.emptyHint =
        MissionPicture::tr("Add icebergs with their positions to the scenario file, "
                           "then draw the map again.");
    return picture;
}

} // namespace berg
