// Times `solveFleet` on random fields of icebergs (tests/support/plan/fleet_problems.h), tau 0.5, 1
// and 3 in turn:
//   bench_fleet [instances per size, default 6] [row ...]
// Rows: 2x12, 2x20, 3x30, 5x50, for which the back end `exact` gets 1.5, 3 and 10 s of the clock.
// Times are CPU: until the first plan, until the plan is within 1 % of the best one found, until
// the gap is within 2 % and within 0.3 %, until the end; each median and worst. "gap" is the worst
// gap left. Every row runs in a process of its own to measure its peak memory.

#include "core/plan/fleet/fleet_solver.h"
#include "tests/support/plan/fleet_problems.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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
    int uavs;
    int icebergs;
    double limit_s;
};

constexpr std::array kRows{Row{"2x12", 2, 12, 1.5}, Row{"2x20", 2, 20, 1.5}, Row{"3x30", 3, 30, 3},
                           Row{"5x50", 5, 50, 10}};

double cpu_s()
{
    std::timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/** Times of some of the instances. */
struct Times
{
    std::vector<double> times_s;

    void print(int instances)
    {
        std::sort(times_s.begin(), times_s.end());
        if (times_s.empty())
            std::printf(" %8s %8s %3d/%d", "-", "-", 0, instances);
        else
            std::printf(" %8.3f %8.3f %3zu/%d", times_s[times_s.size() / 2], times_s.back(),
                        times_s.size(), instances);
    }
};

struct Report
{
    double time_s;
    double objective;
    double gap;
};

/** Time of the first report that is good enough, if any. */
template <class Good>
void note(Times& times, const std::vector<Report>& reports, const Good& good)
{
    const auto first = std::find_if(reports.begin(), reports.end(), good);
    if (first != reports.end())
        times.times_s.push_back(first->time_s);
}

void run(const Row& row, int instances)
{
    constexpr std::array kTaus{0.5, 1.0, 3.0};
    Times first;
    Times good;
    Times two;
    Times third;
    Times proven;
    double worstGap = 0;
    for (int k = 0; k < instances; ++k) {
        const FleetProblem problem =
            test::randomFleet(1000 + static_cast<std::uint64_t>(k), row.uavs, row.icebergs,
                              kTaus[static_cast<std::size_t>(k) % kTaus.size()]);
        std::vector<Report> reports;
        const double start_s = cpu_s();
        const auto add = [&](double objective, const std::optional<double>& bound) {
            const double gap = bound ? relativeGap(problem, objective, *bound) : 1.0;
            reports.push_back({cpu_s() - start_s, objective, gap});
        };
        SolveOptions options;
        options.timeLimit_s = row.limit_s;
        options.onProgress = [&](const SolveProgress& progress) {
            add(progress.objective, progress.bound);
        };
        const SolveOutcome outcome = solveFleet(problem, Backend::Exact, options);
        add(outcome.objective, outcome.bound);
        worstGap = std::max(worstGap, reports.back().gap);
        note(first, reports, [](const Report&) { return true; });
        note(good, reports, [&](const Report& report) {
            return relativeGap(problem, report.objective, outcome.objective) <= 0.01;
        });
        note(two, reports, [](const Report& report) { return report.gap <= 0.02; });
        note(third, reports, [](const Report& report) { return report.gap <= 0.003; });
        if (outcome.status == SolveStatus::Optimal)
            proven.times_s.push_back(reports.back().time_s);
    }
    std::printf("%-6s", row.name);
    for (Times* times : {&first, &good, &two, &third, &proven})
        times->print(instances);
    std::printf(" %7.3f", 100 * worstGap);
    std::fflush(stdout);
}

/** Runs a row in a process of its own and returns its peak memory. */
void runApart(const Row& row, int instances)
{
    const pid_t child = fork();
    if (child == 0) {
        run(row, instances);
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
    const int instances = argc > 1 ? std::max(1, std::atoi(argv[1])) : 6;
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    std::printf("%-6s %23s %23s %23s %23s %23s %7s %9s\n", "size", "first plan s", "1 % s",
                "gap 2 % s", "gap 0.3 % s", "proven s", "gap %", "memory");
    std::fflush(stdout);
    for (const Row& row : kRows)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), row.name) != wanted.end())
            runApart(row, instances);
    return 0;
}
