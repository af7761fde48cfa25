#include "core/sim/rehearsal_vehicle.h"

#include "core/base/angles.h"
#include "core/link/autopilot_modes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr double kStep_s = 0.1;
constexpr double kClimb_mps = 3;
/** Per radian of course error, as in the paper's autopilot. */
constexpr double kTurnGain_radps = 1;

bool isCircle(std::uint16_t command)
{
    return command >= LinkCommandId::kLoiterUnlimited && command <= LinkCommandId::kLoiterTime;
}

/** Returns the number, or the vehicle's own value in place of NaN, as MAVLink defines it. */
double orOwn(double number, double own)
{
    return std::isfinite(number) ? number : own;
}

} // namespace

double smallestCircle_m(const UavSpec& uav)
{
    return 1.2 * turnRadius_m(uav);
}

RehearsalVehicle::RehearsalVehicle(ByteLink& link, RehearsalOptions options)
    : m_options(std::move(options))
    , m_side(link, m_options.side)
    , m_frame(m_options.home)
    , m_airspeed_mps(m_options.uav.airspeed_mps)
    , m_altitude_m(m_options.homeAltitude_m + m_options.uav.altitude_m)
    , m_targetAltitude_m(m_altitude_m)
{
    m_readings.home = m_options.home;
    m_readings.homeAltitude_m = m_options.homeAltitude_m;
    m_readings.isArmed = true;
    m_readings.isFlying = true;
    m_readings.mode = autopilotModes(m_options.side.autopilot).hold;
    m_motion.psi_rad = psiFromHeading(m_options.heading_deg);
    if (m_options.start)
        m_motion.position_m = m_frame.toPlane(*m_options.start);
    updateReadings(0, 0);
}

void RehearsalVehicle::setMode(std::uint32_t mode)
{
    const AutopilotModes modes = autopilotModes(m_options.side.autopilot);
    m_readings.mode = mode;
    m_centre_m = m_motion.position_m;
    m_radius_m = 0;
    m_flight = mode == modes.mission                        ? Flight::Mission
               : mode == modes.home                         ? Flight::Home
               : mode == modes.hold || mode == modes.guided ? Flight::Circle
                                                            : Flight::Pilot;
}

void RehearsalVehicle::flyMission()
{
    setMode(autopilotModes(m_options.side.autopilot).mission);
}

void RehearsalVehicle::setProgress(double altitude_m, int item)
{
    m_altitude_m = m_targetAltitude_m = altitude_m;
    m_item = static_cast<std::size_t>(std::max(0, item));
    updateReadings(0, 0);
}

void RehearsalVehicle::execute(const VehicleOrder& order)
{
    const AutopilotModes modes = autopilotModes(m_options.side.autopilot);
    switch (order.kind) {
    case VehicleOrder::Kind::SetMode:
        setMode(order.mode);
        return;
    case VehicleOrder::Kind::SetItem:
        m_item = static_cast<std::size_t>(order.item);
        m_itemFlown_s = 0;
        return;
    case VehicleOrder::Kind::Reposition:
        if (m_readings.mode != modes.guided)
            setMode(modes.guided);
        m_centre_m = m_frame.toPlane(order.place);
        m_radius_m = std::abs(orOwn(order.radius_m, 0));
        m_targetAltitude_m = altitudeIn(static_cast<std::uint8_t>(order.frame), order.altitude_m);
        return;
    case VehicleOrder::Kind::ChangeSpeed:
        m_airspeed_mps = std::clamp(order.speed_mps, 0.7 * m_options.uav.airspeed_mps,
                                    1.5 * m_options.uav.airspeed_mps);
        return;
    case VehicleOrder::Kind::MissionChanged:
        m_jumps.clear();
        // PX4 restarts at its current item, the first.
        if (m_options.side.autopilot == AutopilotKind::Px4)
            m_item = 0;
        return;
    }
}

void RehearsalVehicle::advance(LinkTime now)
{
    const double from_s = m_now == LinkTime{} ? now.monotonic_s : m_now.monotonic_s;
    const double elapsed_s = m_options.speed * std::max(0.0, now.monotonic_s - from_s);
    m_flown_s += elapsed_s;
    m_now = now;
    m_items = m_side.missions().items(MissionType::Mission);
    const int steps = static_cast<int>(std::ceil(elapsed_s / kStep_s));
    for (int i = 0; i < steps; ++i)
        flyStep(elapsed_s / steps);
    for (const VehicleOrder& order : m_side.advance(now, m_readings))
        execute(order);
}

void RehearsalVehicle::flyStep(double dt_s)
{
    double turnRate_radps = 0;
    std::optional<LinkMissionItem> item;
    if (m_flight == Flight::Mission) {
        item = itemToFly();
        if (!item)
            endMission();
    }
    if (item)
        turnRate_radps = turnRateFor(*item, dt_s);
    else if (m_flight == Flight::Home)
        turnRate_radps = turnRateRound(Point::Zero(), 0);
    else if (m_flight == Flight::Circle)
        turnRate_radps = turnRateRound(m_centre_m, m_radius_m);
    m_motion = step(m_motion, m_airspeed_mps, turnRate_radps, dt_s, m_options.wind_mps);
    const double climb_m =
        std::clamp(m_targetAltitude_m - m_altitude_m, -kClimb_mps * dt_s, kClimb_mps * dt_s);
    m_altitude_m += climb_m;
    updateReadings(turnRate_radps, climb_m / dt_s);
}

std::optional<LinkMissionItem> RehearsalVehicle::itemToFly()
{
    // A jump may lead back to itself, so every item is executed at most once.
    for (std::size_t round = 0; round <= m_items.size() && m_item < m_items.size(); ++round) {
        const LinkMissionItem& item = m_items[m_item];
        const bool isFlown = item.command == LinkCommandId::kWaypoint ||
                             item.command == LinkCommandId::kTakeOff || isCircle(item.command) ||
                             item.command == LinkCommandId::kLand ||
                             item.command == LinkCommandId::kLoiterToAltitude;
        if (isFlown)
            return item;
        if (item.command == LinkCommandId::kReturnToLaunch)
            return std::nullopt;
        if (item.command == LinkCommandId::kChangeSpeed && item.params[1] > 0)
            execute({.kind = VehicleOrder::Kind::ChangeSpeed,
                     .speed_mps = static_cast<double>(item.params[1])});
        if (item.command == LinkCommandId::kJump && item.params[0] >= 0 &&
            item.params[0] < static_cast<float>(m_items.size()) &&
            (item.params[1] < 0 || static_cast<float>(m_jumps[m_item]) < item.params[1])) {
            ++m_jumps[m_item];
            m_item = static_cast<std::size_t>(item.params[0]);
        } else {
            ++m_item;
        }
    }
    return std::nullopt;
}

void RehearsalVehicle::endMission()
{
    const AutopilotModes modes = autopilotModes(m_options.side.autopilot);
    const bool isReturn =
        m_item < m_items.size() && m_items[m_item].command == LinkCommandId::kReturnToLaunch;
    const bool isArduPilot = m_options.side.autopilot != AutopilotKind::Px4;
    m_item = 0;
    m_jumps.clear();
    setMode(isReturn || isArduPilot ? modes.home : modes.hold);
}

Point RehearsalVehicle::placeOf(const LinkMissionItem& item) const
{
    const LatLon place{.latitude_deg = item.x / 1e7, .longitude_deg = item.y / 1e7};
    const bool isNowhere = item.x == 0 && item.y == 0; // a circle or take-off without a place
    if (isNowhere || std::abs(place.latitude_deg) > 90 || std::abs(place.longitude_deg) > 180)
        return m_motion.position_m;
    return m_frame.toPlane(place);
}

double RehearsalVehicle::altitudeIn(std::uint8_t frame, double altitude_m) const
{
    const bool isAbsolute = frame == 0 || frame == 5;
    return orOwn(altitude_m + (isAbsolute ? 0 : m_options.homeAltitude_m), m_targetAltitude_m);
}

double RehearsalVehicle::flownRadius_m(double radius_m) const
{
    return std::max(radius_m > 0 ? radius_m : m_options.loiterRadius_m,
                    smallestCircle_m(m_options.uav));
}

double RehearsalVehicle::turnRateFor(const LinkMissionItem& item, double dt_s)
{
    const Point target_m = placeOf(item);
    m_targetAltitude_m = altitudeIn(item.frame, static_cast<double>(item.z));
    const bool isLevel = std::abs(m_altitude_m - m_targetAltitude_m) < 1;
    if (item.command == LinkCommandId::kTakeOff) { // it is already in the air
        if (isLevel)
            reachItem();
        return turnRateToPoint(target_m);
    }
    if (item.command == LinkCommandId::kWaypoint) {
        if (isReached(item, target_m))
            reachItem();
        return turnRateToPoint(target_m);
    }
    const bool isToAltitude = item.command == LinkCommandId::kLoiterToAltitude;
    const auto given_m = static_cast<double>(item.params[isToAltitude ? 1 : 2]);
    const double flown_m = flownRadius_m(std::abs(orOwn(given_m, 0)));
    if ((target_m - m_motion.position_m).norm() < 1.5 * flown_m)
        m_itemFlown_s += dt_s;
    const double wanted = orOwn(static_cast<double>(item.params[0]), 0);
    const double turn_s = 2 * kPi * flown_m / m_airspeed_mps;
    const bool isOver =
        (item.command == LinkCommandId::kLoiterTurns && m_itemFlown_s >= wanted * turn_s) ||
        (item.command == LinkCommandId::kLoiterTime && m_itemFlown_s >= wanted) ||
        (isToAltitude && isLevel);
    if (isOver && m_itemFlown_s > 0)
        reachItem();
    return turnRateRound(target_m, flown_m);
}

bool RehearsalVehicle::isReached(const LinkMissionItem& item, const Point& target_m) const
{
    const Point path_m = target_m - m_motion.position_m;
    const double named_m = static_cast<double>(item.params[1]);
    if (path_m.norm() <= (named_m > 0 ? named_m : kRehearsalReach_m))
        return true;
    // A waypoint inside the turning circle counts as passed, since the aircraft could circle it for
    // ever.
    const Point ahead(std::cos(m_motion.psi_rad), std::sin(m_motion.psi_rad));
    return path_m.norm() < 2 * turnRadius_m(m_options.uav) && path_m.dot(ahead) < 0;
}

void RehearsalVehicle::reachItem()
{
    m_side.reportReached(static_cast<int>(m_item), m_now);
    ++m_item;
    m_itemFlown_s = 0;
}

double RehearsalVehicle::turnRateToCourse(double course_rad) const
{
    const Point& wind = m_options.wind_mps;
    const double across_mps = std::cos(course_rad) * wind.y() - std::sin(course_rad) * wind.x();
    const double crab_rad = std::asin(std::clamp(across_mps / m_airspeed_mps, -1.0, 1.0));
    const double limit_radps = maxTurnRate_radps(m_options.uav);
    const double error_rad = wrapPi(course_rad - crab_rad - m_motion.psi_rad);
    return std::clamp(kTurnGain_radps * error_rad, -limit_radps, limit_radps);
}

double RehearsalVehicle::turnRateToPoint(const Point& target_m) const
{
    const Point path_m = target_m - m_motion.position_m;
    return path_m.norm() > 1 ? turnRateToCourse(std::atan2(path_m.y(), path_m.x())) : 0;
}

double RehearsalVehicle::turnRateRound(const Point& centre_m, double radius_m) const
{
    const double flown_m = flownRadius_m(radius_m);
    const Point out_m = m_motion.position_m - centre_m;
    const double out_rad = std::atan2(out_m.y(), out_m.x());
    // The course is clockwise along the circle, and straight to the centre far outside it.
    const double inward_rad = std::atan(3 * (out_m.norm() - flown_m) / flown_m);
    return turnRateToCourse(out_rad - kPi / 2 - inward_rad);
}

void RehearsalVehicle::updateReadings(double turnRate_radps, double climb_mps)
{
    const Point& wind = m_options.wind_mps;
    VehicleReadings& r = m_readings;
    r.place = m_frame.toGeographic(m_motion.position_m);
    r.altitude_m = m_altitude_m;
    r.east_mps = m_airspeed_mps * std::cos(m_motion.psi_rad) + wind.x();
    r.north_mps = m_airspeed_mps * std::sin(m_motion.psi_rad) + wind.y();
    r.down_mps = -climb_mps;
    r.roll_rad = -std::atan(turnRate_radps * m_airspeed_mps / kGravity_mps2); // right is positive
    r.pitch_rad = std::atan2(climb_mps, m_airspeed_mps);
    r.heading_rad = radFromDeg(headingFromPsi(m_motion.psi_rad));
    r.airspeed_mps = m_airspeed_mps;
    r.windEast_mps = wind.x();
    r.windNorth_mps = wind.y();
    r.item = static_cast<int>(m_item);
    if (m_options.uav.endurance_s > 0) {
        const double left_s = std::max(0.0, m_options.uav.endurance_s - m_flown_s);
        r.battery = left_s / m_options.uav.endurance_s;
        r.timeRemaining_s = left_s;
    }
}

} // namespace berg
