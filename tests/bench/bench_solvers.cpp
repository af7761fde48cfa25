// Times every back end on the paper's Table 1 instances (tests/support/brute_force.h):
//   bench_solvers [instances per size and tau, default 10] [backend ...]
// "first" is the time to the first order, "gap" the relative gap left, "proven" how many optima.

#include "core/base/error.h"
#include "core/plan/solver.h"
#include "tests/support/brute_force.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace berg;

namespace {

struct Row
{
    const char* name;
    Backend backend;
    std::vector<int> sizes;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double worst(const std::vector<double>& values)
{
    return *std::max_element(values.begin(), values.end());
}

struct Measured
{
    std::vector<double> first_ms;
    std::vector<double> total_ms;
    std::vector<double> gap_percent;
    int proven = 0;
};

void measure(const TvpSolver& solver, const TvpProblem& problem, Measured& measured)
{
    double first_s = -1;
    SolveOptions options;
    options.timeLimit_s = 120;
    options.onProgress = [&first_s](const SolveProgress& progress) {
        if (first_s < 0)
            first_s = progress.elapsed_s;
    };
    const SolveOutcome outcome = solver.solve(problem, options);
    measured.first_ms.push_back((first_s < 0 ? outcome.elapsed_s : first_s) * 1e3);
    measured.total_ms.push_back(outcome.elapsed_s * 1e3);
    measured.gap_percent.push_back(
        outcome.bound ? 100 * relativeGap(problem, outcome.objective, *outcome.bound) : 100);
    measured.proven += outcome.status == SolveStatus::Optimal ? 1 : 0;
}

void run(const Row& row, int instances)
{
    const std::unique_ptr<TvpSolver> solver = makeSolver(row.backend);
    for (const int n : row.sizes)
        for (const double tau : {0.5, 1.0, 3.0}) {
            Measured measured;
            for (int k = 0; k < instances; ++k) {
                const TvpProblem problem = test::randomProblem(1000 + static_cast<std::uint64_t>(k),
                                                               n, tau, Route::Open, false);
                measure(*solver, problem, measured);
            }
            std::printf("%-10s %4d %4.1f %9.3f %9.3f %10.3f %10.3f %8.3f %8.3f %4d/%d\n", row.name,
                        n, tau, median(measured.first_ms), worst(measured.first_ms),
                        median(measured.total_ms), worst(measured.total_ms),
                        median(measured.gap_percent), worst(measured.gap_percent), measured.proven,
                        instances);
            std::fflush(stdout);
        }
}

} // namespace

int main(int argc, char** argv)
{
    const int instances = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    const std::vector<Row> rows{
        {"exact", Backend::Exact, {6, 8, 10, 12, 14, 16, 18}},
        {"heuristic", Backend::Heuristic, {10, 12, 16, 20, 30, 40, 60, 100}},
        {"large", Backend::Heuristic, {200, 500}},
        {"cbc", Backend::Cbc, {6, 8, 10, 12}}};
    std::printf("%-10s %4s %4s %9s %9s %10s %10s %8s %8s %s\n", "backend", "n", "tau", "first ms",
                "worst", "total ms", "worst", "gap %", "worst", "proven");
    for (const Row& row : rows) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.name) == wanted.end())
            continue;
        try {
            run(row, instances);
        } catch (const Error& error) {
            std::printf("%-10s %s\n", row.name, error.what());
        }
    }
    return 0;
}
