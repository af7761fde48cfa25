#include "core/sim/fleet.h"

#include "core/scenario/fence.h"
#include "core/scenario/recovery.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace berg {

namespace {

/** Returns true if the UAV was on the ground, or not yet simulated, before this step. */
bool isJustAloft(const Autopilot& uav, const World& world)
{
    return world.step() == 1 ||
           (uav.guard().uav().sortie && uav.guard().sortie().aloft_s < 1.5 * world.dt_s());
}

std::vector<double> altitudes_m(const Scenario& scenario)
{
    std::vector<double> result_m;
    for (const Uav& uav : scenario.uavs)
        result_m.push_back(uav.spec.altitude_m);
    return result_m;
}

std::shared_ptr<const Scenario> boundsOf(const Scenario& scenario)
{
    auto bounds = std::make_shared<Scenario>();
    bounds->duration_s = scenario.duration_s;
    bounds->area_m = scenario.area_m;
    bounds->geofence = scenario.geofence;
    bounds->noFly = scenario.noFly;
    bounds->asset = scenario.asset;
    bounds->weather = scenario.weather;
    return bounds;
}

} // namespace

Fleet::Fleet(const Scenario& scenario, std::span<const DriftNoise> noise)
    : m_clusters(scenario.clusters)
    , m_separation_m(scenario.separation_m)
    , m_bounds(boundsOf(scenario))
    , m_observer(scenario, noise)
    , m_separation(scenario.separation_m, altitudes_m(scenario))
{
    require(!scenario.uavs.empty(), "Simulation: no UAV");
    for (const Uav& uav : scenario.uavs)
        m_autopilots.emplace_back(uav, scenario, m_observer.world().weather().get());
    for (int uav = 0; uav < count(); ++uav) {
        m_separation.setMotion(uav, autopilot(uav).guard());
        enterLayer(uav);
    }
    std::vector<Departing> departing;
    for (const Autopilot& uav : m_autopilots)
        departing.push_back({.guard = uav.guard(), .pose = uav.pose()});
    m_separation.depart(departing);
    const std::vector<double> withheld_s = withheldAtStart_s(scenario);
    for (std::size_t uav = 0; uav < m_autopilots.size(); ++uav) {
        m_autopilots[uav].withhold(withheld_s[uav]);
        m_padMates.push_back(padMates(scenario, uav));
    }
}

bool Fleet::visitable(int uav, IcebergIndex iceberg) const
{
    const Track& track = m_observer.track(iceberg);
    const World& world = m_observer.world();
    const std::optional<int>& assigned = world.parameters(iceberg).assignedUav;
    return m_observer.active(iceberg) && track.status == TrackStatus::Tracked && !track.inView &&
           (!assigned || assigned == uav) && !isReachedUnseen(m_observer, iceberg) &&
           !autopilot(uav).isShutOff(m_observer.estimate_m(iceberg));
}

bool Fleet::affordable(int uav, IcebergIndex iceberg) const
{
    return thisSortie(autopilot(uav), std::span(&iceberg, 1), m_observer).value_or(1) == 1;
}

bool Fleet::available(int uav, IcebergIndex iceberg) const
{
    return visitable(uav, iceberg) && affordable(uav, iceberg);
}

std::optional<IcebergIndex> Fleet::nearestAvailable(int uav) const
{
    return nearest(m_observer, autopilot(uav).pose().position_m,
                   [this, uav](IcebergIndex iceberg) { return available(uav, iceberg); });
}

bool Fleet::clusterable(int uav, IcebergIndex iceberg) const
{
    return available(uav, iceberg) &&
           std::ranges::find(m_unclustered, iceberg) == m_unclustered.end();
}

void Fleet::advance(std::span<const std::optional<ExternalPose>> poses)
{
    if (m_observer.world().weather() && !m_isWindReported)
        followWind(m_observer.world().time_s());
    m_observer.world().tick(); // steering uses the estimates at the end of the step
    m_report.trigger = PlanReason::None;
    for (int uav = 0; uav < count(); ++uav) {
        Autopilot& me = m_autopilots[toIndex(uav)];
        const std::optional<ExternalPose> given =
            poses.empty() ? std::nullopt : poses[toIndex(uav)];
        if (!me.command(uav, m_observer, m_report))
            noteHomeward(uav);
        if (!given)
            enforceSeparation(uav);
        me.move(uav, given ? &*given : nullptr, m_report);
        if (me.isOnGround())
            m_separation.leave(uav);
        else if (given)
            enterLayer(uav);
        m_observer.cameras().setPose(uav, me.pose(), me.mode());
        if (given && !given->hasView)
            m_observer.cameras().switchOff(uav);
    }
    watchSeparation();
    m_observer.observe(m_observer.world().dt_s(), m_report);
    std::erase_if(m_unclustered,
                  [this](IcebergIndex iceberg) { return m_observer.track(iceberg).inView; });
}

void Fleet::enterLayer(int uav)
{
    const Autopilot& me = autopilot(uav);
    m_separation.enter(uav, me.guard(), me.pose());
}

/** Replaces the autopilot's command by one that keeps the UAV separated in its layer. */
void Fleet::enforceSeparation(int uav)
{
    Autopilot& me = m_autopilots[toIndex(uav)];
    if (!m_separation.concerns(uav) || !me.isCommanded(m_observer.world()))
        return;
    Separation::DesiredTurn desired{.rate_radps = me.turnRate_radps(),
                                    .hasGoal = me.isHomeward() || me.target()};
    if (me.isHomeward() && me.guard().uav().sortie) {
        desired.home_m = me.guard().uav().sortie->home_m;
        desired.due_s = m_observer.world().time_s() + me.guard().slotLeft_s();
    }
    me.deviateTo(m_separation.command_radps(uav, me.guard(), me.pose(), desired));
}

void Fleet::setTarget(int uav, FlightTarget flightTarget, bool mayContinueLeg, bool keepsSearch)
{
    Autopilot& me = m_autopilots[toIndex(uav)];
    const FlightTarget* now = me.flightTarget();
    if (mayContinueLeg && flightTarget.target && !flightTarget.aim && now != nullptr &&
        now->target == flightTarget.target && now->members == flightTarget.members && !now->aim) {
        // Another UAV may have passed on its search.
        if (me.mode() != FlightMode::Search && !(keepsSearch && m_observer.isLeftToPlan()))
            beginOrEndSearch(uav);
        return;
    }
    me.setTarget(std::move(flightTarget), m_observer);
    if (!keepsSearch || !m_observer.isLeftToPlan())
        beginOrEndSearch(uav);
    // The UAV flies home if icebergs can be visited, but not in this sortie.
    if (!me.target() && me.mode() != FlightMode::Search && me.guard().uav().sortie &&
        nearest(m_observer, me.pose().position_m,
                [this, uav](IcebergIndex i) { return visitable(uav, i); }) &&
        !nearestAvailable(uav))
        sendHome(uav);
}

void Fleet::sendHome(int uav)
{
    m_autopilots[toIndex(uav)].goHome();
    noteHomeward(uav);
}

void Fleet::noteHomeward(int uav)
{
    m_observer.cameras().setPose(uav, autopilot(uav).pose(), autopilot(uav).mode());
    leaveSearch(uav);
    // The others can visit its targets now.
    m_report.add({.kind = EventKind::HomeBound, .uav = uav}, PlanReason::Fleet);
}

/**
 * Passes the search of a UAV that is no longer planned to the nearest UAV that may continue it, or
 * gives it up for now.
 */
void Fleet::leaveSearch(int uav)
{
    if (!isSearchedByPlan())
        m_observer.takeFromPlan(uav, m_report);
    if (!m_observer.searches().of(uav))
        return;
    Search search = m_observer.searches().take(uav);
    const Point datum_m = m_observer.estimate_m(search.iceberg);
    const auto away_m = [&](int of) { return (autopilot(of).pose().position_m - datum_m).norm(); };
    std::optional<int> next;
    for (int other = 0; other < count(); ++other)
        if (other != uav && autopilot(other).isPlanned() && !m_observer.searches().of(other) &&
            maySearch(other, search.iceberg) && (!next || away_m(other) < away_m(*next)))
            next = other;
    if (next)
        m_observer.beginSearch(*next, std::move(search));
    else
        m_observer.giveUp(std::move(search), uav, m_report);
}

bool Fleet::maySearch(int uav, IcebergIndex iceberg) const
{
    const std::optional<int>& assigned = m_observer.world().parameters(iceberg).assignedUav;
    return m_observer.active(iceberg) && (!assigned || assigned == uav) && affordable(uav, iceberg);
}

bool Fleet::hasSomethingToSearch(int uav) const
{
    return m_observer.world().observer().search != SearchPattern::None &&
           std::ranges::any_of(m_observer.searches().givenUp(), [this, uav](const Search& search) {
               return maySearch(uav, search.iceberg);
           });
}

/** Returns true if a UAV flies an aimed plan now, which then includes the searches. */
bool Fleet::isSearchedByPlan() const
{
    return searchesByPlan() && std::ranges::any_of(m_autopilots, [](const Autopilot& uav) {
               return uav.isPlanned() && uav.flightTarget() != nullptr && uav.flightTarget()->aim;
           });
}

/** Starts or ends a search when the UAV gets a new target. */
void Fleet::beginOrEndSearch(int uav)
{
    Autopilot& me = m_autopilots[toIndex(uav)];
    if (isSearchedByPlan()) {
        m_observer.leaveToPlan(uav);
        return;
    }
    m_observer.takeFromPlan(uav, m_report);
    if (!m_observer.searches().of(uav))
        searchAgain(uav);
    const std::optional<Search>& search = m_observer.searches().of(uav);
    if (!search)
        return;
    if (isWorthSearching(me, *search, m_observer))
        me.search();
    else
        m_observer.giveUp(m_observer.searches().take(uav), uav, m_report);
}

/**
 * Resumes a search that was given up if it gains more than the new target, because the other
 * icebergs have been seen recently; without a target in any case, because the iceberg may have
 * drifted back into the area searched. The pattern is laid anew about the datum and begins at its
 * best corner; probabilities of cells seen empty are retained.
 */
void Fleet::searchAgain(int uav)
{
    const Autopilot& me = autopilot(uav);
    std::optional<Search> best;
    double best_m2ps = me.target() ? 0 : -1;
    for (const Search& old : m_observer.searches().givenUp()) {
        if (!maySearch(uav, old.iceberg))
            continue;
        const LostSearch pattern(m_observer.world().observer(), me.sensor(), old.path.spread_m(),
                                 me.pose().psi_rad);
        Search search{.iceberg = old.iceberg,
                      .path = LostSearch::restored(pattern.corners_m(), 0, old.path.spread_m(),
                                                   old.path.chances(), old.path.presence())};
        startAtBestCorner(me, search, m_observer);
        const double gain_m2ps = searchGain_m2ps(me, search, m_observer);
        if (gain_m2ps > best_m2ps && isWorthSearching(me, search, m_observer)) {
            best_m2ps = gain_m2ps;
            best = std::move(search);
        }
    }
    if (best)
        m_observer.beginSearch(uav, std::move(*best));
}

void Fleet::setReached(int uav)
{
    m_autopilots[toIndex(uav)].setReached(*autopilot(uav).target());
    m_separation.arrive(uav);
}

/**
 * Withholds endurance from the sortie that begins now, so that it ends in its own recovery slot.
 */
void Fleet::takeSlot(int uav)
{
    const std::vector<int>& mates = m_padMates[toIndex(uav)];
    if (mates.empty())
        return;
    std::vector<double> taken_s;
    for (const int mate : mates)
        if (const Autopilot& them = autopilot(mate); !them.isOnGround())
            taken_s.push_back(them.guard().slotLeft_s());
    Autopilot& me = m_autopilots[toIndex(uav)];
    me.withhold(withheldFor_s(me.guard().enduranceLeft_s(), std::move(taken_s)));
}

bool Fleet::takeOffWhenDue(int uav)
{
    constexpr double kRounding = 1e-3; // share of a step, covers the rounding of the countdown
    Autopilot& me = m_autopilots[toIndex(uav)];
    const World& world = m_observer.world();
    if (!me.isOnGround() || me.order() != FlightOrder::None ||
        me.guard().sortie().ground_s > kRounding * world.dt_s() || !world.isWholeSecond())
        return false;
    takeSlot(uav);
    if ((!nearestAvailable(uav) && !hasSomethingToSearch(uav)) ||
        !m_separation.hasRoom(uav, me.pose().position_m) || !me.takeOff(m_observer))
        return false;
    enterLayer(uav);
    m_observer.cameras().setPose(uav, me.pose(), me.mode());
    m_report.add({.kind = EventKind::TookOff, .uav = uav});
    return true;
}

bool Fleet::endOverdueCluster(int uav)
{
    const Autopilot& me = autopilot(uav);
    if (me.mode() != FlightMode::Leg || me.flightTarget()->members.empty())
        return false;
    const FlightTarget& flightTarget = *me.flightTarget();
    const DubinsState& pose = me.pose();
    const Point path_m = targetPlace_m(flightTarget, m_observer) - pose.position_m;
    const Point ahead(std::cos(pose.psi_rad), std::sin(pose.psi_rad));
    const bool flownOver = path_m.norm() <= kFlownOver_m && ahead.dot(path_m) <= 0;
    if (!flownOver && m_observer.world().time_s() < flightTarget.membersBy_s)
        return false;
    std::ranges::copy_if(flightTarget.members, std::back_inserter(m_unclustered),
                         [&](IcebergIndex member) { return !isReached(m_observer, uav, member); });
    return true;
}

/**
 * Lets the wind change at the beginning of a step of the weather. Discs and fences have room for
 * the strongest wind to come, so they stay as they are.
 */
void Fleet::followWind(double time_s)
{
    constexpr double kRounding = 1e-9;
    const auto step =
        static_cast<std::int64_t>(std::floor(time_s / FlightWeather::kWindStep_s + kRounding));
    if (step == m_windStep)
        return;
    m_windStep = step;
    const FlightWeather& weather = *m_observer.world().weather();
    const double from_s = static_cast<double>(step) * FlightWeather::kWindStep_s;
    for (Autopilot& uav : m_autopilots)
        uav.followWind(WindAhead(weather.wind(), from_s), weather.strongestWind_mps(), m_observer);
}

WindAhead Fleet::windAhead() const
{
    const World& world = m_observer.world();
    return world.weather() && !m_isWindReported ? WindAhead(world.weather()->wind(), world.time_s())
                                                : WindAhead(autopilot(0).motion().wind_mps);
}

std::optional<double> Fleet::gust_mps() const
{
    const World& world = m_observer.world();
    return world.weather() && !m_isWindReported ? world.weather()->gust_mps(world.time_s())
                                                : m_bounds->weather.gust_mps;
}

void Fleet::setWind(const Point& wind_mps)
{
    m_isWindReported = true;
    m_observer.setWind(wind_mps);
    for (int uav = 0; uav < count(); ++uav) {
        Autopilot& me = m_autopilots[toIndex(uav)];
        me.setWind(wind_mps, m_observer);
        m_separation.setMotion(uav, me.guard());
        if (!me.isOnGround())
            enterLayer(uav);
        sendHomeWhenLate(uav);
    }
}

void Fleet::setAsset(const Asset& asset)
{
    m_observer.world().setAsset(asset);
    const bool hadRing = m_bounds->asset && m_bounds->asset->standoff_m > 0;
    auto bounds = std::make_shared<Scenario>(*m_bounds);
    bounds->asset = asset;
    m_bounds = std::move(bounds);
    if (!hadRing && asset.standoff_m == 0)
        return;
    for (int uav = 0; uav < count(); ++uav) {
        Autopilot& me = m_autopilots[toIndex(uav)];
        const bool wasInside = me.isInsideFence();
        me.setFence(fenceOf(*m_bounds, me.altitude_m(), me.motion()), m_observer);
        if (!me.isOnGround() && me.isInsideFence() != wasInside)
            m_report.add(
                {.kind = wasInside ? EventKind::LeftFence : EventKind::BackInside, .uav = uav});
        sendHomeWhenLate(uav);
    }
}

void Fleet::setHome(int uav, const Point& home_m)
{
    m_autopilots[toIndex(uav)].setHome(home_m, m_observer);
    sendHomeWhenLate(uav);
}

void Fleet::sendHomeWhenLate(int uav)
{
    const Autopilot& me = autopilot(uav);
    if (me.homeMargin_s(m_observer).value_or(0) >= 0)
        return;
    m_report.add({.kind = EventKind::LateHome, .uav = uav});
    if (!me.isHomeward())
        sendHome(uav);
}

void Fleet::order(int uav, FlightOrder order)
{
    const bool wasHomeward = autopilot(uav).isHomeward();
    m_autopilots[toIndex(uav)].obey(order, m_observer);
    if (autopilot(uav).isHomeward() && !wasHomeward)
        noteHomeward(uav);
    m_observer.cameras().setPose(uav, autopilot(uav).pose(), autopilot(uav).mode());
    if (!autopilot(uav).isPlanned())
        leaveSearch(uav);
}

/** Reports close pairs aloft in one altitude layer and updates their least distance. */
void Fleet::watchSeparation()
{
    const World& world = m_observer.world();
    for (int a = 0; a < count(); ++a)
        for (int b = a + 1; b < count(); ++b) {
            const Autopilot& first = autopilot(a);
            const Autopilot& second = autopilot(b);
            if (!m_separation.shareLayer(a, b) || first.isOnGround() || second.isOnGround())
                continue;
            const double distance_m = (first.pose().position_m - second.pose().position_m).norm();
            // Distance at the end of the last step, or at the start.
            const double before_m = (first.before_m() - second.before_m()).norm();
            m_closest_m = std::min({m_closest_m.value_or(distance_m), before_m, distance_m});
            const bool wasApart = isJustAloft(first, world) || isJustAloft(second, world) ||
                                  before_m >= m_separation_m;
            if (wasApart && distance_m < m_separation_m)
                m_report.add(
                    {.kind = EventKind::Close, .uav = a, .otherUav = b, .distance_m = distance_m});
        }
}

} // namespace berg
