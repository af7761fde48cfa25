#include "core/io/import/scenario/import_origin.h"

#include "core/base/angles.h"
#include "core/base/stopped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace berg {

namespace {

constexpr double kMeanEarth_m = 6'371'000;
constexpr double kReach_m = 1e6; ///< half the extent of the plane, in every direction
constexpr double kNear_m = 5e5;  ///< within it their mean is a good origin
/** Radii of dense groups, in order of preference. */
constexpr std::array kGroupRadii_m = {3e5, 6e5, 9.5e5};

/** Place of an iceberg as a direction from the Earth's centre. */
struct Spot
{
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    std::size_t sightings = 0;
};

Eigen::Vector3d directionOf(const LatLon& place)
{
    const double latitude_rad = radFromDeg(place.latitude_deg);
    const double longitude_rad = radFromDeg(place.longitude_deg);
    return {std::cos(latitude_rad) * std::cos(longitude_rad),
            std::cos(latitude_rad) * std::sin(longitude_rad), std::sin(latitude_rad)};
}

/** Straight distance through the Earth; at 1000 km it is 0.1 % shorter than over ground. */
double distance_m(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return (a - b).norm() * kMeanEarth_m;
}

bool isNowhere(const LatLon& place)
{
    return place.latitude_deg == 0 && place.longitude_deg == 0;
}

/** Whether an iceberg can have been at both places, with a margin for the errors of any report. */
bool isReachable(const PlacedSighting& from, const PlacedSighting& to)
{
    constexpr double kError_m = 5e4;
    constexpr double kFast_mps = 5;
    const double time_s = std::abs(to.fix.time_s - from.fix.time_s);
    return distance_m(directionOf(from.sighting->place), directionOf(to.sighting->place)) <=
           kError_m + kFast_mps * time_s;
}

/** Returns the last place that an iceberg can have reached; the first of several at that time. */
LatLon lastPlace(const SightedIceberg& iceberg)
{
    std::vector<const PlacedSighting*> sightings;
    for (const PlacedSighting& placed : iceberg.sightings)
        if (!isNowhere(placed.sighting->place))
            sightings.push_back(&placed);
    if (sightings.empty())
        return iceberg.sightings.front().sighting->place;
    const auto time = [](const PlacedSighting* placed) { return placed->fix.time_s; };
    std::ranges::stable_sort(sightings, {}, time);
    std::size_t last = sightings.size() - 1;
    while (last >= 2 && !isReachable(*sightings[last - 1], *sightings[last]) &&
           isReachable(*sightings[last - 2], *sightings[last - 1]))
        --last;
    while (last > 0 && time(sightings[last - 1]) == time(sightings[last]))
        --last;
    return sightings[last]->sighting->place;
}

/** Returns the spots of icebergs with a real place, or of all if none has. */
std::vector<Spot> spotsOf(const std::vector<SightedIceberg>& icebergs, const std::stop_token& stop)
{
    std::vector<Spot> all;
    std::vector<Spot> known;
    for (const SightedIceberg& iceberg : icebergs) {
        throwIfStopped(stop);
        const LatLon place = lastPlace(iceberg);
        all.push_back({.direction = directionOf(place), .sightings = iceberg.sightings.size()});
        if (!isNowhere(place))
            known.push_back(all.back());
    }
    return known.empty() ? all : known;
}

/**
 * Returns the mean direction of the spots within a distance of a centre, or nullopt if there is
 * none.
 */
std::optional<Eigen::Vector3d> middleWithin(const std::vector<Spot>& spots,
                                            const Eigen::Vector3d& centre, double radius_m)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Spot& spot : spots)
        if (distance_m(spot.direction, centre) <= radius_m)
            sum += spot.direction;
    if (sum.norm() < 1e-9)
        return std::nullopt;
    return sum.normalized();
}

/** Spots within one cube of a grid through the Earth. */
struct Cell
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t icebergs = 0;
    std::size_t sightings = 0;
    std::size_t first = 0; ///< index of the first spot
};
using Grid = std::map<std::array<int, 3>, Cell>;

Grid gridOf(const std::vector<Spot>& spots, double size_m)
{
    Grid grid;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        std::array<int, 3> key{};
        for (int axis = 0; axis < 3; ++axis)
            key[static_cast<std::size_t>(axis)] =
                static_cast<int>(std::floor(spots[i].direction[axis] * kMeanEarth_m / size_m));
        const auto [it, isNew] = grid.try_emplace(key);
        Cell& cell = it->second;
        if (isNew)
            cell.first = i;
        cell.sum += spots[i].direction;
        ++cell.icebergs;
        cell.sightings += spots[i].sightings;
    }
    return grid;
}

/** Returns the middle of the densest group of about this radius, or nullopt without spots. */
std::optional<Eigen::Vector3d> denseMiddle(const std::vector<Spot>& spots, double radius_m,
                                           const std::stop_token& stop)
{
    const Grid grid = gridOf(spots, radius_m);
    std::tuple<std::size_t, std::size_t, std::size_t> best;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const auto& [key, cell] : grid) {
        throwIfStopped(stop);
        const Eigen::Vector3d middle = cell.sum.normalized();
        std::size_t icebergs = 0;
        std::size_t sightings = 0;
        for (int i = 0; i < 27; ++i) {
            const auto near =
                grid.find({key[0] + i % 3 - 1, key[1] + i / 3 % 3 - 1, key[2] + i / 9 - 1});
            if (near == grid.end() || distance_m(near->second.sum.normalized(), middle) > radius_m)
                continue;
            icebergs += near->second.icebergs;
            sightings += near->second.sightings;
        }
        const std::tuple rank(icebergs, sightings, spots.size() - cell.first);
        if (rank > best) {
            best = rank;
            centre = middle;
        }
    }
    for (int i = 0; i < 2; ++i)
        centre = middleWithin(spots, centre, radius_m).value_or(centre);
    return grid.empty() ? std::nullopt : std::optional(centre);
}

/** Counts the icebergs, and their sightings, within the plane of this origin. */
std::pair<std::size_t, std::size_t> inReach(const std::vector<Spot>& spots,
                                            const Eigen::Vector3d& origin)
{
    std::pair<std::size_t, std::size_t> count;
    for (const Spot& spot : spots)
        if (distance_m(spot.direction, origin) <= kReach_m) {
            ++count.first;
            count.second += spot.sightings;
        }
    return count;
}

LatLon roundedPlace(const Eigen::Vector3d& direction)
{
    const auto rounded = [](double angle_rad) {
        return std::round(degFromRad(angle_rad) * 1e4) / 1e4;
    };
    return {.latitude_deg =
                rounded(std::atan2(direction.z(), std::hypot(direction.x(), direction.y()))),
            .longitude_deg = rounded(std::atan2(direction.y(), direction.x()))};
}

} // namespace

std::optional<LatLon> originOf(const std::vector<SightedIceberg>& icebergs,
                               const std::stop_token& stop)
{
    const std::vector<Spot> spots = spotsOf(icebergs, stop);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Spot& spot : spots)
        sum += spot.direction;
    if (spots.empty())
        return std::nullopt;
    const bool hasMean = sum.norm() >= 1e-9;
    const Eigen::Vector3d mean = sum.normalized();
    if (hasMean && std::ranges::all_of(spots, [&](const Spot& spot) {
            return distance_m(spot.direction, mean) <= kNear_m;
        }))
        return roundedPlace(sum);
    std::vector<Eigen::Vector3d> candidates;
    for (const double radius_m : kGroupRadii_m)
        if (const std::optional<Eigen::Vector3d> middle = denseMiddle(spots, radius_m, stop))
            candidates.push_back(*middle);
    if (hasMean)
        candidates.push_back(mean);
    const auto best =
        std::ranges::max_element(candidates, {}, [&](const Eigen::Vector3d& candidate) {
            return inReach(spots, candidate);
        });
    return best == candidates.end() ? std::nullopt : std::optional(roundedPlace(*best));
}

} // namespace berg
