#include "core/cbc/cbc_run.h"

#include <algorithm>
#include <cstddef>

namespace berg {

namespace {

/** Median to which costs are scaled, to suit Clp's absolute tolerances for any mu and sigma. */
constexpr double kMedianCost = 100;
/** Share of sum(sigma t) + mu D by which bounds are lowered, because Clp has tolerances. */
constexpr double kBoundMargin = 1e-7;

double scaleOf(const MilpModel& milp)
{
    std::vector<double> costs;
    for (const MilpColumn& column : milp.columns)
        if (column.objective > 0)
            costs.push_back(column.objective);
    if (costs.empty())
        return 1;
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), middle, costs.end());
    return kMedianCost / *middle;
}

} // namespace

CbcRun::CbcRun(const TvpProblem& problem, const SolveOptions& options, const MilpModel& milp)
    : m_problem(problem)
    , m_options(options)
    , m_milp(milp)
    , m_scale(scaleOf(milp))
    , m_watch(options)
    , m_best(options.hint.empty() ? VisitOrder{} : options.hint.front())
{
    if (!m_best.empty())
        m_bestObjective = objective(problem, m_best);
}

double CbcRun::scaledObjective(const VisitOrder& order) const
{
    return m_scale * (objective(m_problem, order) - m_milp.objectiveOffset);
}

double CbcRun::searchGap() const
{
    return std::max(0.0, m_options.gap - 2 * kBoundMargin);
}

bool CbcRun::mustStop()
{
    if (!m_stopped)
        m_stopped = m_failure ? StopReason::Cancelled : m_watch.stopReason();
    return m_stopped.has_value();
}

void CbcRun::raiseBound(double scaledBound)
{
    double bound = (1 - kBoundMargin) * scaledBound / m_scale + m_milp.objectiveOffset;
    if (!m_best.empty())
        bound = std::min(bound, m_bestObjective);
    m_bound = std::max(bound, m_bound.value_or(bound));
}

void CbcRun::harvest(std::span<const double> solution)
{
    const VisitOrder order = decode(m_milp, solution);
    if (order.empty() || order == m_best)
        return;
    const double value = objective(m_problem, order);
    if (!m_best.empty() && value >= m_bestObjective)
        return;
    m_best = order;
    m_bestObjective = value;
    report();
}

void CbcRun::report() const
{
    if (!m_best.empty() && !m_failure)
        m_watch.report({m_best}, m_bestObjective, m_bound);
}

void CbcRun::reportAtIntervals()
{
    constexpr double kEvery_s = 0.1;
    if (m_stopwatch.elapsed_s() < m_reported_s + kEvery_s)
        return;
    report();
    m_reported_s = m_stopwatch.elapsed_s();
}

void CbcRun::rethrow() const
{
    if (m_failure)
        std::rethrow_exception(m_failure);
}

} // namespace berg
