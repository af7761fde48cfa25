#include "core/sim/autopilot.h"

#include "core/base/angles.h"
#include "core/scenario/fence.h"
#include "core/sim/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace berg {

namespace {

/** Ratio of the circle flown while every iceberg is in view to the tightest turn. */
constexpr double kCircleMargin = 1.2;
/** Time between two searches for a path home while none is known. */
constexpr std::int64_t kNextSearch_s = 10;

SafetyGuard guardOf(const Uav& uav, const Scenario& scenario, const FlightWeather* weather)
{
    const WindAhead wind =
        weather != nullptr ? WindAhead(weather->wind(), 0) : WindAhead(scenario.wind_mps);
    const double windLimit_mps = weather != nullptr ? weather->strongestWind_mps() : 0;
    GuardedUav guarded{.motion = {.airspeed_mps = uav.spec.airspeed_mps,
                                  .limit_radps = maxTurnRate_radps(uav.spec),
                                  .wind_mps = wind.at_mps(0),
                                  .windLimit_mps = windLimit_mps},
                       .clock = {.dt_s = scenario.dt_s,
                                 .steps = std::max<std::int64_t>(
                                     1, std::llround(uav.spec.autopilot_s / scenario.dt_s))}};
    guarded.sortie = sortieOf(uav);
    guarded.fence = fenceOf(scenario, uav.spec.altitude_m, guarded.motion);
    SafetyGuard guard(std::move(guarded));
    if (weather != nullptr)
        guard.followWind(wind, windLimit_mps);
    return guard;
}

/**
 * Returns true if a UAV that comes straight from `from_m` cannot fly over the place and stay
 * inside.
 */
bool isFencedOff(const Geofence* fence, const Point& from_m, const Point& place_m)
{
    const Point leg_m = place_m - from_m;
    return fence != nullptr &&
           fence->turnClearance_m(
               {.position_m = place_m, .psi_rad = std::atan2(leg_m.y(), leg_m.x())}) < 0;
}

} // namespace

Autopilot::Autopilot(const Uav& uav, const Scenario& scenario, const FlightWeather* weather)
    : m_sensor{.fov_m = uav.fov_m, .shape = scenario.fovShape}
    , m_withoutLimit{.endurance_s = std::numeric_limits<double>::infinity(),
                     .turnaround_s = uav.turnaround_s,
                     .home_m = uav.home_m.value_or(uav.position_m)}
    , m_altitude_m(uav.spec.altitude_m)
    , m_turnRadius_m(turnRadius_m(uav.spec))
    , m_reach_m(scenario.reachRadius_m.value_or(surelySeen_m(m_sensor)))
    , m_needsRunOut(m_reach_m < m_turnRadius_m)
    , m_guard(guardOf(uav, scenario, weather))
    , m_pose{.position_m = uav.position_m, .psi_rad = psiFromHeading(uav.heading_deg)}
{
    m_guidance.startLeg(uav.position_m);
    limitTurnGain();
    m_guard.proveReturn(m_pose, m_u_radps, 0);
}

/** Limits the gain: turning by more than the whole error until the next command oscillates. */
void Autopilot::limitTurnGain()
{
    m_guidance.gains.turn_1ps = std::min(LosGains().turn_1ps, 1 / m_guard.uav().clock.command_s());
}

const FlightTarget* Autopilot::flightTarget() const
{
    if (const Leg* leg = std::get_if<Leg>(&m_mode))
        return &leg->flightTarget;
    if (const RunOut* runOut = std::get_if<RunOut>(&m_mode))
        return &runOut->flightTarget;
    const Searching* searching = std::get_if<Searching>(&m_mode);
    return searching != nullptr ? &searching->flightTarget : nullptr;
}

bool Autopilot::fliesTo(IcebergIndex iceberg) const
{
    const FlightTarget* now = flightTarget();
    return now != nullptr && (now->target == iceberg ||
                              std::ranges::find(now->members, iceberg) != now->members.end());
}

Point targetPlace_m(const FlightTarget& flightTarget, const Observer& observer)
{
    return flightTarget.members.empty() ? observer.estimate_m(*flightTarget.target)
                                        : middle_m(observer, flightTarget.members);
}

UavState Autopilot::state() const
{
    const SortieState& sortie = m_guard.sortie();
    const FlightTarget flightTarget =
        this->flightTarget() != nullptr ? *this->flightTarget() : FlightTarget();
    return {.pose = m_pose,
            .u_radps = m_u_radps,
            .crossTrack_m = m_crossTrack_m,
            .flown_m = m_flown_m,
            .mode = mode(),
            .target = flightTarget.target,
            .lastReached = m_lastReached,
            .guidance = m_guidance,
            .runOut_m = m_runOut_m,
            .misses = m_misses,
            .aim = flightTarget.aim,
            .members = flightTarget.members,
            .membersBy_s = flightTarget.membersBy_s,
            .aloft_s = sortie.aloft_s,
            .ground_s = sortie.ground_s,
            .withheld_s = sortie.withheld_s,
            .via_m = m_via_m,
            .returnPath = sortie.returnPath,
            .order = m_order,
            .hold_m = mode() == FlightMode::Hold ? std::get<Hold>(m_mode).place_m : Point::Zero()};
}

double circleRadius_m(const Motion& motion)
{
    return kCircleMargin * (motion.airspeed_mps + motion.wind_mps.norm()) / motion.limit_radps;
}

Eigen::MatrixXd legLengths_m(const GuardedUav& uav, std::span<const Point> places_m)
{
    if (uav.fence)
        return uav.fence->distances_m(places_m);
    const auto n = static_cast<Eigen::Index>(places_m.size());
    Eigen::MatrixXd lengths_m(n, n);
    const double airspeed_mps = uav.motion.airspeed_mps;
    const Point& wind_mps = uav.motion.wind_mps;
    const bool calm = wind_mps.isZero(0);
    for (Eigen::Index j = 0; j < n; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            const Point leg_m =
                places_m[static_cast<std::size_t>(j)] - places_m[static_cast<std::size_t>(i)];
            // The air distance U t_ij is the cost of a leg that the wind helps or hinders.
            lengths_m(i, j) =
                calm ? leg_m.norm() : airspeed_mps * flightTime_s(leg_m, airspeed_mps, wind_mps);
        }
    return lengths_m;
}

bool Autopilot::isShutOff(const Point& place_m) const
{
    const Geofence* fence = m_guard.uav().fence.get();
    return fence != nullptr && (fence->isOutOfReach(place_m, m_reach_m) ||
                                (m_needsRunOut && fence->isShutOff(place_m)));
}

std::optional<double> Autopilot::homeMargin_s(const Observer& observer) const
{
    return m_guard.homeMargin_s(m_pose, m_u_radps, observer.world().step());
}

std::optional<int> thisSortie(const Autopilot& uav, std::span<const IcebergIndex> order,
                              const Observer& observer)
{
    if (!uav.guard().uav().sortie)
        return std::nullopt;
    std::vector<MovingPlace> places;
    for (const IcebergIndex iceberg : order)
        places.push_back({.place_m = observer.estimate_m(iceberg),
                          .drift_mps = observer.track(iceberg).velocity_mps});
    return uav.guard().visitsInTime(uav.pose(), places);
}

void startAtBestCorner(const Autopilot& uav, Search& search, const Observer& observer)
{
    search.path.startAtBestCorner(uav.pose().position_m - observer.estimate_m(search.iceberg),
                                  uav.motion().airspeed_mps, surelySeen_m(uav.sensor()),
                                  observer.world().observer().detection);
}

double searchGain_m2ps(const Autopilot& uav, const Search& search, const Observer& observer)
{
    const double variance_m2 =
        std::max(observer.track(search.iceberg).sigma_m2, search.path.variance_m2());
    return priority(observer, search.iceberg) * variance_m2 *
           search.path.chancePerSecond(uav.pose().position_m - observer.estimate_m(search.iceberg),
                                       uav.motion().airspeed_mps, surelySeen_m(uav.sensor()),
                                       observer.world().observer().detection);
}

bool isWorthSearching(const Autopilot& uav, const Search& search, const Observer& observer)
{
    const std::optional<IcebergIndex> target = uav.target();
    if (!search.path.hasCorner() || !target)
        return search.path.hasCorner();
    const Point leg_m = observer.estimate_m(*target) - uav.pose().position_m;
    const double leg_s =
        std::max(uav.guard().uav().clock.command_s(),
                 (leg_m.norm() - surelySeen_m(uav.sensor())) / uav.motion().airspeed_mps);
    return searchGain_m2ps(uav, search, observer) >
           priority(observer, *target) * observer.track(*target).sigma_m2 / leg_s;
}

void Autopilot::setTarget(FlightTarget flightTarget, const Observer& observer)
{
    m_misses = 0;
    if (!flightTarget.target) {
        if (!m_lastReached)
            m_lastReached = nearest(observer, m_pose.position_m,
                                    [&](IcebergIndex i) { return observer.active(i); });
        m_mode = m_lastReached ? Mode(Circle{}) : Mode(Idle{});
        return;
    }
    if (!flightTarget.members.empty()) {
        const std::array leg_m{m_pose.position_m, middle_m(observer, flightTarget.members)};
        flightTarget.membersBy_s = observer.world().time_s() + longestTurn_s(motion()) +
                                   legLengths_m(m_guard.uav(), leg_m)(0, 1) / motion().airspeed_mps;
    }
    m_guidance.startLeg(flightTarget.aim ? flightTarget.aim->from_m : m_pose.position_m);
    m_mode = Leg{std::move(flightTarget)};
}

void Autopilot::search()
{
    m_mode = Searching{flightTarget() != nullptr ? *flightTarget() : FlightTarget()};
}

void Autopilot::goHome()
{
    m_mode = Home{};
    m_via_m.reset();
}

void Autopilot::obey(FlightOrder order, const Observer& observer)
{
    const FlightOrder before = std::exchange(m_order, order);
    if (isOnGround())
        return;
    if (order == FlightOrder::ReturnNow) {
        m_guard.requireHome(m_withoutLimit);
        limitTurnGain();
        m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
        goHome();
    } else if (order == FlightOrder::HoldHere) {
        m_mode = Hold{m_pose.position_m};
        m_via_m.reset();
    } else if (before == FlightOrder::ReturnNow || mode() == FlightMode::Hold) {
        m_mode = Idle{};
    }
}

bool Autopilot::takeOff(const Observer& observer)
{
    const std::optional<double> heading_rad = m_guard.takeOff(m_pose);
    if (!heading_rad)
        return false;
    m_pose.psi_rad = *heading_rad;
    m_mode = Idle{};
    m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
    return true;
}

void Autopilot::setWind(const Point& wind_mps, const Observer& observer)
{
    m_guard.setWind(wind_mps);
    m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
}

void Autopilot::followWind(const WindAhead& wind, double windLimit_mps, const Observer& observer)
{
    const bool isNew = m_guard.followWind(wind, windLimit_mps);
    // Others find a new path at their next command.
    if (isNew && mode() == FlightMode::Home)
        m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
}

void Autopilot::setHome(const Point& home_m, const Observer& observer)
{
    if (isOnGround())
        m_pose.position_m = home_m;
    m_withoutLimit.home_m = home_m;
    m_guard.setHome(home_m);
    m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
}

void Autopilot::setFence(std::shared_ptr<const Geofence> fence, const Observer& observer)
{
    m_guard.setFence(std::move(fence));
    m_guard.proveReturn(m_pose, m_u_radps, observer.world().step());
}

bool Autopilot::isCommanded(const World& world) const
{
    const std::int64_t steps = m_guard.uav().clock.steps;
    return !isOnGround() && (steps == 1 || (world.step() - 1) % steps == 0);
}

void Autopilot::deviateTo(double u_radps)
{
    if (u_radps == m_u_radps)
        return;
    m_u_radps = u_radps;
    m_guard.proveReturn(m_guard.heldFor(m_pose, u_radps, m_guard.uav().clock.steps), u_radps, 0);
}

bool Autopilot::command(int uav, Observer& observer, StepReport& report)
{
    const std::int64_t before = observer.world().step() - 1;
    if (!isCommanded(observer.world()))
        return true;
    const bool wasHomeward = isHomeward();
    if (!wasHomeward) {
        const double desired_radps = steer(uav, observer, report);
        if (const auto u_radps = m_guard.command_radps(m_pose, desired_radps)) {
            m_u_radps = *u_radps;
            return true;
        }
        goHome();
    }
    m_crossTrack_m = 0;
    m_u_radps = m_guard.homeCommand_radps(
        m_pose, before % (kNextSearch_s * observer.world().stepsPerSecond()) == 0);
    return wasHomeward;
}

double Autopilot::steer(int uav, Observer& observer, StepReport& report)
{
    switch (mode()) {
    case FlightMode::Leg:
        return steerLeg(observer);
    case FlightMode::RunOut:
        return steerRunOut();
    case FlightMode::Circle:
        return steerRound(observer.estimate_m(*m_lastReached));
    case FlightMode::Search:
        return steerSearch(uav, observer, report);
    case FlightMode::Hold:
        return steerRound(std::get<Hold>(m_mode).place_m);
    case FlightMode::Idle: // no target: hold the present place
        m_crossTrack_m = 0;
        return motion().limit_radps / kCircleMargin;
    case FlightMode::Home:
    case FlightMode::Ground:
        break;
    }
    throw std::logic_error("Autopilot: homeward UAVs are not steered by their flightTarget");
}

/** Steers along the leg to a drifting target and records the cross-track error. */
LosGuidance::Command Autopilot::steerAlong(const Point& end_m, const Point& drift_mps)
{
    Motion relative = motion();
    if (!relative.wind_mps.isZero(0)) // the paper's law for calm air has no crab angle
        relative.wind_mps -= drift_mps;
    const LosGuidance::Command command =
        m_guidance.steer(m_pose, end_m, relative, m_guard.uav().clock.command_s());
    m_crossTrack_m = command.crossTrack_m;
    return command;
}

/** Steers straight at the place. */
double Autopilot::steerAt(const Point& place_m) const
{
    const Point path_m = place_m - m_pose.position_m;
    return turnRateForCourse(m_pose.psi_rad, std::atan2(path_m.y(), path_m.x()), motion(),
                             m_guidance.gains.turn_1ps);
}

Point Autopilot::legEnd_m(const FlightTarget& flightTarget, const Observer& observer) const
{
    const Point place_m = targetPlace_m(flightTarget, observer);
    return m_guard.uav().fence ? m_guard.uav().fence->beside_m(place_m) : place_m;
}

double Autopilot::steerLeg(const Observer& observer)
{
    FlightTarget& flightTarget = std::get<Leg>(m_mode).flightTarget;
    if (flightTarget.aim)
        return steerAim(*flightTarget.aim);
    const Point end_m = legEnd_m(flightTarget, observer);
    if (const std::optional<double> u_radps = steerRoundFence(end_m))
        return *u_radps;
    if (!flightTarget.members.empty()) { // a view of a cluster has little room beside the middle
        const Point leg_m = end_m - m_guidance.start_m;
        const Point flown_m = m_pose.position_m - m_guidance.start_m;
        m_crossTrack_m = leg_m.isZero(0) ? 0 : cross(leg_m.normalized(), flown_m);
        return steerAt(end_m);
    }
    const Point& drift_mps = observer.track(*flightTarget.target).velocity_mps;
    const LosGuidance::Command command = steerAlong(end_m, drift_mps);
    if (!command.passedEnd)
        return command.u_radps;
    ++m_misses;
    if (m_needsRunOut) {
        // Each further miss gets more room, so that the leg becomes straight in the end.
        m_runOut_m = 2 * m_turnRadius_m * m_misses;
        m_mode = RunOut{std::move(flightTarget)};
        return steerRunOut();
    }
    m_guidance.startLeg(m_pose.position_m);
    return steerAlong(end_m, drift_mps).u_radps;
}

double Autopilot::steerAim(AimedLeg& aim)
{
    if (aim.turn_rad == 0)
        return steerAlong(aim.abeam_m).u_radps;
    // The plan includes the side of the turn; the last command ends it exactly.
    const double command_s = m_guard.uav().clock.command_s();
    const double limit_radps = motion().limit_radps;
    const double u_radps = std::clamp(aim.turn_rad / command_s, -limit_radps, limit_radps);
    const bool last = std::abs(u_radps) < limit_radps;
    aim.turn_rad = last ? 0 : aim.turn_rad - u_radps * command_s;
    m_crossTrack_m = 0;
    return u_radps;
}

double Autopilot::steerRunOut()
{
    m_crossTrack_m = 0;
    m_runOut_m -= motion().airspeed_mps * m_guard.uav().clock.command_s();
    if (m_runOut_m <= 0) {
        m_mode = Leg{std::move(std::get<RunOut>(m_mode).flightTarget)};
        m_guidance.startLeg(m_pose.position_m);
    }
    return 0;
}

double Autopilot::steerRound(const Point& place_m)
{
    m_crossTrack_m = 0;
    const Point from_m = m_pose.position_m - place_m;
    const double radius_m = circleRadius_m(motion());
    // The course is the counter-clockwise tangent, turned inwards outside the circle and outwards
    // inside it.
    const double bearing_rad = std::atan2(from_m.y(), from_m.x());
    const double course_rad =
        bearing_rad + kPi / 2 + std::atan((from_m.norm() - radius_m) / (radius_m / 2));
    return turnRateForCourse(m_pose.psi_rad, course_rad, motion(), m_guidance.gains.turn_1ps);
}

double Autopilot::steerSearch(int uav, Observer& observer, StepReport& report)
{
    const std::optional<Search>& search = observer.searches().of(uav);
    if (!search)
        return 0; // the search has ended; a plan follows
    const Point corner_m = observer.estimate_m(search->iceberg) + search->path.corner_m();
    const bool fencedOff = isFencedOff(m_guard.uav().fence.get(), m_guidance.start_m, corner_m);
    if (!fencedOff)
        if (const std::optional<double> u_radps = steerRoundFence(corner_m))
            return *u_radps;
    const LosGuidance::Command command =
        steerAlong(corner_m, observer.track(search->iceberg).velocity_mps);
    if (!command.passedEnd && !fencedOff)
        return command.u_radps;
    observer.searches().nextCorner(uav);
    m_guidance.startLeg(m_pose.position_m);
    if (!isWorthSearching(*this, *search, observer))
        observer.giveUp(observer.searches().take(uav), uav, report);
    return command.u_radps;
}

std::optional<double> Autopilot::steerRoundFence(const Point& end_m)
{
    const Geofence* fence = m_guard.uav().fence.get();
    if (fence == nullptr)
        return std::nullopt;
    const std::vector<Point> corners_m = fence->cornersBetween(m_pose.position_m, end_m);
    const std::optional<Point> via_m =
        corners_m.empty() ? std::nullopt : std::optional(corners_m.front());
    if (via_m != m_via_m) {
        m_via_m = via_m;
        m_guidance.startLeg(m_pose.position_m);
    }
    if (!via_m)
        return std::nullopt;
    const LosGuidance::Command command = steerAlong(*via_m);
    return command.passedEnd ? steerAt(*via_m) : command.u_radps;
}

} // namespace berg
