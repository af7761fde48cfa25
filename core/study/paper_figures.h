#pragma once

#include "core/study/benchmark.h"
#include "core/study/study_summary.h"

namespace berg {

// The studies of the paper, ready to run.

/**
 * Figure 3 and Table 2: solution times by number of icebergs, 50 instances of Table 1 of each size
 * that Table 2 names, tau 0.5, solved by `solvers`. The budget is ours.
 */
[[nodiscard]] BenchmarkSpec figure3(std::vector<BenchmarkSolver> solvers);

/** Figure 4: zeta of one scenario for tau = 0, 0.1 .. 4, and the TSP path (`PolicyKind::Path`),
 * which the paper draws at tau = 4.5. */
[[nodiscard]] StudySpec figure4(const Scenario& scenario);

/** Figure 5: two flights of one scenario, the tau of lowest zeta (1.5 in the paper) and the TSP. */
struct Figure5
{
    StudySetting best;
    StudySetting tsp;
};

/**
 * Figure 5 of a scenario whose Figure 4 has been flown: the tau of lowest mean zeta over the
 * complete cases, the smaller one of a tie. None while no case is complete, or without tau.
 */
[[nodiscard]] std::optional<Figure5> figure5(const StudySummary& summary);

} // namespace berg
