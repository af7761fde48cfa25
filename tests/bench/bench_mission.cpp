// Cold against warm start over the re-plans of whole missions, and the speed of flying.
//
// The paper promises that starting from the last solution "can greatly reduce the computational
// time". Every re-plan of the missions is solved twice by the same back end, once without and once
// with the rest of the last order as hint; the flight itself goes on with the cold answer, so that
// both columns see the same problems.
//
// Use: bench_mission [missions] [icebergs of the cbc rows]

#include "core/mission/mission.h"
#include "core/plan/solve/names.h"
#include "core/presets/presets.h"
#include "core/study/statistics.h"

#include <cstdio>
#include <cstdlib>
#include <numeric>

namespace {

using namespace berg;

struct Times
{
    std::vector<double> cold_s;
    std::vector<double> warm_s;
    int hintsUsed = 0;
    int different = 0; ///< warm and cold objective differ by more than rounding
};

class PairedSolver final : public TvpSolver
{
public:
    PairedSolver(Backend backend, Times& times) : m_solver(makeSolver(backend)), m_times(times) {}
    [[nodiscard]] AnswerSource source() const override { return m_solver->source(); }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem& p) const override
    {
        return m_solver->unsupportedReason(p);
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        SolveOptions withoutHint = options;
        withoutHint.hint.clear();
        SolveOutcome cold = m_solver->solve(problem, withoutHint);
        if (options.hint.empty())
            return cold;
        const SolveOutcome warm = m_solver->solve(problem, options);
        m_times.cold_s.push_back(cold.elapsed_s);
        m_times.warm_s.push_back(warm.elapsed_s);
        m_times.hintsUsed += warm.hintUsed ? 1 : 0;
        const double scale = 1 + std::abs(cold.objective);
        m_times.different += std::abs(warm.objective - cold.objective) > 1e-6 * scale ? 1 : 0;
        return cold;
    }

private:
    std::unique_ptr<TvpSolver> m_solver;
    Times& m_times;
};

void compare(Backend backend, int icebergs, int missions)
{
    Times times;
    for (int seed = 1; seed <= missions; ++seed) {
        Mission mission(randomScenario(seed, {.icebergs = icebergs}), {.record = false},
                        std::make_unique<PairedSolver>(backend, times));
        mission.advance(1000);
    }
    const double cold_s = std::accumulate(times.cold_s.begin(), times.cold_s.end(), 0.0);
    const double warm_s = std::accumulate(times.warm_s.begin(), times.warm_s.end(), 0.0);
    std::printf("%-10s %8d %8zu %8d %11.3f %11.3f %11.3f %11.3f %8.2f %6d\n",
                nameOf(kBackendNames, backend).c_str(), icebergs, times.cold_s.size(),
                times.hintsUsed, 1e3 * summarise(times.cold_s).median,
                1e3 * summarise(times.warm_s).median, cold_s, warm_s, cold_s / warm_s,
                times.different);
    std::fflush(stdout);
}

void flyingSpeed()
{
    std::vector<double> seconds;
    for (int seed = 1; seed <= 200; ++seed) {
        const Stopwatch watch;
        Mission mission(randomScenario(seed), {.record = false});
        mission.advance(1000);
        seconds.push_back(watch.elapsed_s());
    }
    std::printf("one mission (12 icebergs, 1000 s, dt 0.1 s): median %.3f ms\n",
                1e3 * summarise(seconds).median);
}

} // namespace

int main(int argc, char** argv)
{
    const int missions = argc > 1 ? std::atoi(argv[1]) : 50;
    const int cbcIcebergs = argc > 2 ? std::atoi(argv[2]) : 8;
    flyingSpeed();
    std::printf("%-10s %8s %8s %8s %11s %11s %11s %11s %8s %6s\n", "solver", "icebergs", "replans",
                "warm", "cold ms", "warm ms", "cold sum s", "warm sum s", "ratio", "differ");
    compare(Backend::Exact, 12, missions);
    compare(Backend::Heuristic, 12, missions);
    compare(Backend::Heuristic, 20, missions);
    try {
        compare(Backend::Cbc, cbcIcebergs, missions);
    } catch (const Error& error) {
        std::printf("cbc: %s\n", error.what());
    }
    return 0;
}
