// Delay until solves return after a stop, in CPU time of the solving thread since the request:
//   bench_stop [instants per shape, default 12] [shape ...]
// The instants are random, from 1 ms to some seconds of CPU time, the same at each run. Shapes:
// see kShapes; without any, all. A solve that was over before the stop does not count. What large
// problems leave behind is freed on another thread and not counted.

#include "core/plan/fleet/fleet_solver.h"
#include "core/plan/policy/tau_curve.h"
#include "core/plan/solve/subset_solver.h"
#include "tests/support/plan/fleet_problems.h"
#include "tests/support/plan/hard_problems.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <pthread.h>
#include <string>
#include <thread>
#include <vector>

using namespace berg;

namespace {

using Solve = std::function<void(std::stop_token)>;

double seconds(clockid_t clock)
{
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/** CPU time from the stop, after `instant_s` of CPU time, until the solve returned; nullopt if it
 * had ended before. */
std::optional<double> measure(const Solve& solve, double instant_s)
{
    std::stop_source stop;
    double asked_s = 0;
    clockid_t clock{};
    pthread_getcpuclockid(pthread_self(), &clock);
    const double start_s = seconds(clock);
    std::atomic<bool> over{false};
    std::jthread watcher([&] {
        while (!over && seconds(clock) - start_s < instant_s)
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        asked_s = seconds(clock);
        stop.request_stop();
    });
    solve(stop.get_token());
    const double end_s = seconds(clock);
    const bool wasOver = !stop.stop_requested();
    over = true;
    watcher.join();
    return wasOver ? std::nullopt : std::optional(end_s - asked_s);
}

Solve lone(int icebergs, double tau, Criterion criterion, Backend backend = Backend::Exact)
{
    TvpProblem problem = test::randomProblem(1003, icebergs, tau, Route::Open);
    if (criterion == Criterion::Latency) {
        problem = test::madeOdd(std::move(problem), test::Oddity::RealSigmas, 1003);
        problem.criterion = criterion;
        problem.mu = 1 / 22.0;
    }
    return [problem, backend](const std::stop_token& stop) {
        (void)makeSolver(backend)->solve(problem, {.stop = stop});
    };
}

Solve subsets(int icebergs)
{
    return
        [problem = test::randomProblem(1003, icebergs, 1, Route::Open)](
            const std::stop_token& stop) { (void)SubsetSolver().solve(problem, {.stop = stop}); };
}

Solve curve(int icebergs)
{
    return [problem =
                test::randomProblem(1003, icebergs, 1, Route::Open)](const std::stop_token& stop) {
        (void)tauCurve(problemOf(problem), {}, {.stop = stop});
    };
}

Solve fleet(int uavs, int icebergs, double tau, test::FleetKind kind,
            Backend backend = Backend::Exact)
{
    return [problem = test::randomFleet(1003, uavs, icebergs, tau, kind), backend](
               const std::stop_token& stop) { (void)solveFleet(problem, backend, {.stop = stop}); };
}

struct Shape
{
    const char* name;
    double longest_s; ///< instants are up to this
    std::function<Solve()> make;
};

const std::array kShapes{
    Shape{"exact-60", 3, [] { return lone(60, 3, Criterion::Visitation); }},
    Shape{"exact-100", 8, [] { return lone(100, 1, Criterion::Visitation); }},
    Shape{"exact-127", 8, [] { return lone(127, 3, Criterion::Visitation); }},
    Shape{"latency-60", 3, [] { return lone(60, 1, Criterion::Latency); }},
    Shape{"latency-120", 8, [] { return lone(120, 1, Criterion::Latency); }},
    Shape{"subsets-20", 0.3, [] { return subsets(20); }},
    Shape{"curve-40", 2, [] { return curve(40); }},
    Shape{"fleet-2x14", 0.1, [] { return fleet(2, 14, 1, test::FleetKind::Plain); }},
    Shape{"fleet-100x14", 1, [] { return fleet(100, 14, 1, test::FleetKind::Latency); }},
    Shape{"fleet-5x50", 4, [] { return fleet(5, 50, 1, test::FleetKind::Plain); }},
    Shape{"fleet-2x60", 6, [] { return fleet(2, 60, 3, test::FleetKind::Plain); }},
    Shape{"fleet-10x127", 6, [] { return fleet(10, 127, 1, test::FleetKind::Plain); }},
    Shape{"fleet-100x127-closed", 4, [] { return fleet(100, 127, 1, test::FleetKind::Closed); }},
    Shape{"fleet-100x127-unlike", 4, [] { return fleet(100, 127, 1, test::FleetKind::Unlike); }},
    Shape{"fleet-100x127-latency", 4,
          [] { return fleet(100, 127, 1, test::FleetKind::Latency, Backend::Auto); }},
    Shape{"ranks-40x127", 0.5, [] { return fleet(40, 127, 0, test::FleetKind::Assigned); }},
    Shape{"ranks-100x127", 1, [] { return fleet(100, 127, 0, test::FleetKind::Assigned); }},
};

void run(const Shape& shape, int instants)
{
    const Solve solve = shape.make();
    Random random(7, 1);
    std::vector<double> times_ms;
    for (int k = 0; k < instants; ++k) {
        // The logarithm is uniform, so that early phases, which are short, are hit as well.
        const double instant_s = 1e-3 * std::pow(shape.longest_s / 1e-3, random.uniform());
        if (const std::optional<double> time_s = measure(solve, instant_s))
            times_ms.push_back(1e3 * *time_s);
    }
    std::sort(times_ms.begin(), times_ms.end());
    if (times_ms.empty()) {
        std::printf("%-22s over before every stop\n", shape.name);
        return;
    }
    const auto at = [&](double share) {
        return times_ms[static_cast<std::size_t>(share * static_cast<double>(times_ms.size() - 1))];
    };
    std::printf("%-22s %5zu %8.2f %8.2f %8.2f\n", shape.name, times_ms.size(), at(0.5), at(0.99),
                times_ms.back());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
    const int instants = argc > 1 ? std::atoi(argv[1]) : 12;
    const std::vector<std::string> wanted(argv + std::min(argc, 2), argv + argc);
    std::printf("shape                  stops   median     99 %%    worst   (ms)\n");
    for (const Shape& shape : kShapes)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), shape.name) != wanted.end())
            run(shape, instants);
    return 0;
}
