// Times the back ends on the paper's Table 1 instances (tests/support/plan/brute_force.h), tau 0.5,
// 1 and 3 in turn:
//   bench_solvers [instances per size, default 20] [row ...]
// Rows: exact (takes some minutes), subsets, heuristic, large, cbc
// (position-indexed MILP), latency (the policy's problem with real sigmas, exact),
// latency-subsets; a size alone: exact:40.
// Every size runs in a process of its own to measure its peak memory. Times are CPU:
// "1 %" until the order is within 1 % of the best one found, "0.2 %" until the bound is within
// 0.2 % of the order, "total" until the end; each median and worst. "gap" is the worst one left.

#include "core/base/error.h"
#include "core/plan/solve/solver.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/plan/hard_problems.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

using namespace berg;

namespace {

struct Row
{
    const char* name;
    std::function<std::unique_ptr<TvpSolver>()> make;
    std::vector<int> sizes;
    Criterion criterion = Criterion::Visitation;
};

std::unique_ptr<TvpSolver> subsets()
{
    return std::make_unique<SubsetSolver>();
}

/** The paper's instances with tau in turn; for latency, which ignores tau, with real sigmas. */
TvpProblem instance(int number, int n, Criterion criterion)
{
    constexpr std::array kTaus{0.5, 1.0, 3.0};
    const auto seed = 1000 + static_cast<std::uint64_t>(number);
    const double tau = kTaus[static_cast<std::size_t>(number) % kTaus.size()];
    TvpProblem problem = test::randomProblem(seed, n, tau, Route::Open);
    if (criterion == Criterion::Latency) {
        problem = test::madeOdd(std::move(problem), test::Oddity::RealSigmas, seed);
        problem.criterion = criterion;
        problem.mu = 1 / 22.0;
    }
    return problem;
}

double cpu_s()
{
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/** One time per instance. */
class Times
{
public:
    void add(double time_s) { m_times_s.push_back(time_s); }
    void print()
    {
        if (m_times_s.empty()) {
            std::printf(" %10s %10s", "-", "-");
            return;
        }
        std::sort(m_times_s.begin(), m_times_s.end());
        std::printf(" %10.3f %10.3f", 1e3 * m_times_s[m_times_s.size() / 2],
                    1e3 * m_times_s.back());
    }

private:
    std::vector<double> m_times_s;
};

struct Measured
{
    Times good;      ///< order within 1 %
    Times certified; ///< gap within 0.2 %
    Times total;
    double worstGap = 0;
    int proven = 0;
    int certifiedCount = 0;
};

void measure(const TvpSolver& solver, const TvpProblem& problem, Measured& measured)
{
    struct Report
    {
        double time_s;
        double objective;
        double gap;
    };
    std::vector<Report> reports;
    const double start_s = cpu_s();
    SolveOptions options;
    options.timeLimit_s = 90; // elapsed
    options.onProgress = [&](const SolveProgress& progress) {
        const double gap =
            progress.bound ? relativeGap(problem, progress.objective, *progress.bound) : 1.0;
        reports.push_back({cpu_s() - start_s, progress.objective, gap});
    };
    const SolveOutcome outcome = solver.solve(problem, options);
    const double total_s = cpu_s() - start_s;
    const double gap =
        outcome.bound ? relativeGap(problem, outcome.objective, *outcome.bound) : 1.0;
    reports.push_back({total_s, outcome.objective, gap});

    const auto good = std::find_if(reports.begin(), reports.end(), [&](const Report& report) {
        return relativeGap(problem, report.objective, outcome.objective) <= 0.01;
    });
    measured.good.add(good->time_s);
    const auto certified = std::find_if(reports.begin(), reports.end(), [](const Report& report) {
        return report.gap <= 0.002 + 1e-9;
    });
    if (certified != reports.end()) {
        measured.certified.add(certified->time_s);
        ++measured.certifiedCount;
    }
    measured.total.add(total_s);
    measured.worstGap = std::max(measured.worstGap, gap);
    measured.proven += outcome.status == SolveStatus::Optimal ? 1 : 0;
}

void runSize(const Row& row, int n, int instances)
{
    const std::unique_ptr<TvpSolver> solver = row.make();
    Measured measured;
    for (int k = 0; k < instances; ++k)
        measure(*solver, instance(k, n, row.criterion), measured);
    std::printf("%-15s %4d", row.name, n);
    measured.good.print();
    measured.certified.print();
    measured.total.print();
    std::printf(" %7.3f %3d/%d %3d/%d", 100 * measured.worstGap, measured.certifiedCount, instances,
                measured.proven, instances);
    std::fflush(stdout);
}

/** Runs a size in a process of its own and returns its peak memory. */
void runApart(const Row& row, int n, int instances)
{
    const pid_t child = fork();
    if (child == 0) {
        try {
            runSize(row, n, instances);
        } catch (const Error& error) {
            std::printf("%-15s %s", row.name, error.what());
            std::fflush(stdout);
        }
        _exit(0);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    std::printf(" %6ld MB\n", usage.ru_maxrss / 1024);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const int instances = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20;
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    const auto backend = [](Backend value) { return [value] { return makeSolver(value); }; };
    const std::vector<Row> rows{
        {"exact", backend(Backend::Exact), {6, 8, 10, 12, 14, 15, 16, 20, 30, 40, 60, 80, 100}},
        {"subsets", subsets, {12, 13, 14, 15, 16, 18, 20}},
        {"heuristic", backend(Backend::Heuristic), {12, 13, 14, 15, 16, 20, 30, 40, 60, 100}},
        {"large", backend(Backend::Heuristic), {127, 200, 500}},
        {"cbc", [] { return makeSolver(Backend::Cbc, Formulation::Position); }, {8, 12, 16}},
        {"latency", backend(Backend::Exact), {12, 16, 20, 30, 40, 50, 60}, Criterion::Latency},
        {"latency-subsets", subsets, {12, 14, 15, 16, 17, 18}, Criterion::Latency}};
    std::printf("%-15s %4s %10s %10s %10s %10s %10s %10s %7s %6s %6s %9s\n", "back end", "n",
                "1 % ms", "worst", "0.2 % ms", "worst", "total ms", "worst", "gap %", "0.2 %",
                "proven", "memory");
    std::fflush(stdout);
    const auto asked = [&](const std::string& name) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    };
    for (const Row& row : rows)
        for (const int n : row.sizes)
            if (asked(row.name) || asked(row.name + (":" + std::to_string(n))))
                runApart(row, n, instances);
    return 0;
}
