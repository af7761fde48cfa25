#pragma once

#include "core/plan/solver.h"
#include "core/study/statistics.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/**
 * An instance of Table 1 of the paper: icebergs uniform in 5000 m x 5000 m, sigma an integer of
 * 1 .. 10, UAV at (-500, -500) m, mu by Eq. (14).
 */
[[nodiscard]] TvpProblem tableOneProblem(std::uint64_t seed, int icebergs, double tau = 0.5);

/** Solution times of the paper's Table 2 (CPLEX), seconds. */
struct PaperTime
{
    int icebergs;
    double average_s;
    double worst_s;
};
[[nodiscard]] std::span<const PaperTime> paperTable2();

struct BenchmarkSpec
{
    std::vector<int> sizes;
    std::vector<Backend> backends;
    Formulation formulation = Formulation::Position; ///< of the CBC back end
    int repeat = 10;                                 ///< instances of each size: seeds 1 .. repeat
    double budget_s = 60; ///< of the whole benchmark; shared equally by what is left to do
    double tau = 0.5;
};

/** One size and back end. Times are of the instances that ended by themselves. */
struct BenchmarkRow
{
    int icebergs = 0;
    Backend backend = Backend::Auto;
    int instances = 0; ///< tried before the share of the budget was used up
    int proven = 0;
    int cut = 0; ///< stopped by the budget
    Summary seconds;
    double worst_s = 0;
    std::optional<double> worstGap; ///< of all tried, none when a bound is missing
    std::string note;               ///< why the back end cannot, when it cannot
};

/** Runs row by row, `onRow` after each; ends early when stopped. */
[[nodiscard]] std::vector<BenchmarkRow>
runBenchmark(const BenchmarkSpec& spec, const std::stop_token& stop,
             const std::function<void(std::size_t done, std::size_t count)>& onRow = {});

} // namespace berg
