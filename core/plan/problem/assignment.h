#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace berg {

/**
 * Returns the cheapest assignment of columns to rows, each row used at most once: the row of each
 * column, from 0. `cost` has a column for each agent and a row for each place; throws
 * `std::logic_error` if it is not finite or has more columns than rows. Shortest augmenting paths
 * (Jonker and Volgenant 1987), O(columns^2 rows). `isStopped` is called often; the result is empty
 * once it returns true.
 */
[[nodiscard]] std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost,
                                                  const std::function<bool()>& isStopped = {});

} // namespace berg
