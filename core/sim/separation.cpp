#include "core/sim/separation.h"

#include "core/base/angles.h"
#include "core/scenario/limits.h"
#include "core/sim/holding.h"
#include "core/vehicle/los_guidance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace berg {

namespace {

/** Number of turn rates tried between zero and the limit. */
constexpr int kRates = 8;
/** Time for which a UAV is blocked before others yield to it. */
constexpr double kPatience_s = 20;
/** Length of the path home, in flight time, that is kept clear. */
constexpr double kAhead_s = 60;
/** Longest wait for another UAV to leave the path home. */
constexpr double kLongestWait_s = 60;
/** Length of the pieces of a path home inside a fence, in flight time. */
constexpr double kPiece_s = 1;
/** Difference in waiting time by which a UAV goes first. */
constexpr double kWait_s = 30;

/** Returns true if the disc is inside the UAV's fence, or there is none. */
bool isInside(const SafetyGuard& guard, const Point& middle_m, double radius_m)
{
    const Geofence* fence = guard.uav().fence.get();
    return fence == nullptr ||
           (fence->contains(middle_m) && fence->clearance_m(middle_m) >= radius_m);
}

/**
 * Returns true if the UAV is outside its fence. Coming back then has priority over a disc inside.
 */
bool isOutside(const SafetyGuard& guard, const DubinsState& pose)
{
    const Geofence* fence = guard.uav().fence.get();
    return fence != nullptr && !fence->contains(pose.position_m);
}

/** Turns towards the course away from the place, first to the side where the place is not. */
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

/** Returns true if neither disc tangent to the course is inside the fence. */
bool hasNoCircle(const SafetyGuard& guard, const DubinsState& pose, double radius_m)
{
    return std::ranges::none_of(std::array{1.0, -1.0}, [&](double side) {
        return isInside(guard, middleBeside_m(pose, guard.uav().motion, side), radius_m);
    });
}

/** Returns the point of the polyline nearest to the place. */
Point nearestOn(std::span<const Point> line_m, const Point& place_m)
{
    Point nearest_m = line_m.front();
    for (std::size_t i = 1; i < line_m.size(); ++i)
        if (const Point on_m = nearestOnSegment(line_m[i - 1], line_m[i], place_m);
            (on_m - place_m).norm() < (nearest_m - place_m).norm())
            nearest_m = on_m;
    return nearest_m;
}

/**
 * Lists turn rates by nearness to the desired one, those to its right first, so that UAVs turn
 * round each other in the same sense.
 */
std::vector<double> ratesByNearness(double desired_radps, const Motion& motion)
{
    std::vector<double> left;
    std::vector<double> rates;
    for (int i = kRates; i >= -kRates; --i) {
        const double rate_radps = i * motion.limit_radps / kRates;
        (rate_radps < desired_radps ? rates : left).push_back(rate_radps);
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

/** Distance from the disc to another UAV's disc and to the rest of its departure. */
double Separation::gap_m(const Member& them, const Disc& disc)
{
    double apart_m = (them.disc->middle_m - disc.middle_m).norm() - them.disc->radius_m;
    for (const Point& place_m : them.departure.path_m)
        apart_m = std::min(apart_m, (place_m - disc.middle_m).norm());
    return apart_m - disc.radius_m;
}

/**
 * Returns distances by UAV to the discs of others, then by UAV to the paths home that this UAV must
 * keep clear of. UAVs that do not matter are at infinity.
 */
std::vector<double> Separation::gaps_m(int uav, const Disc& disc) const
{
    const std::size_t count = m_members.size();
    std::vector<double> gaps(2 * count, kFar);
    for (std::size_t other = 0; other < count; ++other) {
        const Member& them = m_members[other];
        if (!them.disc || static_cast<int>(other) == uav ||
            !shareLayer(uav, static_cast<int>(other)))
            continue;
        gaps[other] = gap_m(them, disc);
        if (!them.ahead_m.empty() && precedes(static_cast<int>(other), uav))
            gaps[count + other] = (nearestOn(them.ahead_m, disc.middle_m) - disc.middle_m).norm() -
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
    me.departure = {};
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
    me.ahead_m.clear();
    me.due_s.reset();
    me.departure = {};
    me.waits_s = 0;
    me.blocker.reset();
    me.denied_s = 0;
    me.waited_s = 0;
}

/** Returns the UAV and all UAVs too close to it or, in turn, to one of them. */
std::vector<int> Separation::nearby(int uav) const
{
    std::vector<int> found{uav};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::vector<double> gaps = gaps_m(found[i], *m_members[index(found[i])].disc);
        for (int other = 0; other < static_cast<int>(m_members.size()); ++other)
            if (gaps[index(other)] < m_separation_m &&
                std::ranges::find(found, other) == found.end())
                found.push_back(other);
    }
    return found;
}

void Separation::depart(std::span<const Departing> fleet)
{
    std::vector<bool> isDone(m_members.size());
    for (int first = 0; first < static_cast<int>(m_members.size()); ++first) {
        if (!concerns(first) || isDone[index(first)])
            continue;
        const std::vector<int> group = nearby(first);
        std::vector<Departing> uavs;
        for (const int uav : group) {
            isDone[index(uav)] = true;
            uavs.push_back(fleet[index(uav)]);
            uavs.back().radius_m = m_members[index(uav)].radius_m;
        }
        if (group.size() < 2)
            continue;
        const auto isClear = [&](int uav, const Disc& disc) {
            const std::vector<double> gaps = gaps_m(uav, disc);
            for (int other = 0; other < static_cast<int>(m_members.size()); ++other)
                if (gaps[index(other)] < m_separation_m &&
                    std::ranges::find(group, other) == group.end())
                    return false;
            return true;
        };
        const auto mayDepart = [&](std::size_t i, const Departure& departure) {
            const SafetyGuard& guard = uavs[i].guard;
            return isInside(guard, departure.middle_m, uavs[i].radius_m) &&
                   isClear(group[i],
                           {.middle_m = departure.middle_m, .radius_m = uavs[i].radius_m}) &&
                   std::ranges::all_of(departure.path_m, [&](const Point& place_m) {
                       return isInside(guard, place_m, 0) &&
                              isClear(group[i], {.middle_m = place_m});
                   });
        };
        std::vector<Departure> departures = departuresOf(uavs, m_separation_m, mayDepart);
        for (std::size_t i = 0; i < departures.size(); ++i) {
            Member& me = m_members[index(group[i])];
            me.disc = {.middle_m = departures[i].middle_m,
                       .radius_m = me.radius_m,
                       .side = departures[i].side};
            me.departure = std::move(departures[i]);
        }
    }
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
        std::optional<int> blocker;
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

/**
 * Returns true if `first` goes before `second`: of UAVs flying home the one that was due first when
 * it set out, else the one that has waited longer. Ties go to the first in the fleet.
 */
bool Separation::precedes(int first, int second) const
{
    const auto rank = [this](int uav) {
        const Member& member = m_members[index(uav)];
        // Waiting time does not count on the path home: two UAVs would yield to each other by
        // turns.
        return std::tuple(member.due_s.value_or(kFar), !member.due_s,
                          member.due_s ? 0 : -std::floor(member.waited_s / kWait_s), uav);
    };
    return rank(first) < rank(second);
}

/**
 * Returns the UAV to fly away from: one that is too close, or one that goes first and has long been
 * blocked by this UAV; nullopt if there is none.
 */
std::optional<int> Separation::avoided(int uav, const std::vector<double>& gaps) const
{
    const auto nearest = std::ranges::min_element(gaps);
    if (*nearest < m_separation_m)
        return static_cast<int>(nearest - gaps.begin()) % static_cast<int>(m_members.size());
    for (int other = 0; other < static_cast<int>(m_members.size()); ++other)
        if (const Member& them = m_members[index(other)];
            them.blocker == uav && them.denied_s >= kPatience_s && precedes(other, uav))
            return other;
    return std::nullopt;
}

/**
 * Returns true while the UAV that it waits for is still in its path home. Otherwise they would fly
 * on side by side, each turning with the other.
 */
bool Separation::waitsOn(int uav) const
{
    const Member& me = m_members[index(uav)];
    if (me.waits_s == 0 || me.waits_s > kLongestWait_s || me.ahead_m.empty() || !me.blocker)
        return false;
    const std::optional<Disc>& theirs = m_members[index(*me.blocker)].disc;
    return theirs && (nearestOn(me.ahead_m, theirs->middle_m) - theirs->middle_m).norm() <
                         theirs->radius_m + me.radius_m + m_separation_m;
}

/** Returns the nearest point of the other UAV or its path home. */
Point Separation::placeToAvoid_m(int other, const Point& from_m) const
{
    const Member& them = m_members[index(other)];
    return them.ahead_m.empty() ? them.place_m : nearestOn(them.ahead_m, from_m);
}

void Separation::note(int uav, const Trial& result, const DesiredTurn& desired, double command_s)
{
    Member& me = m_members[index(uav)];
    if (result.disc) {
        me.denied_s = std::max(0.0, me.denied_s - command_s);
        if (me.denied_s == 0)
            me.blocker.reset();
        return;
    }
    me.denied_s = std::min(2 * kPatience_s, me.denied_s + command_s);
    me.blocker = result.blocker;
    if (desired.hasGoal)
        me.waited_s += command_s;
}

/**
 * Returns the path that others keep clear of: the next minute of the proven path home, with the
 * whole of a passage that begins in it, or a straight line to the pad without a proven path.
 */
std::vector<Point> Separation::pathAhead_m(int uav, const SafetyGuard& guard,
                                           const DubinsState& pose,
                                           const DesiredTurn& desired) const
{
    const std::optional<ReturnPath>& path = guard.sortie().returnPath;
    if (!path) {
        const Point path_m = *desired.home_m - pose.position_m;
        const double clear_m = kAhead_s * guard.uav().motion.airspeed_mps;
        return {pose.position_m, pose.position_m + std::min(1.0, clear_m / path_m.norm()) * path_m};
    }
    std::vector<Point> ahead_m{pose.position_m};
    DubinsState at = guard.heldFor(pose, desired.rate_radps, guard.uav().clock.steps);
    double flown_s = guard.uav().clock.command_s();
    double noted_s = 0;
    for (ReturnPath rest = *path;;) {
        const bool isEnd =
            rest.parts.empty() || (flown_s >= kAhead_s && flown_s >= noted_s + kPiece_s &&
                                   !hasNoCircle(guard, at, m_members[index(uav)].radius_m));
        if (isEnd || flown_s >= noted_s + kPiece_s) {
            ahead_m.push_back(at.position_m);
            noted_s = flown_s;
        }
        if (isEnd)
            return ahead_m;
        at = guard.heldFor(at, rest.takeNext_radps(), guard.uav().clock.steps);
        flown_s += guard.uav().clock.command_s();
    }
}

/**
 * Tries a passage. A proven path home may lead where no circle is inside the fence; the passage is
 * then reserved up to the next circle and flown to its end.
 */
Separation::Trial Separation::passage(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                      double rate_radps) const
{
    Trial trial{.rate_radps = rate_radps};
    if (!guard.sortie().returnPath)
        return trial;
    Departure through{.path_m = {pose.position_m}};
    DubinsState at = pose;
    Disc end{.radius_m = m_members[index(uav)].radius_m};
    double leastGap_m = m_separation_m;
    const auto isClear = [&](const Disc& disc) {
        const std::vector<double> gaps = gaps_m(uav, disc);
        const auto nearest = std::ranges::min_element(gaps);
        if (*nearest < leastGap_m) {
            leastGap_m = *nearest;
            trial.blocker =
                static_cast<int>(nearest - gaps.begin()) % static_cast<int>(m_members.size());
        }
        return *nearest >= m_separation_m;
    };
    bool hasCircle = false;
    for (ReturnPath rest = *guard.sortie().returnPath; !hasCircle;) {
        through.rates_radps.push_back(through.rates_radps.empty() ? rate_radps
                                                                  : rest.takeNext_radps());
        for (std::int64_t i = 0; i < guard.uav().clock.steps; ++i) {
            at = guard.heldFor(at, through.rates_radps.back(), 1);
            through.path_m.push_back(at.position_m);
        }
        for (const double side : {-1.0, 1.0}) {
            end.middle_m = middleBeside_m(at, guard.uav().motion, side);
            end.side = side;
            if (!isInside(guard, end.middle_m, end.radius_m))
                continue;
            hasCircle = true;
            if (isClear(end))
                trial.disc = end;
        }
        if (!hasCircle && rest.parts.empty()) { // the pad itself is in the passage
            trial.disc = Disc{.middle_m = at.position_m};
            break;
        }
    }
    for (const Point& place_m : through.path_m)
        if (!isClear({.middle_m = place_m}))
            trial.disc.reset();
    trial.passage = std::move(through);
    return trial;
}

double Separation::command_radps(int uav, const SafetyGuard& guard, const DubinsState& pose,
                                 const DesiredTurn& desired)
{
    Member& me = m_members[index(uav)];
    me.place_m = pose.position_m;
    me.ahead_m = desired.home_m ? pathAhead_m(uav, guard, pose, desired) : std::vector<Point>();
    me.due_s = desired.home_m ? std::optional(me.due_s.value_or(desired.due_s.value_or(kFar)))
                              : std::nullopt;
    if (const auto rate_radps = me.departure.takeNext_radps(guard.uav().clock.steps))
        return *rate_radps;
    me.disc->radius_m = me.radius_m; // the path to the circle has been flown
    std::vector<double> least_m = gaps_m(uav, *me.disc);
    const std::optional<int> other = avoided(uav, least_m);
    for (double& gap_m : least_m)
        gap_m = std::min(gap_m, m_separation_m);
    const auto tried = [&](double rate_radps) {
        return trial(uav, guard, pose, rate_radps, least_m);
    };

    if (!other && waitsOn(uav)) {
        note(uav, {.blocker = me.blocker}, desired, guard.uav().clock.command_s());
        me.waits_s += guard.uav().clock.command_s();
        return holdingRate_radps(guard, pose, me.disc->middle_m, me.disc->side);
    }
    const double desired_radps =
        other ? turnAway_radps(guard, pose, placeToAvoid_m(*other, pose.position_m))
              : desired.rate_radps;
    Trial best = tried(desired_radps);
    if (!best.disc && desired.home_m && !other) {
        if (Trial through = passage(uav, guard, pose, desired_radps); through.disc)
            best = std::move(through);
        else if (!best.blocker)
            best.blocker = through.blocker;
    }
    note(uav, best, desired, guard.uav().clock.command_s());
    const bool waits = best.blocker && (precedes(*best.blocker, uav)
                                            ? m_members[index(*best.blocker)].blocker.has_value()
                                            : me.denied_s >= kPatience_s);
    me.waits_s = waits && !me.ahead_m.empty() && !other ? guard.uav().clock.command_s() : 0;
    if (!waits)
        for (const double rate_radps : ratesByNearness(desired_radps, guard.uav().motion)) {
            if (best.disc)
                break;
            best = tried(rate_radps);
        }
    if (!best.disc)
        return holdingRate_radps(guard, pose, me.disc->middle_m, me.disc->side);
    me.disc = best.disc;
    me.departure = std::move(best.passage);
    return me.departure.takeNext_radps(guard.uav().clock.steps).value_or(best.rate_radps);
}

} // namespace berg
