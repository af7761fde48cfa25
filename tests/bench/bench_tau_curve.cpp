// CPU time of whole trade-off curves, tau 0 .. 5, on the paper's Table 1 instances:
//   bench_tau_curve [instances per size, default 10] [size ...]

#include "core/plan/policy/tau_curve.h"
#include "tests/support/plan/brute_force.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace berg;

namespace {

double cpu_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void measure(int icebergs, int instances)
{
    std::vector<double> cpu_ms;
    std::vector<std::size_t> plans;
    int proven = 0;
    for (int k = 0; k < instances; ++k) {
        const TvpProblem problem =
            test::randomProblem(1000 + static_cast<std::uint64_t>(k), icebergs, 0, Route::Open);
        const double start_s = cpu_s();
        const TauCurve curve = tauCurve(problemOf(problem), {}, {});
        cpu_ms.push_back(1e3 * (cpu_s() - start_s));
        plans.push_back(curve.intervals.size());
        proven += std::all_of(curve.intervals.begin(), curve.intervals.end(),
                              [](const CurveInterval& i) { return i.proven; })
                      ? 1
                      : 0;
    }
    std::sort(cpu_ms.begin(), cpu_ms.end());
    std::sort(plans.begin(), plans.end());
    std::printf("%8d %10.2f %10.2f %6zu..%-6zu %6d/%d\n", icebergs, cpu_ms[cpu_ms.size() / 2],
                cpu_ms.back(), plans.front(), plans.back(), proven, instances);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const int instances = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
    std::vector<int> sizes;
    for (int k = 2; k < argc; ++k)
        sizes.push_back(std::atoi(argv[k]));
    if (sizes.empty())
        sizes = {12, 20, 30, 40};
    std::printf("%8s %10s %10s %14s %s\n", "icebergs", "median ms", "worst ms", "plans", "proven");
    for (const int icebergs : sizes)
        measure(icebergs, instances);
    return 0;
}
