#include "core/mission/sortie_outlook.h"

#include "core/base/random.h"
#include "core/scenario/text_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace berg {

namespace {

constexpr int kFlights = 1000;
constexpr int kLow = kFlights / 20;
constexpr double kWindError_mps = 1;
constexpr double kWindErrorShare = 0.15;
constexpr double kAirspeedErrorShare = 0.03;

/** Airspeed and wind of one flight. */
struct Air
{
    double airspeed_mps = 0;
    WindAhead wind_mps;
    Point windError_mps = Point::Zero();
};

/** Flight time over a straight piece of the path, begun at that time since its start. */
double pieceTime_s(const Point& piece_m, const Air& air, double from_s)
{
    return flightTime_s(piece_m, air.airspeed_mps, Point(-air.windError_mps), air.wind_mps, from_s);
}

/**
 * Flight time along the places, begun at `from_s`, or infinity if the wind is too strong.
 */
double time_s(std::span<const Point> places_m, const Air& air, double from_s = 0)
{
    if ((air.wind_mps.at_mps(from_s) + air.windError_mps).norm() >= air.airspeed_mps)
        return std::numeric_limits<double>::infinity();
    double time_s = 0;
    for (std::size_t i = 1; i < places_m.size(); ++i)
        time_s += pieceTime_s(places_m[i] - places_m[i - 1], air, from_s + time_s);
    return time_s;
}

Air airOf(const Uav& uav, const PlannedPath& path)
{
    return {.airspeed_mps = uav.spec.airspeed_mps, .wind_mps = path.wind_mps};
}

/** Appends the path to the place, around the fence. */
void flyTo(std::vector<Point>& flown_m, const Point& place_m, const Geofence* fence)
{
    if (fence != nullptr)
        for (const Point& corner_m : fence->cornersBetween(flown_m.back(), place_m))
            flown_m.push_back(corner_m);
    flown_m.push_back(place_m);
}

/** Returns the path of this sortie up to its last iceberg, and home if the endurance is limited. */
std::vector<Point> sortiePath_m(const Uav& uav, const PlannedPath& path)
{
    const std::size_t count = std::clamp<std::size_t>(path.thisSortie, 1, path.places_m.size());
    std::vector<Point> flown_m{path.places_m.front()};
    for (std::size_t i = 1; i < count; ++i)
        flyTo(flown_m, path.places_m[i], path.fence.get());
    if (const std::optional<SortieSpec> sortie = sortieOf(uav))
        flyTo(flown_m, sortie->home_m, path.fence.get());
    return flown_m;
}

/** Returns the point at which the margin reaches zero; the margin never grows along the path. */
std::optional<NoReturn> noReturn(const PlannedPath& path, const Point& home_m, const Air& air,
                                 double left_s)
{
    constexpr int kHalvings = 20;
    const auto isLate = [&](double flown_s, const Point& place_m) {
        std::vector<Point> back_m{place_m};
        flyTo(back_m, home_m, path.fence.get());
        return flown_s + time_s(back_m, air, flown_s) > left_s;
    };
    if (isLate(0, path.places_m.front()))
        return NoReturn{.path_m = {path.places_m.front()}};
    double flown_s = 0;
    for (std::size_t i = 1; i < path.places_m.size(); ++i) {
        std::vector<Point> leg_m{path.places_m[i - 1]};
        flyTo(leg_m, path.places_m[i], path.fence.get());
        for (std::size_t k = 1; k < leg_m.size(); ++k) {
            const Point piece_m = leg_m[k] - leg_m[k - 1];
            const double piece_s = pieceTime_s(piece_m, air, flown_s);
            if (!isLate(flown_s + piece_s, leg_m[k])) {
                flown_s += piece_s;
                continue;
            }
            const bool isSteady = air.wind_mps.nextChange_s(flown_s) >= flown_s + piece_s;
            const auto partTime_s = [&](double part) {
                return isSteady ? part * piece_s : pieceTime_s(part * piece_m, air, flown_s);
            };
            double inTime = 0;
            double late = 1;
            for (int round = 0; round < kHalvings; ++round) {
                const double middle = (inTime + late) / 2;
                (isLate(flown_s + partTime_s(middle), leg_m[k - 1] + middle * piece_m) ? late
                                                                                       : inTime) =
                    middle;
            }
            leg_m.resize(k);
            leg_m.push_back(leg_m.back() + inTime * piece_m);
            return NoReturn{.time_s = flown_s + partTime_s(inTime), .path_m = std::move(leg_m)};
        }
    }
    return std::nullopt;
}

/** Share of a straight leg that lies inside the circle. */
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

double noContact_s(std::span<const Point> places_m, const Air& air, const Point& centre_m,
                   double radius_m)
{
    double outside_s = 0;
    double flown_s = 0;
    for (std::size_t i = 1; i < places_m.size(); ++i) {
        const double piece_s = time_s(places_m.subspan(i - 1, 2), air, flown_s);
        flown_s += piece_s;
        outside_s += piece_s * (1 - shareInside(places_m[i - 1], places_m[i], centre_m, radius_m));
    }
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
    if (path.places_m.empty())
        return outlook;
    const Air air = airOf(uav, path);
    const std::vector<Point> flown_m = sortiePath_m(uav, path);
    if (const std::optional<SortieSpec> sortie = sortieOf(uav)) {
        const double left_s = sortie->endurance_s - path.aloft_s;
        outlook.margin_s = left_s - time_s(flown_m, air);
        outlook.noReturn = noReturn(path, sortie->home_m, air, left_s);
    }
    if (const std::optional<GroundStation>& station = scenario.groundStation)
        outlook.noContact_s = noContact_s(flown_m, air, station->position_m,
                                          linkRange_m(*station, uav.spec.altitude_m));
    return outlook;
}

std::optional<double> lowMargin_s(const Uav& uav, const PlannedPath& path)
{
    const std::optional<SortieSpec> sortie = sortieOf(uav);
    if (!sortie || path.places_m.empty())
        return std::nullopt;
    Random random(0, stableHash("wind and airspeed"));
    const Air air = airOf(uav, path);
    const std::vector<Point> flown_m = sortiePath_m(uav, path);
    const double windError_mps = kWindError_mps + kWindErrorShare * air.wind_mps.at_mps(0).norm();
    std::vector<double> margins_s;
    for (int flight = 0; flight < kFlights; ++flight) {
        const double east = random.normal();
        const double north = random.normal();
        const Air drawn{.airspeed_mps =
                            air.airspeed_mps * (1 + kAirspeedErrorShare * random.normal()),
                        .wind_mps = air.wind_mps,
                        .windError_mps = windError_mps * Point(east, north)};
        margins_s.push_back(sortie->endurance_s - path.aloft_s - time_s(flown_m, drawn));
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
            Issue{Severity::Warning, entryPath("uavs", index) + ".endurance_s",
                  std::isfinite(*lowMargin_s)
                      ? IssueReason{IssueId::ThinReserve,
                                    {Amount{std::round(-*lowMargin_s), Quantity::Seconds}}}
                      : IssueReason{IssueId::MayNotReturn}});
    if (outlook.noContact_s >= 1)
        issues.push_back(
            Issue{Severity::Warning,
                  entryPath("uavs", index),
                  {.id = IssueId::NoContact,
                   .arguments = {Amount{std::round(outlook.noContact_s), Quantity::Seconds}}}});
    return issues;
}

} // namespace berg
