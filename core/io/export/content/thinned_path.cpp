#include "core/io/export/content/thinned_path.h"

#include <utility>

namespace berg {

std::vector<TimedPoint> thinnedPath(std::span<const TimedPoint> path, double tolerance_m,
                                    std::size_t most)
{
    if (path.size() < 3)
        return {path.begin(), path.end()};
    std::vector<bool> kept(path.size(), false);
    kept.front() = kept.back() = true;
    std::size_t count = 2;
    std::vector<std::pair<std::size_t, std::size_t>> stretches{{0, path.size() - 1}};
    while (!stretches.empty() && count <= most) {
        const auto [first, last] = stretches.back();
        stretches.pop_back();
        std::size_t farthest = first;
        double distance_m = tolerance_m;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double here_m = distanceToSegment(path[first].position_m, path[last].position_m,
                                                    path[i].position_m);
            if (here_m > distance_m) {
                farthest = i;
                distance_m = here_m;
            }
        }
        if (farthest == first)
            continue;
        kept[farthest] = true;
        ++count;
        stretches.emplace_back(first, farthest);
        stretches.emplace_back(farthest, last);
    }
    std::vector<TimedPoint> thinned;
    for (std::size_t i = 0; i < path.size(); ++i)
        if (kept[i])
            thinned.push_back(path[i]);
    return thinned;
}

} // namespace berg
