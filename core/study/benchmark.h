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
 * Returns an instance of Table 1 of the paper: icebergs uniform in 5000 m x 5000 m, sigma an
 * integer from 1 to 10, UAV at (-500, -500) m, mu by Eq. (14). The seed determines the instance.
 */
[[nodiscard]] TvpProblem tableOneProblem(std::uint64_t seed, int icebergs, double tau = 0.5);

/** Solution times in the paper's Table 2 (CPLEX), seconds. */
struct PaperTime
{
    int icebergs;
    double average_s;
    double worst_s;
};
/** Returns the rows of Table 2, by ascending number of icebergs. */
[[nodiscard]] std::span<const PaperTime> paperTable2();

/** A back end under test and, for CBC, its MILP. */
struct BenchmarkSolver
{
    Backend backend = Backend::Auto;
    Formulation formulation = Formulation::Position; ///< used by `Backend::Cbc` only
    bool operator==(const BenchmarkSolver&) const = default;
};

/** Names of the solvers on the command line and in files. */
inline constexpr std::array<Named<BenchmarkSolver>, 6> kBenchmarkSolverNames{{
    {{.backend = Backend::Auto}, "auto"},
    {{.backend = Backend::Exact}, "exact"},
    {{.backend = Backend::Heuristic}, "heuristic"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Reduced}, "cbc-reduced"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Position}, "cbc-position"},
    {{.backend = Backend::Cbc, .formulation = Formulation::Printed}, "cbc-printed"},
}};

/** Returns the solvers of this build, without `auto`, which selects one of the others. */
[[nodiscard]] std::vector<BenchmarkSolver> benchmarkSolvers();

/** A benchmark: sizes, solvers and time budget. */
struct BenchmarkSpec
{
    std::vector<int> sizes; ///< numbers of icebergs; run in ascending order, each once
    std::vector<BenchmarkSolver> solvers;
    int repeat = 10;      ///< number of instances of each size, with seeds 1 to `repeat`
    double budget_s = 60; ///< time for the whole benchmark
    double tau = 0.5;
};

/**
 * Results for one size and solver. `seconds`, `worst_s`, `meanObjective` and `work` cover the
 * instances that ended by themselves. If all of them did, everything but the seconds repeats at
 * every run.
 */
struct BenchmarkRow
{
    int icebergs = 0;
    BenchmarkSolver solver;
    int instances = 0; ///< instances tried before the share of the budget was used up
    /** Instances with proven optimum. */
    int proven = 0;
    int cut = 0; ///< instances stopped by the budget
    Summary seconds;
    double worst_s = 0;
    double meanObjective = 0;       ///< mean F of Eq. (1)
    std::int64_t work = 0;          ///< sum in the back end's own unit
    std::optional<double> worstGap; ///< over all instances tried; nullopt if one has no bound
    std::string note;               ///< reason for missing results
};

/** Progress after an instance: `done` of `count` instances, those left out included. */
struct BenchmarkProgress
{
    std::span<const BenchmarkRow> rows; ///< finished rows
    std::size_t done = 0;
    std::size_t count = 0;
};

/**
 * Runs the benchmark, small sizes first and one solver after another for each size. A row may use
 * an equal share of the remaining budget among the rows of its size and the next. A solver that
 * does not finish a size is not tried on a larger one, which leaves the others more time; such rows
 * have a note and no instances. If stopped, returns the rows so far, the last with the instances
 * done. Throws `Error{Unsupported}` for a back end missing in this build before anything is solved.
 */
[[nodiscard]] std::vector<BenchmarkRow>
runBenchmark(const BenchmarkSpec& spec, const std::stop_token& stop,
             const std::function<void(const BenchmarkProgress&)>& onProgress = {});

} // namespace berg
