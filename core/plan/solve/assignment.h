#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace berg {

/**
 * The cheapest assignment of everyone to a place of his own: the place of each. `cost` has a column
 * for each of them and a row for each place, is finite and has no more columns than rows. Shortest
 * augmenting paths (Jonker and Volgenant 1987), O(columns^2 rows). `cut` is asked all the time;
 * empty when it says yes.
 */
[[nodiscard]] std::vector<int> cheapestAssignment(const Eigen::MatrixXd& cost,
                                                  const std::function<bool()>& cut = {});

} // namespace berg
