#include "core/base/label_column.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berg {

namespace {

/** Labels that touch and move as one block. */
struct Block
{
    double offsetSum = 0; ///< sum of the wanted centres, each less its offset within the block
    std::size_t first = 0;
    std::size_t count = 0;
    [[nodiscard]] double start(const LabelColumn& column) const
    {
        const double n = static_cast<double>(count);
        const double lowest = column.top + column.spacing / 2;
        const double highest = column.bottom - column.spacing * (n - 0.5);
        return std::clamp(offsetSum / n, lowest, std::max(lowest, highest));
    }
};

} // namespace

std::vector<double> spreadLabels(std::span<const double> wanted, const LabelColumn& column)
{
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    // Pool adjacent violators: a block that would touch the previous one joins it.
    std::vector<Block> blocks;
    for (std::size_t k = 0; k < order.size(); ++k) {
        blocks.push_back({.offsetSum = wanted[order[k]], .first = k, .count = 1});
        while (blocks.size() > 1) {
            const Block last = blocks.back();
            Block& before = blocks[blocks.size() - 2];
            const double n = static_cast<double>(before.count);
            if (before.start(column) + column.spacing * n <= last.start(column))
                break;
            before.offsetSum +=
                last.offsetSum - column.spacing * n * static_cast<double>(last.count);
            before.count += last.count;
            blocks.pop_back();
        }
    }
    std::vector<double> middles(wanted.size());
    for (const Block& block : blocks)
        for (std::size_t k = 0; k < block.count; ++k)
            middles[order[block.first + k]] =
                block.start(column) + column.spacing * static_cast<double>(k);
    return middles;
}

std::vector<std::optional<double>> nameableLabels(std::span<const double> wanted,
                                                  const LabelColumn& column, double farthest)
{
    const auto room = static_cast<std::size_t>((column.bottom - column.top) / column.spacing);
    std::vector<std::size_t> taken;
    std::vector<double> takenWanted;
    std::vector<double> middles;
    for (std::size_t i = 0; i < wanted.size() && taken.size() < room; ++i) {
        takenWanted.push_back(wanted[i]);
        std::vector<double> spread = spreadLabels(takenWanted, column);
        const bool near = std::equal(
            spread.begin(), spread.end(), takenWanted.begin(),
            [farthest](double at, double want) { return std::abs(at - want) <= farthest; });
        if (!near) {
            takenWanted.pop_back();
            continue;
        }
        middles = std::move(spread);
        taken.push_back(i);
    }
    std::vector<std::optional<double>> result(wanted.size());
    for (std::size_t k = 0; k < taken.size(); ++k)
        result[taken[k]] = middles[k];
    return result;
}

} // namespace berg
