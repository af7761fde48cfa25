#include "core/study/benchmark.h"

#include "core/base/random.h"
#include "core/plan/tuning.h"

#include <algorithm>
#include <array>

namespace berg {

namespace {

constexpr std::array kPaperTable2{PaperTime{2, 0.02, 0.03},     PaperTime{6, 0.18, 0.42},
                                  PaperTime{10, 0.64, 1.50},    PaperTime{12, 1.71, 4.24},
                                  PaperTime{16, 31.20, 145.16}, PaperTime{20, 2969.69, 17269.17}};

BenchmarkRow runRow(const BenchmarkSpec& spec, int icebergs, Backend backend, double share_s,
                    const std::stop_token& stop)
{
    BenchmarkRow row{.icebergs = icebergs, .backend = backend};
    const std::unique_ptr<TvpSolver> solver = makeSolver(backend, spec.formulation);
    const Stopwatch watch;
    std::vector<double> seconds;
    double worstGap = 0;
    bool bounded = true;
    for (int k = 1; k <= spec.repeat && !stop.stop_requested(); ++k) {
        const TvpProblem problem =
            tableOneProblem(static_cast<std::uint64_t>(k), icebergs, spec.tau);
        row.note = solver->whyNot(problem);
        const double left_s = share_s - watch.elapsed_s();
        if (!row.note.empty() || left_s <= 0)
            break;
        const SolveOutcome outcome = solver->solve(problem, {.timeLimit_s = left_s, .stop = stop});
        if (outcome.reason == StopReason::Cancelled)
            break;
        ++row.instances;
        row.proven += outcome.status == SolveStatus::Optimal ? 1 : 0;
        if (outcome.reason == StopReason::TimeLimit) {
            ++row.cut;
        } else {
            seconds.push_back(outcome.elapsed_s);
            row.worst_s = std::max(row.worst_s, outcome.elapsed_s);
        }
        // A bound without an order has no gap to it.
        const bool hasGap = outcome.bound && outcome.status != SolveStatus::None;
        bounded = bounded && hasGap;
        if (hasGap)
            worstGap = std::max(worstGap, relativeGap(problem, outcome.objective, *outcome.bound));
    }
    row.seconds = summarise(seconds);
    if (row.instances > 0 && bounded)
        row.worstGap = worstGap;
    return row;
}

} // namespace

TvpProblem tableOneProblem(std::uint64_t seed, int icebergs, double tau)
{
    Random random(seed, stableHash("table 1"));
    Eigen::MatrixX2d points_m(icebergs + 1, 2);
    points_m.row(0) << -500, -500;
    TvpProblem problem;
    problem.sigma_m2.push_back(0);
    for (int i = 1; i <= icebergs; ++i) {
        points_m(i, 0) = random.uniform(0, 5000);
        points_m(i, 1) = random.uniform(0, 5000);
        problem.sigma_m2.push_back(static_cast<double>(1 + random.below(10)));
    }
    problem.distance_m = euclideanDistances(points_m);
    problem.mu = tuningWeight(problem, tau).mu;
    return problem;
}

std::span<const PaperTime> paperTable2()
{
    return kPaperTable2;
}

std::vector<BenchmarkRow> runBenchmark(const BenchmarkSpec& spec, const std::stop_token& stop,
                                       const std::function<void(std::size_t, std::size_t)>& onRow)
{
    const Stopwatch watch;
    std::vector<BenchmarkRow> rows;
    const std::size_t count = spec.sizes.size() * spec.backends.size();
    for (const int icebergs : spec.sizes)
        for (const Backend backend : spec.backends) {
            if (stop.stop_requested())
                return rows;
            const auto left = static_cast<double>(count - rows.size());
            const double share_s = (spec.budget_s - watch.elapsed_s()) / left;
            rows.push_back(runRow(spec, icebergs, backend, std::max(0.0, share_s), stop));
            if (onRow)
                onRow(rows.size(), count);
        }
    return rows;
}

} // namespace berg
