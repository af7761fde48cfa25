#include "widgets/document/scenario_edits.h"

#include "core/base/angles.h"
#include "core/scenario/limits.h"
#include "widgets/document/selection.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace berg {
namespace {

constexpr char kIcebergStem[] = "berg-";

bool isId(const Scenario& scenario, const std::string& id)
{
    return findById(scenario.icebergs, id) != nullptr || findById(scenario.uavs, id) != nullptr;
}

std::string freshId(const Scenario& scenario, const std::string& stem, std::size_t first)
{
    std::string id;
    do {
        id = stem + std::to_string(first++);
    } while (isId(scenario, id));
    return id;
}

/** Copies nearer than this to an iceberg hide it. */
constexpr double kHiding_m = 1;

/** Returns the name without a trailing number: "Big" for "Big 2". */
std::string withoutNumber(const std::string& name)
{
    const std::size_t space = name.find_last_not_of("0123456789");
    const bool isNumbered = space != std::string::npos && space > 0 && space + 1 < name.size();
    return isNumbered && name[space] == ' ' ? name.substr(0, space) : name;
}

/** Unused ids and names for copies, each found in about constant time. */
class FreshNames
{
public:
    explicit FreshNames(const Scenario& scenario) : m_nextId(scenario.icebergs.size() + 1)
    {
        for (const Uav& uav : scenario.uavs)
            m_ids.insert(uav.id);
        for (const Iceberg& iceberg : scenario.icebergs) {
            m_ids.insert(iceberg.id);
            m_names.insert(iceberg.name);
        }
    }

    [[nodiscard]] std::string id()
    {
        std::string id;
        do {
            id = kIcebergStem + std::to_string(m_nextId++);
        } while (!m_ids.insert(id).second);
        return id;
    }

    /** Returns the name itself, or with the first number that makes it unique. */
    [[nodiscard]] std::string name(const std::string& wanted)
    {
        if (wanted.empty() || m_names.insert(wanted).second)
            return wanted;
        const std::string stem = withoutNumber(wanted);
        std::size_t& number = m_numbers.try_emplace(stem, 2).first->second;
        std::string name;
        do {
            name = stem + ' ' + std::to_string(number++);
        } while (!m_names.insert(name).second);
        return name;
    }

private:
    std::unordered_set<std::string> m_ids;
    std::unordered_set<std::string> m_names;
    std::unordered_map<std::string, std::size_t> m_numbers; ///< next number for each stem
    std::size_t m_nextId;
};

using IdSet = std::unordered_set<std::string_view>;

/** Returns the objects with these ids, in their order. */
template <class Object>
std::vector<Object> objectsOf(const std::vector<Object>& objects, std::span<const std::string> ids)
{
    const IdSet wanted(ids.begin(), ids.end());
    std::vector<Object> found;
    std::copy_if(objects.begin(), objects.end(), std::back_inserter(found),
                 [&](const Object& object) { return wanted.contains(object.id); });
    return found;
}

void removeUavs(Scenario& scenario, std::span<const std::string> ids)
{
    std::vector<Uav> removed = objectsOf(scenario.uavs, ids);
    if (!removed.empty() && removed.size() == scenario.uavs.size())
        removed.erase(removed.begin());
    for (const Uav& gone : removed) {
        std::erase_if(scenario.uavs, [&](const Uav& uav) { return uav.id == gone.id; });
        for (Iceberg& iceberg : scenario.icebergs)
            if (iceberg.uav == gone.id)
                iceberg.uav.clear();
    }
}

template <class S>
auto outlineOf(S& scenario, const std::string& key) -> decltype(&scenario.area_m)
{
    if (key == kAreaKey && !scenario.area_m.empty())
        return &scenario.area_m;
    const std::optional<std::size_t> place = noFlyPlace(key);
    return place && *place < scenario.noFly.size() ? &scenario.noFly[*place].corners_m : nullptr;
}

/** Returns the positions of the objects with these ids. */
std::vector<Point*> positionsOf(Scenario& scenario, std::span<const std::string> ids)
{
    std::unordered_map<std::string_view, Point*> byId;
    for (Iceberg& iceberg : scenario.icebergs)
        byId.emplace(iceberg.id, &iceberg.position_m);
    for (Uav& uav : scenario.uavs)
        byId.emplace(uav.id, &uav.position_m);
    std::vector<Point*> positions;
    for (const std::string& id : ids) {
        if (const auto found = byId.find(id); found != byId.end())
            positions.push_back(found->second);
        else if (id == kAssetKey && scenario.asset)
            positions.push_back(&scenario.asset->position_m);
        else if (std::vector<Point>* outline_m = outlineOf(scenario, id))
            for (Point& corner_m : *outline_m)
                positions.push_back(&corner_m);
    }
    return positions;
}

} // namespace

std::vector<Point>* outlineIn(Scenario& scenario, const std::string& key)
{
    return outlineOf(scenario, key);
}

const std::vector<Point>* outlineIn(const Scenario& scenario, const std::string& key)
{
    return outlineOf(scenario, key);
}

Point clampedPosition(const Point& position_m)
{
    return position_m.cwiseMax(-kLargestCoordinate_m).cwiseMin(kLargestCoordinate_m);
}

Point roundedTo(const Point& value, double step)
{
    return (value / step).array().round().matrix() * step;
}

Point velocityTowards(double speed_mps, double direction_deg)
{
    constexpr double kQuarter_deg = 90;
    const double quarter = std::round(direction_deg / kQuarter_deg);
    const double rest_rad = radFromDeg(direction_deg - kQuarter_deg * quarter);
    const double along_mps = speed_mps * std::cos(rest_rad);
    const double across_mps = speed_mps * std::sin(rest_rad);
    switch ((std::lround(quarter) % 4 + 4) % 4) {
    case 0:
        return {across_mps, along_mps};
    case 1:
        return {along_mps, -across_mps};
    case 2:
        return {-across_mps, -along_mps};
    default:
        return {-along_mps, across_mps};
    }
}

double directionOf(const Point& velocity_mps)
{
    return velocity_mps.isZero(0) ? 0
                                  : headingFromPsi(std::atan2(velocity_mps.y(), velocity_mps.x()));
}

Point clampedVelocity(const Point& velocity_mps, double most_mps)
{
    const double largest_mps = velocity_mps.cwiseAbs().maxCoeff();
    if (largest_mps <= most_mps)
        return velocity_mps;
    const Point shorter_mps = velocity_mps * (most_mps / largest_mps);
    return shorter_mps.cwiseMax(-most_mps).cwiseMin(most_mps);
}

std::string freshIcebergId(const Scenario& scenario)
{
    return freshId(scenario, kIcebergStem, scenario.icebergs.size() + 1);
}

std::string freshUavId(const Scenario& scenario)
{
    return freshId(scenario, "uav-", 1);
}

Uav anotherUav(const Scenario& scenario, const Uav& pattern, const Point& place_m)
{
    Uav uav = pattern;
    uav.id = freshUavId(scenario);
    uav.name.clear();
    uav.extraJson.clear();
    uav.position_m = clampedPosition(place_m);
    if (uav.home_m)
        uav.home_m = clampedPosition(*uav.home_m + uav.position_m - pattern.position_m);
    for (const Uav& present : scenario.uavs)
        uav.spec.altitude_m =
            std::max(uav.spec.altitude_m, present.spec.altitude_m + kLayerHeight_m);
    uav.spec.altitude_m = std::min(uav.spec.altitude_m, kLargestLength_m);
    return uav;
}

Uav anotherUav(const Scenario& scenario, const Point& place_m)
{
    return anotherUav(scenario, scenario.uavs.empty() ? Uav() : scenario.uavs.front(), place_m);
}

void renameObject(Scenario& scenario, const std::string& before, const std::string& after)
{
    for (Uav& uav : scenario.uavs)
        if (uav.id == before)
            uav.id = after;
    for (Iceberg& iceberg : scenario.icebergs) {
        if (iceberg.id == before)
            iceberg.id = after;
        if (iceberg.uav == before)
            iceberg.uav = after;
    }
}

void moveObjects(Scenario& scenario, std::span<const std::string> ids, const Point& offset_m)
{
    const std::vector<Point*> positions = positionsOf(scenario, ids);
    Point low_m = Point::Constant(-2 * kLargestCoordinate_m);
    Point high_m = Point::Constant(2 * kLargestCoordinate_m);
    for (const Point* position_m : positions) {
        low_m = low_m.cwiseMax(Point::Constant(-kLargestCoordinate_m) - *position_m);
        high_m = high_m.cwiseMin(Point::Constant(kLargestCoordinate_m) - *position_m);
    }
    const Point allowed_m = offset_m.cwiseMax(low_m).cwiseMin(high_m);
    for (Point* position_m : positions)
        // Rounding may exceed the limit by one bit.
        *position_m = clampedPosition(*position_m + allowed_m);
}

void removeIcebergs(Scenario& scenario, std::span<const std::string> ids)
{
    const IdSet removed(ids.begin(), ids.end());
    std::erase_if(scenario.icebergs,
                  [&](const Iceberg& iceberg) { return removed.contains(iceberg.id); });
}

std::size_t removableUavs(const Scenario& scenario, std::span<const std::string> ids)
{
    const std::size_t among = uavsOf(scenario, ids).size();
    return among == scenario.uavs.size() && among > 0 ? among - 1 : among;
}

void removeObjects(Scenario& scenario, std::span<const std::string> ids)
{
    removeIcebergs(scenario, ids);
    removeUavs(scenario, ids);
    if (std::find(ids.begin(), ids.end(), kAssetKey) != ids.end())
        scenario.asset.reset();
    if (std::find(ids.begin(), ids.end(), kAreaKey) != ids.end()) {
        scenario.area_m.clear();
        scenario.geofence = false;
    }
    std::size_t place = 0;
    std::erase_if(scenario.noFly, [&](const NoFlyArea&) {
        return std::find(ids.begin(), ids.end(), noFlyKey(place++)) != ids.end();
    });
}

std::vector<Iceberg> icebergsOf(const Scenario& scenario, std::span<const std::string> ids)
{
    return objectsOf(scenario.icebergs, ids);
}

std::vector<Uav> uavsOf(const Scenario& scenario, std::span<const std::string> ids)
{
    return objectsOf(scenario.uavs, ids);
}

std::vector<std::string> addCopies(Scenario& scenario, std::span<const Iceberg> icebergs,
                                   const Point& offset_m)
{
    std::vector<std::string> ids;
    FreshNames fresh(scenario);
    for (Iceberg copy : icebergs) {
        copy.id = fresh.id();
        copy.name = fresh.name(copy.name);
        if (findById(scenario.uavs, copy.uav) == nullptr)
            copy.uav.clear();
        ids.push_back(copy.id);
        scenario.icebergs.push_back(std::move(copy));
    }
    moveObjects(scenario, ids, offset_m);
    const std::size_t first = scenario.icebergs.size() - icebergs.size();
    for (std::size_t i = 0; i < icebergs.size(); ++i) {
        Iceberg& copy = scenario.icebergs[first + i];
        for (Point& place_m : copy.track.position_m)
            place_m = clampedPosition(place_m + copy.position_m - icebergs[i].position_m);
    }
    return ids;
}

Point freeOffset(const Scenario& scenario, std::span<const Iceberg> icebergs, const Point& step_m)
{
    const auto hides = [&](const Point& offset_m) {
        return std::any_of(icebergs.begin(), icebergs.end(), [&](const Iceberg& copy) {
            return std::any_of(
                scenario.icebergs.begin(), scenario.icebergs.end(), [&](const Iceberg& present) {
                    return (present.position_m - copy.position_m - offset_m).cwiseAbs().maxCoeff() <
                           kHiding_m;
                });
        });
    };
    Point offset_m = step_m;
    for (std::size_t tries = 0; tries < scenario.icebergs.size() && hides(offset_m); ++tries)
        offset_m += step_m;
    return offset_m;
}

Point freeUavPlace_m(const Scenario& scenario, const Point& place_m, const Point& step_m)
{
    const auto hides = [&](const Point& at_m) {
        return std::ranges::any_of(scenario.uavs, [&](const Uav& uav) {
            return (uav.position_m - at_m).norm() < step_m.norm() / 2;
        });
    };
    Point free_m = place_m;
    for (std::size_t tries = 0; tries < scenario.uavs.size() && hides(free_m); ++tries)
        free_m += step_m;
    return free_m;
}

bool sharesLayer(const Scenario& scenario)
{
    Scenario separated = scenario;
    separateLayers(separated);
    return scenario.separation_m > 0 && separated.uavs != scenario.uavs;
}

void separateLayers(Scenario& scenario)
{
    std::vector<double> taken_m;
    for (Uav& uav : scenario.uavs) {
        double& altitude_m = uav.spec.altitude_m;
        for (const double other_m : taken_m) // sorted from below, so that no layer is checked twice
            if (std::abs(altitude_m - other_m) < kLayerHeight_m)
                altitude_m = other_m + kLayerHeight_m;
        taken_m.insert(std::ranges::upper_bound(taken_m, altitude_m), altitude_m);
    }
}

} // namespace berg
