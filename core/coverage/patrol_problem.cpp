#include "core/coverage/patrol_problem.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

/** Legs that are shorter than this have no direction. */
constexpr double kNoLeg_m = 1;

/**
 * Returns the point of the disk about `centre_m` that is nearest to the onward path, or the point
 * at which that path enters the disk.
 */
Point aimOf(const PatrolUav& uav, const Point& from_m, const Point& centre_m, const Point* onward_m)
{
    const Point toCentre_m = centre_m - from_m;
    if (onward_m != nullptr) {
        const Point path_m = *onward_m - from_m;
        const double length2_m2 = std::max(1.0, path_m.squaredNorm());
        const double share = toCentre_m.dot(path_m) / length2_m2;
        if (share > 0) {
            const Point off_m = from_m + path_m * std::min(1.0, share) - centre_m;
            const double off2_m2 = off_m.squaredNorm();
            const double reach2_m2 = uav.reach_m * uav.reach_m;
            if (off2_m2 > reach2_m2)
                return centre_m + off_m * (uav.reach_m / std::sqrt(off2_m2));
            const double entry = share - std::sqrt((reach2_m2 - off2_m2) / length2_m2);
            if (share <= 1)
                return from_m + path_m * std::max(0.0, entry);
        }
    }
    return centre_m - toCentre_m * (uav.reach_m / toCentre_m.norm());
}

/** Returns by how many metres a turn of theta at the limit and the line after it are longer than
 * the line to a place far away: (theta - sin theta) radius. The arc cosine is that of Abramowitz
 * and Stegun (1964), 4.4.45, within 7e-5. */
double turn_m(const PatrolUav& uav, const Point& before, const Point& after)
{
    const double cosine = after.dot(before);
    const double x = std::min(1.0, std::abs(cosine));
    const double acute_rad =
        std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x)));
    const double turn_rad = cosine < 0 ? kPi - acute_rad : acute_rad;
    return std::max(0.0, turn_rad - std::abs(cross(before, after))) * uav.radius_m;
}

/**
 * Returns the time between coming home from a stop and the end of the sortie, negative if the UAV
 * would be late. Where much time is left, the result is a quick lower limit.
 */
double spare_s(const PatrolUav& uav, const PatrolStop& stop)
{
    constexpr double kPlenty_s = 600;
    const double left_s = stop.sortieEnd_s - stop.time_s;
    const Point way_m = uav.sorties->home.at(stop.time_s) - stop.place_m;
    const double longest_m = way_m.lpNorm<1>() + kPi * uav.radius_m;
    const double quick_s = left_s - longest_m / uav.speed_mps;
    return quick_s > kPlenty_s ? quick_s : left_s - patrolTimeHome_s(uav, stop);
}

PatrolStop directLeg(const PatrolUav& uav, const PatrolStop& from, const DriftingPlace& to,
                     const DriftingPlace* next)
{
    Point centre_m = to.at(from.time_s);
    const double flight_s =
        std::max(0.0, (centre_m - from.place_m).norm() - uav.reach_m) / uav.speed_mps;
    centre_m += to.velocity_mps * flight_s;
    PatrolStop stop = from;
    stop.tookOff = false;
    stop.missing_s = std::numeric_limits<double>::infinity();
    if ((centre_m - from.place_m).squaredNorm() <= uav.reach_m * uav.reach_m)
        return stop;
    Point onward_m = Point::Zero();
    if (next != nullptr)
        onward_m = next->at(from.time_s + flight_s);
    stop.place_m = aimOf(uav, from.place_m, centre_m, next != nullptr ? &onward_m : nullptr);
    const Point leg_m = stop.place_m - from.place_m;
    const double length_m = leg_m.norm();
    if (length_m < kNoLeg_m)
        return stop;
    stop.ahead = leg_m / length_m;
    stop.time_s += (length_m + turn_m(uav, from.ahead, stop.ahead)) / uav.speed_mps;
    return stop;
}

} // namespace

PatrolStop patrolStart(const PatrolUav& uav)
{
    PatrolStop stop{.place_m = uav.start.position_m, .ahead = uav.start.ahead};
    if (uav.sorties)
        stop.sortieEnd_s = uav.sorties->left_s;
    return stop;
}

double patrolTimeHome_s(const PatrolUav& uav, const PatrolStop& from)
{
    const Point path_m = uav.sorties->home.at(from.time_s) - from.place_m;
    const double length_m = path_m.norm();
    return length_m < kNoLeg_m
               ? 0
               : (length_m + turn_m(uav, from.ahead, path_m / length_m)) / uav.speed_mps;
}

PatrolStop patrolLeg(const PatrolUav& uav, const PatrolStop& from, const DriftingPlace& to,
                     const DriftingPlace* next)
{
    PatrolStop stop = directLeg(uav, from, to, next);
    if (!uav.sorties)
        return stop;
    stop.spare_s = spare_s(uav, stop);
    if (stop.spare_s >= 0)
        return stop;
    const double missing_s = -stop.spare_s;
    PatrolStop home = from;
    home.time_s += patrolTimeHome_s(uav, from) + uav.sorties->ground_s;
    home.place_m = uav.sorties->home.at(home.time_s);
    const Point path_m = to.at(home.time_s) - home.place_m;
    if (path_m.norm() > kNoLeg_m)
        home.ahead = path_m.normalized();
    home.sortieEnd_s = home.time_s + uav.sorties->length_s;
    stop = directLeg(uav, home, to, next);
    stop.tookOff = true;
    stop.missing_s = missing_s;
    stop.spare_s = spare_s(uav, stop);
    if (stop.spare_s < 0) // No sortie is long enough.
        stop.time_s = std::numeric_limits<double>::infinity();
    return stop;
}

} // namespace berg
