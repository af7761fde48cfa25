#pragma once

#include <Eigen/Core>

#include <vector>

namespace berg {

/**
 * The cheapest assignment of every row to a column of its own: the column of each row. `cost` is
 * finite and has no more rows than columns. Shortest augmenting paths (Jonker and Volgenant 1987),
 * O(rows^2 columns).
 */
[[nodiscard]] std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost);

} // namespace berg
