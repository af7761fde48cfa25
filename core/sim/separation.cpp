#include "core/sim/separation.h"

#include "core/base/angles.h"
#include "core/base/enclosing_circle.h"
#include "core/scenario/advice.h"
#include "core/vehicle/los_guidance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace berg {

namespace {

/** Turn rates tried between none and the limit. */
constexpr int kRates = 8;
/** A UAV that is blocked for so long is made way for. */
constexpr double kPatience_s = 20;
/** Of the path home, so much is kept clear. */
constexpr double kAhead_s = 60;
/** For another one to leave the path home. */
constexpr double kLongestWait_s = 60;
/** One that has waited for so much longer goes first. */
constexpr double kWait_s = 30;

/** Of the course over ground. */
Point aheadOf(const DubinsState& pose, const Motion& motion)
{
    return (motion.airspeed_mps * Point(std::cos(pose.psi_rad), std::sin(pose.psi_rad)) +
            motion.wind_mps)
        .normalized();
}

/** Of the circle tangent to the course on that side. */
Point middleBeside_m(const DubinsState& pose, const Motion& motion, double side)
{
    const Point ahead = aheadOf(pose, motion);
    return pose.position_m + side * circleOverGround_m(motion) * Point(-ahead.y(), ahead.x());
}

/**
 * Round the middle: the turn rate after which the circle tangent to the course lies there again,
 * but for what lies across the course, which the turn itself takes along.
 */
double holdingRate_radps(const SafetyGuard& guard, const DubinsState& pose, const Point& middle_m,
                         double side)
{
    const Motion& motion = guard.uav().motion;
    const double limit_radps = motion.limit_radps;
    const auto error_m = [&](double rate_radps) {
        const DubinsState after = guard.heldFor(pose, rate_radps, guard.uav().clock.steps);
        return aheadOf(after, motion).dot(middleBeside_m(after, motion, side) - middle_m);
    };
    constexpr double kNear_m = 1e-6;
    double last_radps = side * limit_radps;
    double rate_radps = 0.9 * last_radps;
    double last_m = error_m(last_radps);
    for (int round = 0; round < 6; ++round) {
        const double now_m = error_m(rate_radps);
        if (std::abs(now_m) < kNear_m || now_m == last_m)
            break;
        const double next_radps =
            std::clamp(rate_radps - now_m * (rate_radps - last_radps) / (now_m - last_m),
                       -limit_radps, limit_radps);
        last_radps = rate_radps;
        last_m = now_m;
        rate_radps = next_radps;
    }
    return rate_radps;
}

/** Of a disc that it does not leave while it holds, from any course: commands that are held do not
 * follow the circle exactly in wind. */
double holdingRadius_m(const SafetyGuard& guard)
{
    constexpr int kCourses = 8;
    constexpr double kRounding_m = 0.5;
    const Motion& motion = guard.uav().motion;
    const double circle_m = circleOverGround_m(motion);
    double radius_m = circle_m;
    if (motion.wind_mps.isZero(0))
        return radius_m + kRounding_m;
    for (int course = 0; course < kCourses; ++course) { // to the right it is the same mirrored
        DubinsState pose{.psi_rad = 2 * kPi * course / kCourses};
        const Point middle_m = middleBeside_m(pose, motion, 1);
        const double round_m = 3 * kPi * circle_m;
        for (double flown_m = 0; flown_m < round_m;) {
            const double rate_radps = holdingRate_radps(guard, pose, middle_m, 1);
            for (std::int64_t i = 0; i < guard.uav().clock.steps; ++i) {
                const DubinsState after = guard.heldFor(pose, rate_radps, 1);
                flown_m += (after.position_m - pose.position_m).norm();
                pose = after;
                radius_m = std::max(radius_m, (pose.position_m - middle_m).norm());
            }
        }
    }
    return radius_m + kRounding_m;
}

/** The disc, the fence of the UAV; without one everything is. */
bool isInside(const SafetyGuard& guard, const Point& middle_m, double radius_m)
{
    const Geofence* fence = guard.uav().fence.get();
    return fence == nullptr ||
           (fence->contains(middle_m) && fence->clearance_m(middle_m) >= radius_m);
}

/** The UAV itself; to come back is more urgent then than a disc inside. */
bool isOutside(const SafetyGuard& guard, const DubinsState& pose)
{
    const Geofence* fence = guard.uav().fence.get();
    return fence != nullptr && !fence->contains(pose.position_m);
}

/** Towards the course away from the place, first round on the side where it is not. */
double turnAway_radps(const SafetyGuard& guard, const DubinsState& pose, const Point& place_m)
{
    const Motion& motion = guard.uav().motion;
    const Point away_m = pose.position_m - place_m;
    const Point ahead = aheadOf(pose, motion);
    if (ahead.dot(away_m) < 0)
        return cross(ahead, away_m) > 0 ? motion.limit_radps : -motion.limit_radps;
    return turnRateForCourse(pose.psi_rad, std::atan2(away_m.y(), away_m.x()), motion,
                             1 / std::max(1.0, guard.uav().clock.command_s()));
}

/** Of the discs tangent to the course none is inside the fence. */
bool hasNoCircle(const SafetyGuard& guard, const DubinsState& pose, double radius_m)
{
    return std::ranges::none_of(std::array{1.0, -1.0}, [&](double side) {
        return isInside(guard, middleBeside_m(pose, guard.uav().motion, side), radius_m);
    });
}

/** Those to the right of the wish first, so that all turn the same way round each other. */
std::vector<double> ratesByNearness(double wished_radps, const Motion& motion)
{
    std::vector<double> left;
    std::vector<double> rates;
    for (int i = kRates; i >= -kRates; --i) {
        const double rate_radps = i * motion.limit_radps / kRates;
        (rate_radps < wished_radps ? rates : left).push_back(rate_radps);
    }
    rates.insert(rates.end(), left.rbegin(), left.rend());
    return rates;
}

} // namespace

Separation::Separation(double separation_m, const std::vector<double>& altitudes_m)
    : m_separation_m(separation_m), m_members(altitudes_m.size())
{
    for (std::size_t k = 0; k < m_members.size(); ++k)
        m_members[k].altitude_m = altitudes_m[k];
    const int count = static_cast<int>(m_members.size());
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            if (a != b && m_separation_m > 0 && shareLayer(a, b))
                m_members[index(a)].isConcerned = true;
}

bool Separation::shareLayer(int a, int b) const
{
    return std::abs(m_members[index(a)].altitude_m - m_members[index(b)].altitude_m) <
           kLayerHeight_m;
}

void Separation::setMotion(int uav, const SafetyGuard& guard)
{
    if (concerns(uav))
        m_members[index(uav)].radius_m = holdingRadius_m(guard);
}

/** By UAV to their discs, then by UAV to the paths home that it has to keep clear of; what it need
 * not be kept apart from is far away. */
std::vector<double> Separation::gaps_m(int uav, const Disc& disc) const
{
    const std::size_t count = m_members.size();
    std::vector<double> gaps(2 * count, kFar);
    for (std::size_t other = 0; other < count; ++other) {
        const Member& them = m_members[other];
        if (!them.disc || static_cast<int>(other) == uav ||
            !shareLayer(uav, static_cast<int>(other)))
            continue;
        gaps[other] =
            (them.disc->middle_m - disc.middle_m).norm() - them.disc->radius_m - disc.radius_m;
        if (them.ahead_m && precedes(static_cast<int>(other), uav))
            gaps[count + other] =
                distanceToSegment(them.ahead_m->first, them.ahead_m->second, disc.middle_m) -
                them.radius_m - disc.radius_m;
    }
    return gaps;
}

void Separation::enter(int uav, const SafetyGuard& guard, const DubinsState& pose)
{
    if (!concerns(uav))
        return;
    Member& me = m_members[index(uav)];
    me.place_m = pose.position_m;
    me.disc.reset();
    std::pair best{false, -kFar};
    for (const double side : {-1.0, 1.0}) {
        const Disc disc{.middle_m = middleBeside_m(pose, guard.uav().motion, side),
                        .radius_m = me.radius_m,
                        .side = side};
        const std::pair worth{isInside(guard, disc.middle_m, disc.radius_m),
                              std::ranges::min(gaps_m(uav, disc))};
        if (!me.disc || worth > best) {
            best = worth;
            me.disc = disc;
        }
    }
}

void Separation::leave(int uav)
{
    Member& me = m_members[index(uav)];
    me.disc.reset();
    me.ahead_m.reset();
    me.due_s.reset();
    me.waits_s = 0;
    me.blocker = -1;
    me.denied_s = 0;
    me.waited_s = 0;
}

bool Separation::hasRoom(int uav, const Point& place_m) const
{
    if (!concerns(uav))
        return true;
    const Disc around{.middle_m = place_m, .radius_m = 2 * m_members[index(uav)].radius_m};
    return std::ranges::min(gaps_m(uav, around)) >= m_separation_m;
}

Separation::Trial Separation::trial(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                    double rate_radps, const std::vector<double>& least_m) const
{
    std::vector<DubinsState> flown{pose};
    for (std::int64_t i = 0; i < guard.uav().clock.steps; ++i)
        flown.push_back(guard.heldFor(flown.back(), rate_radps, 1));
    Trial trial{.rate_radps = rate_radps};
    double leastLack_m = kFar;
    double widest_m = -kFar;
    for (const double side : {-1.0, 1.0}) {
        Disc disc{.middle_m = middleBeside_m(flown.back(), guard.uav().motion, side),
                  .radius_m = m_members[index(uav)].radius_m,
                  .side = side};
        if (!isOutside(guard, pose) && !isInside(guard, disc.middle_m, disc.radius_m))
            continue;
        for (std::size_t i = 1; i < flown.size(); ++i)
            disc.radius_m = std::max(disc.radius_m, (flown[i].position_m - disc.middle_m).norm());
        const std::vector<double> gaps = gaps_m(uav, disc);
        double lack_m = 0;
        int blocker = -1;
        for (std::size_t other = 0; other < gaps.size(); ++other)
            if (least_m[other] - gaps[other] > lack_m) {
                lack_m = least_m[other] - gaps[other];
                blocker = static_cast<int>(other % m_members.size());
            }
        if (const double gap_m = std::ranges::min(gaps); lack_m == 0 && gap_m > widest_m) {
            trial.disc = disc;
            widest_m = gap_m;
        }
        if (lack_m < leastLack_m) {
            leastLack_m = lack_m;
            trial.blocker = blocker;
        }
    }
    return trial;
}

/** On the way home the one that was due first when it set out; else the one that has waited longer.
 * The first of the fleet among equals. */
bool Separation::precedes(int first, int second) const
{
    const auto rank = [this](int uav) {
        const Member& member = m_members[index(uav)];
        // What changes with time has no say at the pad: two would make way for each other by turns.
        return std::tuple(member.due_s.value_or(kFar), !member.due_s,
                          member.due_s ? 0 : -std::floor(member.waited_s / kWait_s), uav);
    };
    return rank(first) < rank(second);
}

/** From whom the UAV is to fly away: one that it is too near to, or that goes first and has been
 * blocked by it for long; -1: nobody. */
int Separation::avoided(int uav, const std::vector<double>& gaps) const
{
    const auto nearest = std::ranges::min_element(gaps);
    if (*nearest < m_separation_m)
        return static_cast<int>(nearest - gaps.begin()) % static_cast<int>(m_members.size());
    for (int other = 0; other < static_cast<int>(m_members.size()); ++other)
        if (const Member& them = m_members[index(other)];
            them.blocker == uav && them.denied_s >= kPatience_s && precedes(other, uav))
            return other;
    return -1;
}

/** Whether the one that it waits for is still in its path home; else they would fly on side by
 * side, each turning with the other. */
bool Separation::waitsOn(int uav) const
{
    const Member& me = m_members[index(uav)];
    if (me.waits_s == 0 || me.waits_s > kLongestWait_s || !me.ahead_m || me.blocker < 0)
        return false;
    const std::optional<Disc>& theirs = m_members[index(me.blocker)].disc;
    return theirs && distanceToSegment(me.ahead_m->first, me.ahead_m->second, theirs->middle_m) <
                         theirs->radius_m + me.radius_m + m_separation_m;
}

/** Of the other UAV and its path home, what is nearest. */
Point Separation::placeToAvoid_m(int other, const Point& from_m) const
{
    const Member& them = m_members[index(other)];
    return them.ahead_m ? nearestOnSegment(them.ahead_m->first, them.ahead_m->second, from_m)
                        : them.place_m;
}

void Separation::note(int uav, const Trial& wished, const Wish& wish, double command_s)
{
    Member& me = m_members[index(uav)];
    if (wished.disc) {
        me.denied_s = std::max(0.0, me.denied_s - command_s);
        if (me.denied_s == 0)
            me.blocker = -1;
        return;
    }
    me.denied_s = std::min(2 * kPatience_s, me.denied_s + command_s);
    me.blocker = wished.blocker;
    if (wish.hasGoal)
        me.waited_s += command_s;
}

/**
 * A proven path home may lead where no circle is inside the fence: then all that is left of it is
 * reserved, and flown to its end.
 */
Separation::Trial Separation::pathHome(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                       double rate_radps) const
{
    Trial trial{.rate_radps = rate_radps};
    const std::optional<ReturnPath>& path = guard.sortie().returnPath;
    DubinsState at = guard.heldFor(pose, rate_radps, guard.uav().clock.steps);
    if (!path || !hasNoCircle(guard, at, m_members[index(uav)].radius_m))
        return trial;
    std::vector<Point> places_m{pose.position_m, at.position_m};
    for (const ReturnPath::Part& part : path->parts)
        for (std::int64_t i = 0; i < part.commands * guard.uav().clock.steps; ++i) {
            at = guard.heldFor(at, part.rate_radps, 1);
            places_m.push_back(at.position_m);
        }
    const Circle around = enclosingCircle(places_m);
    const Disc disc{.middle_m = around.centre_m, .radius_m = around.radius_m, .side = 0};
    if (std::ranges::min(gaps_m(uav, disc)) >= m_separation_m)
        trial.disc = disc;
    return trial;
}

double Separation::command_radps(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                 const Wish& wish)
{
    Member& me = m_members[index(uav)];
    me.place_m = pose.position_m;
    me.due_s = wish.home_m ? std::optional(me.due_s.value_or(wish.due_s)) : std::nullopt;
    me.ahead_m.reset();
    if (wish.home_m) {
        const Point path_m = *wish.home_m - pose.position_m;
        const double clear_m = kAhead_s * guard.uav().motion.airspeed_mps;
        me.ahead_m = {pose.position_m,
                      pose.position_m + std::min(1.0, clear_m / path_m.norm()) * path_m};
    }
    const bool isOnPathHome = me.disc->side == 0;
    if (!isOnPathHome)
        me.disc->radius_m = me.radius_m; // the path to the circle is flown by now
    std::vector<double> least_m = gaps_m(uav, *me.disc);
    const int other = isOnPathHome ? -1 : avoided(uav, least_m);
    for (double& gap_m : least_m)
        gap_m = std::min(gap_m, m_separation_m);
    const auto tried = [&](double rate_radps) {
        return trial(uav, guard, pose, rate_radps, least_m);
    };

    if (other < 0 && waitsOn(uav)) {
        note(uav, {.blocker = me.blocker}, wish, guard.uav().clock.command_s());
        me.waits_s += guard.uav().clock.command_s();
        return holdingRate_radps(guard, pose, me.disc->middle_m, me.disc->side);
    }
    const double wished_radps =
        other < 0 ? wish.rate_radps
                  : turnAway_radps(guard, pose, placeToAvoid_m(other, pose.position_m));
    Trial best = tried(wished_radps);
    if (!best.disc && isOnPathHome)
        return wished_radps;
    if (!best.disc && wish.home_m && other < 0)
        if (const Trial home = pathHome(uav, guard, pose, wished_radps); home.disc)
            best = home;
    note(uav, best, wish, guard.uav().clock.command_s());
    const bool waits = best.blocker >= 0 &&
                       (precedes(best.blocker, uav) ? m_members[index(best.blocker)].blocker >= 0
                                                    : me.denied_s >= kPatience_s);
    me.waits_s = waits && me.ahead_m && other < 0 ? guard.uav().clock.command_s() : 0;
    if (!waits)
        for (const double rate_radps : ratesByNearness(wished_radps, guard.uav().motion)) {
            if (best.disc)
                break;
            best = tried(rate_radps);
        }
    if (!best.disc)
        return holdingRate_radps(guard, pose, me.disc->middle_m, me.disc->side);
    me.disc = best.disc;
    return best.rate_radps;
}

} // namespace berg
