#include "core/plan/proof/ng_memory.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostCyclesAtOnce = 800;
/** A cycle is forbidden in the band where it was seen and in this many bands before and after. */
constexpr int kMemoryWindow = 10;

/** A path's return to an iceberg, which is at positions `first` and `last`, but not between. */
struct Cycle
{
    const VisitOrder* path = nullptr;
    int first = 0;
    int last = 0;
};

/** Returns all cycles of the paths, the shortest first. */
std::vector<Cycle> cyclesOf(std::span<const VisitOrder> paths, int icebergs)
{
    std::vector<Cycle> cycles;
    std::vector<int> seen;
    for (const VisitOrder& path : paths) {
        seen.assign(static_cast<std::size_t>(icebergs) + 1, 0);
        for (std::size_t k = 0; k < path.size(); ++k) {
            int& before = seen[toIndex(path[k])];
            const int position = static_cast<int>(k) + 1;
            if (before > 0)
                cycles.push_back({&path, before, position});
            before = position;
        }
    }
    std::stable_sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) {
        return a.last - a.first < b.last - b.first;
    });
    cycles.resize(std::min(cycles.size(), kMostCyclesAtOnce));
    return cycles;
}

} // namespace

NgSets nearestSets(const LegTable& costs, int count)
{
    const int n = costs.icebergs;
    NgSets sets(n);
    for (const NodeIndex i : icebergNodes(n)) {
        VisitOrder others = ascendingOrder(n);
        others.erase(others.begin() + (i.number() - 1));
        const auto distance = [&](NodeIndex j) { return costs.leg(i, j) + costs.leg(j, i); };
        std::sort(others.begin(), others.end(), [&](NodeIndex a, NodeIndex b) {
            return std::pair(distance(a), a) < std::pair(distance(b), b);
        });
        others.resize(std::min(others.size(), static_cast<std::size_t>(count)));
        for (int p = 1; p <= n; ++p)
            for (const NodeIndex j : others)
                sets.at(p, i).insert(j);
    }
    return sets;
}

template <class Costs>
void forbidCycles(NgSets& sets, const Costs& costs, std::span<const VisitOrder> paths, int cap)
{
    std::vector<int> bands; // bands of the path, by position from 1
    for (const Cycle& cycle : cyclesOf(paths, costs.icebergs)) {
        const auto node = [&](int position) {
            return (*cycle.path)[static_cast<std::size_t>(position) - 1];
        };
        bands.assign(1, 0);
        int level = 0;
        for (int p = 1; p < cycle.last; ++p) {
            level += costs.step(node(p));
            bands.push_back(bandOf(costs, level));
        }
        const auto band = [&](int position) { return bands[static_cast<std::size_t>(position)]; };
        const NodeIndex twice = node(cycle.first);
        bool hasSpace = true;
        for (int p = cycle.first + 1; p < cycle.last; ++p) {
            const NodeSet& memory = sets.at(band(p), node(p));
            hasSpace = hasSpace && (memory.contains(twice) || memory.size() < cap);
        }
        if (!hasSpace)
            continue;
        const int n = costs.icebergs;
        for (int p = cycle.first + 1; p < cycle.last; ++p)
            for (int q = std::max(1, band(p) - kMemoryWindow);
                 q <= std::min(n, band(p) + kMemoryWindow); ++q)
                if (sets.at(q, node(p)).size() < cap + 2)
                    sets.at(q, node(p)).insert(twice);
    }
}

template void forbidCycles(NgSets&, const VisitCosts&, std::span<const VisitOrder>, int);
template void forbidCycles(NgSets&, const LatencyCosts&, std::span<const VisitOrder>, int);

} // namespace berg
