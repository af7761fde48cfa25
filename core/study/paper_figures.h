#pragma once

#include "core/study/benchmark.h"
#include "core/study/study_summary.h"

namespace berg {

// These are the studies of the paper, ready to run.

/**
 * Returns the benchmark of Figure 3 and Table 2: solution times by number of icebergs, 50 instances
 * of Table 1 for each size in Table 2, tau 0.5, solved by `solvers`. The time budget is the default
 * of `BenchmarkSpec`; the paper has none.
 */
[[nodiscard]] BenchmarkSpec figure3(std::vector<BenchmarkSolver> solvers);

/**
 * Returns the study of Figure 4: zeta of one scenario for tau = 0, 0.1 .. 4 and for the TSP path
 * (`PolicyKind::Path`), which the paper draws at tau = 4.5.
 */
[[nodiscard]] StudySpec figure4(const Scenario& scenario);

/**
 * The two flights of Figure 5 for one scenario: the tau of lowest zeta (1.5 in the paper) and the
 * TSP.
 */
struct Figure5
{
    StudySetting best;
    StudySetting tsp;
};

/**
 * Returns Figure 5 for a scenario whose Figure 4 has been flown: the tau with the lowest mean zeta
 * over the complete cases, the smaller one of a tie. Returns nullopt if no case is complete or
 * there is no tau.
 */
[[nodiscard]] std::optional<Figure5> figure5(const StudySummary& summary);

} // namespace berg
