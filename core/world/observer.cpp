#include "core/world/observer.h"

#include "core/base/angles.h"
#include "core/geometry/enclosing_circle.h"
#include "core/scenario/initial_truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

/** Probability of presence before the first missed sample; the rest covers errors of the filter. */
constexpr double kBelieved = 0.99;
/** An iceberg whose probability of presence falls below this is lost. */
constexpr double kLostBelow = 0.1;
/**
 * Squared normalised distance that one position in a thousand exceeds (chi-squared, two degrees of
 * freedom). A sighting farther from the given position is taken as proof that it was wrong.
 */
constexpr double kBelievable = 13.8;
/** Least standard deviation of a given velocity that a sighting has disproved. */
constexpr double kFoundVelocitySd_mps = 0.1;

} // namespace

Observer::Observer(const Scenario& scenario, std::span<const DriftNoise> noise)
    : m_world(scenario)
    , m_cameras(scenario.reachRadius_m, m_world.weather()
                                            ? Point(m_world.weather()->strongestWind_mps(), 0)
                                            : scenario.wind_mps)
    , m_searches(scenario.uavs.size())
    , m_area_m(scenario.area_m)
    , m_sampleSteps(
          std::max<std::int64_t>(1, std::llround(scenario.observer.interval_s / scenario.dt_s)))
{
    require(noise.empty() || noise.size() == scenario.icebergs.size(),
            "Simulation: noise of another scenario");
    for (const Uav& uav : scenario.uavs)
        m_cameras.add(
            {.sensor = {.fov_m = uav.fov_m, .shape = scenario.fovShape},
             .airspeed_mps = uav.spec.airspeed_mps,
             .pose = {.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)}});
    for (std::size_t i = 0; i < scenario.icebergs.size(); ++i) {
        const Iceberg& iceberg = scenario.icebergs[i];
        require(noise.empty() || noise[i].isOf(m_world.seed(), iceberg.id),
                "Simulation: noise of another scenario");
        insert(iceberg, noise.empty() ? DriftNoise(m_world.seed(), iceberg.id) : noise[i], 0,
               std::llround(iceberg.appears_s / scenario.dt_s));
    }
    StepReport start;
    observe(0, start);
    m_newlyAppeared.clear();
}

IcebergIndex Observer::insert(const Iceberg& iceberg, DriftNoise noise, double start_s,
                              std::int64_t appearsStep)
{
    const IcebergIndex added = m_world.add(iceberg, std::move(noise), start_s, appearsStep);
    m_checkStep.push_back(appearsStep);
    m_nextCheckStep = std::min(m_nextCheckStep, appearsStep);
    Track track = m_world.parameters(added).start;
    // An iceberg that appears later has drifted unseen until then; after the run it never appears.
    const std::int64_t until =
        m_world.forcing(added) ? std::min(appearsStep, m_world.lastStep()) : appearsStep;
    growUnseen(track, m_world.forcing(added), start_s, static_cast<double>(until) * m_world.dt_s());
    m_tracks.push_back(std::move(track));
    return added;
}

void Observer::addIceberg(const Iceberg& iceberg)
{
    const IcebergIndex added =
        insert(iceberg, DriftNoise(m_world.seed(), iceberg.id), m_world.time_s(), m_world.step());
    const Point truth_m = m_world.truth_m(added);
    if (m_world.observer().model == ObserverModel::Simple && m_cameras.viewer(truth_m))
        m_tracks.back().seen(truth_m, m_world.time_s());
}

void Observer::reportSighting(IcebergIndex iceberg, double age_s, StepReport& report)
{
    require(active(iceberg), "reportSighting: the iceberg has not appeared");
    require(age_s >= 0, "reportSighting: a sighting in the future");
    Track& track = m_tracks[toIndex(iceberg)];
    const double growth_m2 = age_s * track.q_m2ps;
    if (age_s > 0 && growth_m2 >= track.sigma_m2 && track.status == TrackStatus::Tracked)
        return;
    const bool inView = track.inView;
    const double seen_s = std::max(track.seen_s, m_world.time_s() - age_s);
    if (m_world.observer().model == ObserverModel::Simple) {
        track.seen(m_world.truth_m(iceberg), m_world.time_s());
        track.sigma_m2 = growth_m2;
        if (track.status != TrackStatus::Tracked)
            found(iceberg, std::nullopt, report);
    } else
        measure(iceberg, m_world.truth_m(iceberg), measurementVariance_m2() + growth_m2,
                std::nullopt, report);
    track.seen_s = seen_s;
    track.inView = inView;
}

double Observer::measurementVariance_m2() const
{
    return m_world.observer().positionSd_m * m_world.observer().positionSd_m;
}

void Observer::setWind(const Point& wind_mps)
{
    m_cameras.setWind(wind_mps);
    // UAVs may reach icebergs earlier in the new wind.
    m_nextCheckStep = m_world.step() + 1;
    for (const IcebergIndex i : m_world.icebergs())
        m_checkStep[toIndex(i)] = std::max(m_world.step() - m_world.age(i), m_nextCheckStep);
}

void Observer::observe(double dt_s, StepReport& report)
{
    m_newlySeen.clear();
    m_newlyAppeared.clear();
    if (m_world.weather())
        followForcing();
    const bool isSecond = m_world.isWholeSecond();
    // Icebergs out of reach are not sampled for long; this leaves `truth_m` at most a second to
    // draw.
    if (isSecond)
        m_world.advanceDrift();
    const bool isFiltered = m_world.observer().model == ObserverModel::Kalman;
    if (isFiltered)
        sampleMeasurements(dt_s, report);
    else
        sampleAllInReach(report);
    if (!isFiltered && isSecond)
        watchEstimates(report);
    if (!m_area_m.empty() && isSecond)
        watchArea(report);
    double sigmaSum_m2 = 0;
    for (const IcebergIndex i : m_world.icebergs()) {
        Track& track = m_tracks[toIndex(i)];
        const std::int64_t age = m_world.age(i);
        if (age < 0)
            continue;
        if (!isFiltered && !track.inView && age > 0)
            track.sigma_m2 += track.q_m2ps * dt_s; // Eq. (22), since the velocity is known
        if (!track.left)
            sigmaSum_m2 += track.sigma_m2;
    }
    m_sigmaSum_m2 = sigmaSum_m2;
}

/** Predicts with the mean velocities of a new step of the weather, at the places of the estimates.
 */
void Observer::followForcing()
{
    const std::int64_t step = DriftForcing::stepAt(m_world.time_s());
    if (step == m_forcingStep)
        return;
    m_forcingStep = step;
    for (const IcebergIndex i : m_world.icebergs())
        if (m_world.forcing(i) != nullptr && m_world.age(i) >= 0)
            m_tracks[toIndex(i)].setMean(m_world.forcing(i)->mean_mps(estimate_m(i), step),
                                         m_world.time_s());
}

void Observer::sampleAllInReach(StepReport& report)
{
    if (m_nextCheckStep > m_world.step())
        return;
    m_nextCheckStep = m_world.lastStep() + 1;
    for (const IcebergIndex i : m_world.icebergs()) {
        const std::int64_t& checkStep = m_checkStep[toIndex(i)];
        if (checkStep <= m_world.step())
            sampleIceberg(i, report);
        m_nextCheckStep = std::min(m_nextCheckStep, checkStep);
    }
}

/** Tests whether the iceberg is in view now, and if not, when it can be next. */
void Observer::sampleIceberg(IcebergIndex iceberg, StepReport& report)
{
    if (m_world.age(iceberg) == 0)
        m_newlyAppeared.push_back(iceberg);
    Track& track = m_tracks[toIndex(iceberg)];
    const Point truth_m = m_world.position_m(iceberg);
    const std::optional<int> uav = m_cameras.viewer(truth_m);
    if (!uav) {
        track.inView = false;
        m_checkStep[toIndex(iceberg)] =
            m_world.step() +
            m_cameras.stepsOutOfReach(truth_m, m_world.speedLimit_mps(iceberg), m_world.dt_s());
        return;
    }
    m_checkStep[toIndex(iceberg)] = m_world.step() + 1;
    if (!track.inView && !track.left)
        m_newlySeen.push_back({.iceberg = iceberg, .uav = uav});
    track.seen(truth_m, m_world.time_s());
    if (track.status != TrackStatus::Tracked)
        found(iceberg, uav, report);
}

void Observer::found(IcebergIndex iceberg, std::optional<int> seenBy, StepReport& report)
{
    m_tracks[toIndex(iceberg)].status = TrackStatus::Tracked;
    m_searches.end(iceberg);
    report.add({.kind = EventKind::Found, .iceberg = iceberg, .uav = seenBy}, PlanReason::Found);
}

/**
 * Once a second in the simple model: an iceberg out of view whose estimate is in the middle of a
 * view is lost, and searched for as with measurements.
 */
void Observer::watchEstimates(StepReport& report)
{
    std::vector<FieldOfView> views; // built on first use
    const auto seenNow = [&]() -> const std::vector<FieldOfView>& {
        return views.empty() ? views = m_cameras.views() : views;
    };
    for (const IcebergIndex i : m_world.icebergs()) {
        if (!active(i) || track(i).inView)
            continue;
        const Point estimate_m = this->estimate_m(i);
        if (track(i).status != TrackStatus::Tracked) {
            m_searches.grow(i, track(i).q_m2ps);
            m_searches.miss(i, seenNow(), estimate_m, 1);
        } else if (m_cameras.viewer(estimate_m)) {
            if (const std::optional<int> uav = firstWith(m_cameras.middles(), estimate_m))
                lose(i, *uav, seenNow(), report);
        }
    }
}

void Observer::sampleMeasurements(double dt_s, StepReport& report)
{
    for (const IcebergIndex i : m_world.icebergs()) {
        const std::int64_t age = m_world.age(i);
        if (age == 0)
            m_newlyAppeared.push_back(i);
        if (age <= 0)
            continue;
        Track& track = m_tracks[toIndex(i)];
        const double before_m2 = track.sigma_m2;
        track.grow(dt_s);
        m_searches.grow(i, track.sigma_m2 - before_m2);
    }
    if (m_world.step() % m_sampleSteps != 0)
        return;
    const std::vector<FieldOfView> views = m_cameras.views();
    const std::vector<FieldOfView> middles = m_cameras.middles();
    for (const IcebergIndex i : m_world.icebergs()) {
        if (m_world.age(i) < 0)
            continue;
        const Point truth_m = m_world.position_m(i);
        const std::optional<int> seenBy = firstWith(views, truth_m);
        if (!seenBy) {
            miss(i, views, middles, report);
            continue;
        }
        // Several UAVs that sample an iceberg at once share one random draw.
        const SampleDraw draw = m_world.sampleDraw(i, m_world.step() / m_sampleSteps);
        if (draw.chance < m_world.observer().detection)
            measure(i, truth_m + m_world.observer().positionSd_m * draw.noise,
                    measurementVariance_m2(), seenBy, report);
        else
            miss(i, views, middles, report);
    }
}

void Observer::measure(IcebergIndex iceberg, const Point& measured_m, double variance_m2,
                       std::optional<int> seenBy, StepReport& report)
{
    Track& track = m_tracks[toIndex(iceberg)];
    if (!track.inView && !track.left)
        m_newlySeen.push_back({.iceberg = iceberg, .uav = seenBy});
    track.inView = true;
    track.presence = 1;
    if (track.status == TrackStatus::Tracked) {
        track.measured(measured_m, variance_m2, m_world.time_s());
        return;
    }
    // The filter was wrong, so it restarts from the given state. The place of the sighting shows
    // how the iceberg has moved since, unless that state makes the place too unlikely.
    const double time_s = m_world.time_s();
    Track given = m_world.parameters(iceberg).start;
    growUnseen(given, m_world.forcing(iceberg), given.anchor_s, time_s);
    if ((measured_m - given.estimate_m(time_s)).squaredNorm() >
        kBelievable * (given.sigma_m2 + variance_m2)) {
        given.anchor_m = measured_m;
        given.anchor_s = time_s;
        given.setVariances(
            {.position_m2 = variance_m2,
             .velocity_m2ps2 =
                 std::max(given.velocity_m2ps2, kFoundVelocitySd_mps * kFoundVelocitySd_mps)});
    } else {
        given.measured(measured_m, variance_m2, time_s);
    }
    track.anchor_m = given.anchor_m;
    track.anchor_s = given.anchor_s;
    track.seen_s = time_s;
    track.velocity_mps = given.velocity_mps;
    track.mean_mps = given.mean_mps;
    track.setVariances(given.variances());
    found(iceberg, seenBy, report);
}

/** Takes up a camera sample that did not show the iceberg. */
void Observer::miss(IcebergIndex iceberg, std::span<const FieldOfView> views,
                    std::span<const FieldOfView> middles, StepReport& report)
{
    Track& track = m_tracks[toIndex(iceberg)];
    const Point estimate_m = this->estimate_m(iceberg);
    if (track.status != TrackStatus::Tracked) {
        m_searches.miss(iceberg, views, estimate_m, m_world.observer().detection);
        if (track.status == TrackStatus::Lost)
            m_searches.missOfPlan(iceberg, views, estimate_m, m_world.observer().detection);
    } else if (!firstWith(views, estimate_m)) {
        track.inView = false;
        track.presence = 1;
    } else if (const std::optional<int> uav = firstWith(middles, estimate_m)) {
        track.presence =
            afterMiss(std::min(track.presence, kBelieved), m_world.observer().detection);
        if (track.presence < kLostBelow && !track.left)
            lose(iceberg, *uav, views, report);
    }
}

/**
 * Marks the iceberg as lost. The UAV that missed it searches for it, unless it already searches for
 * another.
 */
void Observer::lose(IcebergIndex iceberg, int uav, std::span<const FieldOfView> views,
                    StepReport& report)
{
    const Camera& camera = m_cameras.of(uav);
    Track& track = m_tracks[toIndex(iceberg)];
    track.inView = false;
    track.status = TrackStatus::Lost;
    report.add({.kind = EventKind::Lost, .iceberg = iceberg, .uav = uav}, PlanReason::Lost);
    LostSearch path(m_world.observer(), camera.sensor, std::sqrt(track.sigma_m2),
                    camera.pose.psi_rad);
    for (const FieldOfView& view : views)
        path.miss(view, estimate_m(iceberg), m_world.observer().detection);
    // In the simple model sigma follows Eq. (22).
    if (m_world.observer().model == ObserverModel::Kalman)
        track.sigma_m2 = std::max(track.sigma_m2, path.variance_m2());
    Search search{.iceberg = iceberg, .path = std::move(path)};
    if (m_isLeftToPlan)
        m_searches.giveUp(std::move(search));
    // A UAV searches for one iceberg at a time: by the end of that search the next is far behind.
    else if (!m_searches.of(uav) && camera.maySearch && search.path.hasCorner())
        m_searches.begin(uav, std::move(search));
    else
        giveUp(std::move(search), uav, report);
}

void Observer::giveUp(Search search, int uav, StepReport& report)
{
    noteGivenUp(search.iceberg, uav, report);
    m_searches.giveUp(std::move(search));
}

void Observer::noteGivenUp(IcebergIndex iceberg, int uav, StepReport& report)
{
    m_tracks[toIndex(iceberg)].status = TrackStatus::GivenUp;
    report.add({.kind = EventKind::GivenUp, .iceberg = iceberg, .uav = uav}, PlanReason::GivenUp);
}

void Observer::leaveToPlan(int uav)
{
    m_isLeftToPlan = true;
    if (m_searches.of(uav))
        m_searches.giveUp(m_searches.take(uav));
    for (const Search& search : m_searches.givenUp())
        m_tracks[toIndex(search.iceberg)].status = TrackStatus::Lost;
}

void Observer::takeFromPlan(int uav, StepReport& report)
{
    if (!std::exchange(m_isLeftToPlan, false))
        return;
    for (const Search& search : m_searches.givenUp())
        noteGivenUp(search.iceberg, uav, report);
}

void Observer::beginSearch(int uav, Search search)
{
    m_searches.end(search.iceberg);
    m_tracks[toIndex(search.iceberg)].status = TrackStatus::Lost;
    m_searches.begin(uav, std::move(search));
}

/**
 * Stops monitoring icebergs that are farther outside the area than their radius, until their
 * estimate is inside again.
 */
void Observer::watchArea(StepReport& report)
{
    for (const IcebergIndex i : m_world.icebergs()) {
        if (m_world.age(i) < 0)
            continue;
        Track& track = m_tracks[toIndex(i)];
        const bool isInside = insidePolygon(m_area_m, estimate_m(i));
        if (track.left && isInside) {
            track.left = false;
            m_newlyAppeared.push_back(i);
            if (const std::optional<int> uav = m_cameras.viewer(m_world.truth_m(i));
                track.inView && uav) {
                m_newlySeen.push_back({.iceberg = i, .uav = uav});
                std::ranges::stable_sort(m_newlySeen, {}, &SeenIceberg::iceberg);
            }
        } else if (!track.left && !isInside &&
                   distanceToEdges(m_area_m, estimate_m(i)) > m_world.parameters(i).radius_m) {
            track.left = true;
            // An iceberg that returns is not searched for elsewhere.
            track.status = TrackStatus::Tracked;
            report.add({.kind = EventKind::Left, .iceberg = i}, PlanReason::Left);
            m_searches.end(i);
        }
    }
}

void Observer::removeIceberg(IcebergIndex iceberg)
{
    m_world.remove(iceberg);
    m_checkStep[toIndex(iceberg)] = m_world.lastStep() + 1;
    Track& track = m_tracks[toIndex(iceberg)];
    track.left = true;
    track.inView = false;
    track.status = TrackStatus::Tracked;
    m_searches.end(iceberg);
}

Point middle_m(const Observer& observer, std::span<const IcebergIndex> icebergs)
{
    return circleRound(icebergs, [&](IcebergIndex i) { return observer.estimate_m(i); }).centre_m;
}

std::optional<IcebergIndex> nearest(const Observer& observer, const Point& from_m,
                                    const std::function<bool(IcebergIndex)>& counts)
{
    std::optional<IcebergIndex> nearest;
    double nearest_m = 0;
    for (const IcebergIndex i : observer.world().icebergs()) {
        const double distance_m = (observer.estimate_m(i) - from_m).norm();
        if ((!nearest || distance_m < nearest_m) && counts(i)) {
            nearest = i;
            nearest_m = distance_m;
        }
    }
    return nearest;
}

std::optional<RelativeMotion> relativeToAsset(const Observer& observer, IcebergIndex iceberg)
{
    const std::optional<Asset>& asset = observer.world().asset();
    if (!asset)
        return std::nullopt;
    return relativeToAsset(*asset, observer.world().time_s(), observer.estimate_m(iceberg),
                           observer.track(iceberg).velocity_mps);
}

double priority(const Observer& observer, IcebergIndex iceberg)
{
    const std::optional<RelativeMotion> motion = relativeToAsset(observer, iceberg);
    return motion ? priority(*observer.world().asset(), *motion) : 1;
}

bool isInOwnView(const Observer& observer, int uav, IcebergIndex iceberg)
{
    return observer.track(iceberg).inView &&
           (observer.cameras().count() == 1 ||
            observer.cameras().of(uav).view().contains(observer.world().truth_m(iceberg)));
}

bool isReached(const Observer& observer, int uav, IcebergIndex iceberg)
{
    if (!observer.cameras().reachRadius_m())
        return isInOwnView(observer, uav, iceberg);
    if (observer.world().observer().model == ObserverModel::Simple)
        return observer.cameras().isWithinReach(uav, observer.world().truth_m(iceberg));
    return observer.track(iceberg).inView &&
           observer.cameras().isWithinReach(uav, observer.estimate_m(iceberg));
}

bool isReachedUnseen(const Observer& observer, IcebergIndex iceberg)
{
    return observer.world().observer().model == ObserverModel::Simple &&
           observer.cameras().isWithinReachOfAny(observer.world().truth_m(iceberg));
}

bool isReachedByOther(const Observer& observer, int uav, IcebergIndex iceberg)
{
    for (int other = 0; other < observer.cameras().count(); ++other)
        if (other != uav && isReached(observer, other, iceberg))
            return true;
    return false;
}

} // namespace berg
