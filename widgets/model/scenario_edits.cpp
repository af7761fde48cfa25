#include "widgets/model/scenario_edits.h"

#include <algorithm>

namespace berg {
namespace {

template <class Objects>
auto findById(Objects& objects, const std::string& id) -> decltype(objects.data())
{
    const auto it = std::find_if(objects.begin(), objects.end(),
                                 [&](const auto& object) { return object.id == id; });
    return it == objects.end() ? nullptr : &*it;
}

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

/** Positions of the objects with these ids. */
std::vector<Point*> positionsOf(Scenario& scenario, std::span<const std::string> ids)
{
    std::vector<Point*> positions;
    for (const std::string& id : ids) {
        if (Iceberg* iceberg = findById(scenario.icebergs, id))
            positions.push_back(&iceberg->position_m);
        else if (Uav* uav = findById(scenario.uavs, id))
            positions.push_back(&uav->position_m);
    }
    return positions;
}

} // namespace

Point clampedPosition(const Point& position_m)
{
    return position_m.cwiseMax(-kLargestCoordinate_m).cwiseMin(kLargestCoordinate_m);
}

std::string freshIcebergId(const Scenario& scenario)
{
    return freshId(scenario, "berg-", scenario.icebergs.size() + 1);
}

std::string freshUavId(const Scenario& scenario)
{
    return freshId(scenario, "uav-", 1);
}

const Iceberg* findIceberg(const Scenario& scenario, const std::string& id)
{
    return findById(scenario.icebergs, id);
}

Iceberg* findIceberg(Scenario& scenario, const std::string& id)
{
    return findById(scenario.icebergs, id);
}

const Uav* findUav(const Scenario& scenario, const std::string& id)
{
    return findById(scenario.uavs, id);
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
        *position_m = clampedPosition(*position_m + allowed_m); // rounding may go one bit beyond
}

void removeIcebergs(Scenario& scenario, std::span<const std::string> ids)
{
    std::erase_if(scenario.icebergs, [&](const Iceberg& iceberg) {
        return std::find(ids.begin(), ids.end(), iceberg.id) != ids.end();
    });
}

} // namespace berg
