#include "core/sim/sortie_outlook.h"

#include "core/base/random.h"
#include "core/scenario/checks.h"
#include "core/scenario/sortie.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace berg {

namespace {

using Places = std::span<const PlannedPlace>;

constexpr int kFlights = 1000;
constexpr int kLow = kFlights / 20;
constexpr double kWindError_mps = 1;
constexpr double kWindErrorShare = 0.15;
constexpr double kAirspeedErrorShare = 0.03;

/** Air and UAV of one flight. */
struct Air
{
    double airspeed_mps = 0;
    Point wind_mps = Point::Zero();
};

/** Of the path and home from its end; without end where the wind is too strong. */
double sortieTime_s(Places places, const Point& home_m, const Air& air)
{
    if (air.wind_mps.norm() >= air.airspeed_mps)
        return std::numeric_limits<double>::infinity();
    double time_s = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        time_s +=
            flightTime_s(places[i].place_m - places[i - 1].place_m, air.airspeed_mps, air.wind_mps);
    return time_s + flightTime_s(home_m - places.back().place_m, air.airspeed_mps, air.wind_mps);
}

Air airOf(const Uav& uav, const PlannedPath& path)
{
    return {.airspeed_mps = uav.spec.airspeed_mps, .wind_mps = path.wind_mps};
}

Places sortieOf(const PlannedPath& path)
{
    return Places(path.places)
        .first(std::clamp<std::size_t>(path.thisSortie, 1, path.places.size()));
}

PlannedPlace between(const PlannedPlace& from, const PlannedPlace& to, double part)
{
    return {.time_s = std::lerp(from.time_s, to.time_s, part),
            .place_m = from.place_m + part * (to.place_m - from.place_m)};
}

/** Where the margin ends, which never grows along the path. */
std::optional<PlannedPlace> noReturn(Places places, const Point& home_m, const Air& air,
                                     double left_s)
{
    constexpr int kHalvings = 40;
    const auto isLate = [&](const PlannedPlace& at) {
        return at.time_s + flightTime_s(home_m - at.place_m, air.airspeed_mps, air.wind_mps) >
               left_s;
    };
    const auto late = std::ranges::find_if(places, isLate);
    if (late == places.end())
        return std::nullopt;
    if (late == places.begin())
        return *late;
    double home = 0;
    double gone = 1;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (home + gone) / 2;
        (isLate(between(*(late - 1), *late, middle)) ? gone : home) = middle;
    }
    return between(*(late - 1), *late, home);
}

/** Part of a straight leg that lies within the circle. */
double shareInside(const Point& from_m, const Point& to_m, const Point& centre_m, double radius_m)
{
    const Point leg_m = to_m - from_m;
    const Point back_m = from_m - centre_m;
    const double a = leg_m.squaredNorm();
    if (a == 0)
        return back_m.norm() <= radius_m ? 1 : 0;
    const double b = back_m.dot(leg_m);
    const double root = b * b - a * (back_m.squaredNorm() - radius_m * radius_m);
    if (root <= 0)
        return 0;
    const double in = std::clamp((-b - std::sqrt(root)) / a, 0.0, 1.0);
    const double out = std::clamp((-b + std::sqrt(root)) / a, 0.0, 1.0);
    return out - in;
}

double noContact_s(Places places, const Point& centre_m, double radius_m)
{
    double outside_s = 0;
    for (std::size_t i = 1; i < places.size(); ++i)
        outside_s +=
            (places[i].time_s - places[i - 1].time_s) *
            (1 - shareInside(places[i - 1].place_m, places[i].place_m, centre_m, radius_m));
    return outside_s;
}

} // namespace

double linkRange_m(const GroundStation& station, double height_m)
{
    constexpr double kHorizon_m = 4120;
    return station.range_m.value_or(kHorizon_m *
                                    (std::sqrt(station.antenna_m) + std::sqrt(height_m)));
}

SortieOutlook sortieOutlook(const Scenario& scenario, const Uav& uav, const PlannedPath& path)
{
    SortieOutlook outlook;
    if (path.places.empty())
        return outlook;
    const Air air = airOf(uav, path);
    std::vector<PlannedPlace> flown(sortieOf(path).begin(), sortieOf(path).end());
    if (const std::optional<SortieSpec> sortie = sortieOf(uav)) {
        const double left_s = sortie->endurance_s - path.aloft_s;
        const double home_s = sortieTime_s(flown, sortie->home_m, air);
        outlook.margin_s = left_s - home_s;
        outlook.noReturn = noReturn(path.places, sortie->home_m, air, left_s);
        flown.push_back({.time_s = home_s, .place_m = sortie->home_m});
    }
    if (const std::optional<GroundStation>& station = scenario.groundStation)
        outlook.noContact_s =
            noContact_s(flown, station->position_m, linkRange_m(*station, uav.spec.altitude_m));
    return outlook;
}

std::optional<double> lowMargin_s(const Uav& uav, const PlannedPath& path)
{
    const std::optional<SortieSpec> sortie = sortieOf(uav);
    if (!sortie || path.places.empty())
        return std::nullopt;
    Random random(0, stableHash("wind and airspeed"));
    const Air air = airOf(uav, path);
    const double windError_mps = kWindError_mps + kWindErrorShare * air.wind_mps.norm();
    std::vector<double> margins_s;
    for (int flight = 0; flight < kFlights; ++flight) {
        const double east = random.normal();
        const double north = random.normal();
        const Air drawn{.airspeed_mps =
                            air.airspeed_mps * (1 + kAirspeedErrorShare * random.normal()),
                        .wind_mps = air.wind_mps + windError_mps * Point(east, north)};
        margins_s.push_back(sortie->endurance_s - path.aloft_s -
                            sortieTime_s(sortieOf(path), sortie->home_m, drawn));
    }
    const auto low = margins_s.begin() + kLow;
    std::nth_element(margins_s.begin(), low, margins_s.end());
    return *low;
}

std::vector<Issue> sortieIssues(std::size_t index, const SortieOutlook& outlook,
                                const std::optional<double>& lowMargin_s)
{
    std::vector<Issue> issues;
    if (lowMargin_s && *lowMargin_s < 0)
        issues.push_back(
            issueOf(Severity::Warning, entryPath("uavs", index) + ".endurance_s",
                    {.id = IssueId::ThinReserve, .arguments = {std::round(-*lowMargin_s)}}));
    if (outlook.noContact_s >= 1)
        issues.push_back(
            issueOf(Severity::Warning, "ground_station",
                    {.id = IssueId::NoContact, .arguments = {std::round(outlook.noContact_s)}}));
    return issues;
}

} // namespace berg
