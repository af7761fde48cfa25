#pragma once

#include "core/plan/solve/names.h"
#include "core/study/statistics.h"

#include <array>
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

/** A contestant: a back end, and for CBC the MILP it is given. */
struct BenchmarkSolver
{
    Backend backend = Backend::Auto;
    Formulation formulation = Formulation::Position; ///< counts for `Backend::Cbc` only
    bool operator==(const BenchmarkSolver&) const = default;
};

inline constexpr std::array<Named<BenchmarkSolver>, 6> kBenchmarkSolverNames{{
    {{.backend = Backend::Auto}, "auto"},
    {{.backend = Backend::Exact}, "exact"},
    {{.backend = Backend::Heuristic}, "heuristic"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Reduced}, "cbc-reduced"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Position}, "cbc-position"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Printed}, "cbc-printed"},
}};

/** Those of this build, without `auto`, which is one of the others. */
[[nodiscard]] std::vector<BenchmarkSolver> benchmarkSolvers();

struct BenchmarkSpec
{
    std::vector<int> sizes; ///< run in ascending order, each once
    std::vector<BenchmarkSolver> solvers;
    int repeat = 10;      ///< instances of each size: seeds 1 .. repeat
    double budget_s = 60; ///< of the whole benchmark
    double tau = 0.5;
};

/**
 * One size and contestant. Times, `meanObjective` and `work` are of the instances that ended by
 * themselves: with all of them done, everything but the seconds is the same at every run.
 */
struct BenchmarkRow
{
    int icebergs = 0;
    BenchmarkSolver solver;
    int instances = 0; ///< tried before the share of the budget was used up
    int proven = 0;
    int cut = 0; ///< stopped by the budget
    Summary seconds;
    double worst_s = 0;
    double meanObjective = 0;       ///< F of Eq. (1)
    std::int64_t work = 0;          ///< sum, in the back end's own unit
    std::optional<double> worstGap; ///< of all tried, none when a bound is missing
    std::string note;               ///< why there is nothing, when there is nothing
};

/** After each instance; `done` of `count` instances, those not tried included. */
struct BenchmarkProgress
{
    std::span<const BenchmarkRow> rows; ///< finished ones
    std::size_t done = 0;
    std::size_t count = 0;
};

/**
 * Small sizes first, for each of them one contestant after the other. A row may take an equal share
 * of the budget that is left with the rows of its size and of the next one. Who does not finish a
 * size is not given a larger one, so that the others get more. When
 * stopped, the rows so far are returned, the last one with the instances that were done. Throws
 * `Error{Unsupported}` for a back end that this build lacks.
 */
[[nodiscard]] std::vector<BenchmarkRow>
runBenchmark(const BenchmarkSpec& spec, const std::stop_token& stop,
             const std::function<void(const BenchmarkProgress&)>& onProgress = {});

} // namespace berg
