#include "core/study/benchmark.h"

#include "core/base/random.h"
#include "core/plan/problem/tuning.h"

#include <algorithm>
#include <memory>

namespace berg {

namespace {

constexpr std::array kPaperTable2{PaperTime{2, 0.02, 0.03},     PaperTime{6, 0.18, 0.42},
                                  PaperTime{10, 0.64, 1.50},    PaperTime{12, 1.71, 4.24},
                                  PaperTime{16, 31.20, 145.16}, PaperTime{20, 2969.69, 17269.17}};

/** Runs the instances of one row. */
class RowRun
{
public:
    RowRun(const BenchmarkSpec& spec, BenchmarkRow& row) : m_spec(spec), m_row(row) {}

    /** Returns false if the row must end, because it is cancelled or the budget is used up. */
    bool solveNext(const TvpSolver& solver, double left_s, const std::stop_token& stop)
    {
        const auto seed = static_cast<std::uint64_t>(m_row.instances) + 1;
        const TvpProblem problem = tableOneProblem(seed, m_row.icebergs, m_spec.tau);
        const SolveOutcome outcome = solver.solve(problem, {.timeLimit_s = left_s, .stop = stop});
        if (outcome.reason == StopReason::Cancelled)
            return false;
        addOutcome(problem, outcome);
        return true;
    }

    void summariseRow()
    {
        m_row.seconds = summarise(m_seconds);
        if (!m_seconds.empty()) {
            m_row.worst_s = *std::max_element(m_seconds.begin(), m_seconds.end());
            m_row.meanObjective = m_objectives / static_cast<double>(m_seconds.size());
        }
        if (m_row.instances > 0 && m_bounded)
            m_row.worstGap = m_worstGap;
    }

private:
    void addOutcome(const TvpProblem& problem, const SolveOutcome& outcome)
    {
        ++m_row.instances;
        m_row.proven += outcome.status == SolveStatus::Optimal ? 1 : 0;
        if (outcome.reason == StopReason::TimeLimit) {
            ++m_row.cut;
        } else {
            m_seconds.push_back(outcome.elapsed_s);
            m_objectives += outcome.objective;
            m_row.work += outcome.work;
        }
        // The gap needs both an order and a bound.
        m_bounded = m_bounded && outcome.bound && outcome.status != SolveStatus::None;
        if (m_bounded)
            m_worstGap =
                std::max(m_worstGap, relativeGap(problem, outcome.objective, *outcome.bound));
    }

    const BenchmarkSpec& m_spec;
    BenchmarkRow& m_row;
    std::vector<double> m_seconds;
    double m_objectives = 0;
    double m_worstGap = 0;
    bool m_bounded = true;
};

/** One solver and the size at which it failed. */
struct BenchmarkEntry
{
    BenchmarkSolver spec;
    std::unique_ptr<TvpSolver> solver;
    std::optional<int> unfinished; ///< size that it did not finish

    /** Returns why it must not try this size, or an empty text. */
    [[nodiscard]] std::string unsupportedReason(int icebergs) const
    {
        if (unfinished)
            return "not tried: " + std::to_string(*unfinished) + " icebergs took too long";
        const std::optional<IssueReason> reason =
            solver->unsupportedReason(tableOneProblem(1, icebergs));
        return reason ? englishText(*reason) : std::string();
    }
};

std::vector<int> ascending(std::vector<int> sizes)
{
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
}

/** Runs the whole benchmark, row by row. */
class BenchmarkRun
{
public:
    BenchmarkRun(const BenchmarkSpec& spec, const std::stop_token& stop,
                 const std::function<void(const BenchmarkProgress&)>& onProgress)
        : m_spec(spec), m_stop(stop), m_onProgress(onProgress), m_sizes(ascending(spec.sizes))
    {
        for (const BenchmarkSolver& solver : spec.solvers)
            m_entries.push_back(
                {.spec = solver, .solver = makeSolver(solver.backend, solver.formulation)});
    }

    std::vector<BenchmarkRow> run()
    {
        for (std::size_t size = 0; size < m_sizes.size(); ++size)
            for (std::size_t who = 0; who < m_entries.size(); ++who) {
                if (m_stop.stop_requested())
                    return std::move(m_rows);
                const double share_s = (m_spec.budget_s - m_watch.elapsed_s()) /
                                       static_cast<double>(rowsToSolve(size, who));
                runRow(m_sizes[size], m_entries[who], share_s);
            }
        return std::move(m_rows);
    }

private:
    /**
     * Returns the number of rows of this size, from this one on, and of the next size that take
     * time; at least 1.
     */
    [[nodiscard]] std::size_t rowsToSolve(std::size_t size, std::size_t who) const
    {
        std::size_t rows = 0;
        for (std::size_t s = size; s < std::min(size + 2, m_sizes.size()); ++s)
            for (std::size_t w = s == size ? who : 0; w < m_entries.size(); ++w)
                rows += m_entries[w].unsupportedReason(m_sizes[s]).empty() ? 1U : 0U;
        return std::max<std::size_t>(rows, 1);
    }

    void runRow(int icebergs, BenchmarkEntry& entry, double share_s)
    {
        const Stopwatch watch;
        BenchmarkRow row{
            .icebergs = icebergs, .solver = entry.spec, .note = entry.unsupportedReason(icebergs)};
        RowRun run(m_spec, row);
        bool continues = row.note.empty();
        while (continues && row.instances < m_spec.repeat) {
            const double left_s = share_s - watch.elapsed_s();
            continues = left_s > 0 && run.solveNext(*entry.solver, left_s, m_stop);
            if (continues && row.instances < m_spec.repeat)
                reportProgress(row.instances);
        }
        run.summariseRow();
        const bool tried = row.note.empty();
        const bool finished = row.instances == m_spec.repeat && row.cut == 0;
        if (tried && !finished)
            entry.unfinished = icebergs;
        if (tried && row.instances == 0) {
            if (m_stop.stop_requested())
                return;
            row.note = "not tried: no time left";
        }
        m_rows.push_back(std::move(row));
        reportProgress(0);
    }

    /** Reports progress; `instances` of the present row are done. */
    void reportProgress(int instances) const
    {
        const auto repeat = static_cast<std::size_t>(m_spec.repeat);
        if (m_onProgress)
            m_onProgress({.rows = m_rows,
                          .done = m_rows.size() * repeat + static_cast<std::size_t>(instances),
                          .count = m_sizes.size() * m_entries.size() * repeat});
    }

    const BenchmarkSpec& m_spec;
    const std::stop_token& m_stop;
    const std::function<void(const BenchmarkProgress&)>& m_onProgress;
    std::vector<int> m_sizes;
    std::vector<BenchmarkEntry> m_entries;
    std::vector<BenchmarkRow> m_rows;
    Stopwatch m_watch;
};

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

std::vector<BenchmarkSolver> benchmarkSolvers()
{
    std::vector<BenchmarkSolver> solvers;
    for (const Named<BenchmarkSolver>& named : kBenchmarkSolverNames) {
        if (named.value.backend == Backend::Auto)
            continue;
        try {
            static_cast<void>(makeSolver(named.value.backend, named.value.formulation));
            solvers.push_back(named.value);
        } catch (const Error&) {
            continue; // missing in this build
        }
    }
    return solvers;
}

std::vector<BenchmarkRow>
runBenchmark(const BenchmarkSpec& spec, const std::stop_token& stop,
             const std::function<void(const BenchmarkProgress&)>& onProgress)
{
    return BenchmarkRun(spec, stop, onProgress).run();
}

} // namespace berg
