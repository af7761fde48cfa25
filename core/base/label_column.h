#pragma once

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Column shared by labels, in any unit. */
struct LabelColumn
{
    double top = 0;
    double bottom = 0;
    double spacing = 14; ///< distance between the centres of neighbours
};

/**
 * Returns the centres of labels in a column: as near as possible to `wanted` (least squares), in
 * the same order, at least `spacing` apart and inside the column. There must be at most (bottom -
 * top) / spacing labels. Cost: n log n.
 */
[[nodiscard]] std::vector<double> spreadLabels(std::span<const double> wanted,
                                               const LabelColumn& column);

/**
 * Places as many labels as `spreadLabels` can within `farthest` of their wanted centre. Labels are
 * tried in the given order, so the most important come first. Returns the centre of each, or
 * nullopt for labels without a place. Cost: n times the number placed.
 */
[[nodiscard]] std::vector<std::optional<double>>
nameableLabels(std::span<const double> wanted, const LabelColumn& column, double farthest);

} // namespace berg
