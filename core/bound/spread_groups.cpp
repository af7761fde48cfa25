#include "core/bound/spread_groups.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace berg {

namespace {

/**
 * Sorts indices so that neighbours in the field become neighbours in the row: the points are halved
 * along the longer side of their box, then each half again.
 */
void sortByPlace(std::span<int> row, std::span<const Point> points_m)
{
    if (row.size() < 2)
        return;
    const auto at = [&](int i) -> const Point& { return points_m[static_cast<std::size_t>(i)]; };
    Eigen::AlignedBox2d box;
    for (const int i : row)
        box.extend(at(i));
    const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
    std::sort(row.begin(), row.end(), [&](int a, int b) {
        return at(a)[axis] != at(b)[axis] ? at(a)[axis] < at(b)[axis] : a < b;
    });
    sortByPlace(row.first(row.size() / 2), points_m);
    sortByPlace(row.subspan(row.size() / 2), points_m);
}

} // namespace

std::vector<std::vector<int>> spreadGroups(std::span<const Point> points_m, int most)
{
    std::vector<int> row(points_m.size());
    std::iota(row.begin(), row.end(), 0);
    sortByPlace(row, points_m);
    const std::size_t full = static_cast<std::size_t>(most);
    std::vector<std::vector<int>> groups((row.size() + full - 1) / full);
    std::vector<std::size_t> sizes(groups.size(), full);
    if (!sizes.empty())
        sizes.back() = row.size() - full * (groups.size() - 1);
    for (const int i : row) {
        // The point goes to the group that is filled least for its size.
        std::size_t chosen = 0;
        for (std::size_t g = 1; g < groups.size(); ++g)
            if (groups[g].size() * sizes[chosen] < groups[chosen].size() * sizes[g])
                chosen = g;
        groups[chosen].push_back(i);
    }
    for (std::vector<int>& group : groups)
        std::sort(group.begin(), group.end());
    return groups;
}

} // namespace berg
