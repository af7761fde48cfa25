#pragma once

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A column that labels share. */
struct LabelColumn
{
    double top = 0;
    double bottom = 0;
    double spacing = 14; ///< between the middles of neighbours
};

/**
 * Middles of the labels in a column: as near as possible to the wanted ones (least squares), in
 * the same order, at least `spacing` apart and inside the column. As many as fit: the caller
 * passes at most (bottom - top) / spacing. Cost: n log n.
 */
[[nodiscard]] std::vector<double> spreadLabels(std::span<const double> wanted,
                                               const LabelColumn& column);

/**
 * As `spreadLabels` for as many labels as find a place within `farthest` of the wanted one, taken
 * in the order given, i.e. by importance; none for the others. Cost: n times those placed.
 */
[[nodiscard]] std::vector<std::optional<double>>
nameableLabels(std::span<const double> wanted, const LabelColumn& column, double farthest);

} // namespace berg
