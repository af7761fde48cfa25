#include "core/plan/problem/milp_relaxation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace berg {

namespace {

std::size_t slot(const MilpModel& model, int position, NodeIndex node)
{
    const auto nodes = static_cast<std::size_t>(model.nodeCount);
    return static_cast<std::size_t>(position) * nodes + toIndex(node);
}

VisitOrder byMeanPosition(const MilpModel& model, std::span<const double> relaxed)
{
    require(relaxed.size() == model.columns.size(),
            "roundRelaxation: one value per column expected");
    std::vector<double> mean(static_cast<std::size_t>(model.nodeCount), 0.0);
    if (model.hasOrderColumns)
        std::copy_n(relaxed.begin() + static_cast<std::ptrdiff_t>(model.arcs.size()), mean.size(),
                    mean.begin());
    else
        for (std::size_t c = 0; c < model.arcs.size(); ++c)
            mean[toIndex(model.arcs[c].to)] += relaxed[c] * *model.arcs[c].position;

    VisitOrder order = ascendingOrder(model.nodeCount - 1);
    std::stable_sort(order.begin(), order.end(), [&mean](NodeIndex a, NodeIndex b) {
        return mean[toIndex(a)] < mean[toIndex(b)];
    });
    return order;
}

/** Returns Eq. (1) without checking the order. */
double costOf(const TvpProblem& problem, const VisitOrder& order)
{
    return problem.mu * flownDistance(problem, order) - uncertaintyReward(problem, order);
}

/** Makes one round of moves, each applied if it pays. Returns false if none did. */
bool improve(const TvpProblem& problem, VisitOrder& order, double& cost)
{
    const double leastGain = 1e-12 * (std::abs(cost) + objectiveShift(problem));
    bool improved = false;
    VisitOrder trial;
    const auto applyIfBetter = [&](auto&& change) {
        trial = order;
        change(trial.begin());
        const double value = costOf(problem, trial);
        if (value >= cost - leastGain)
            return;
        order.swap(trial);
        cost = value;
        improved = true;
    };
    const auto icebergs = static_cast<std::ptrdiff_t>(order.size());
    for (std::ptrdiff_t i = 0; i + 1 < icebergs; ++i)
        for (std::ptrdiff_t j = i + 1; j < icebergs; ++j) {
            applyIfBetter(
                [i, j](auto first) { std::rotate(first + i, first + i + 1, first + j + 1); });
            applyIfBetter([i, j](auto first) { std::rotate(first + i, first + j, first + j + 1); });
            applyIfBetter([i, j](auto first) { std::reverse(first + i, first + j + 1); });
        }
    return improved;
}

} // namespace

AdmissibleFlow::AdmissibleFlow(const MilpModel& model)
    : m_model(model), m_outgoing(slot(model, model.nodeCount + 1, 0))
{
    for (std::size_t c = 0; c < model.arcs.size(); ++c) {
        const MilpArc& arc = model.arcs[c];
        m_outgoing[slot(model, arc.position.value_or(0), arc.from)].push_back(static_cast<int>(c));
    }
}

const std::vector<int>& AdmissibleFlow::onwardFrom(const MilpArc& arc) const
{
    return m_outgoing[slot(m_model, *arc.position + 1, arc.to)];
}

std::vector<MilpRow> AdmissibleFlow::violated(std::span<const double> relaxed,
                                              double leastViolation) const
{
    require(relaxed.size() == m_model.columns.size(), "violated: one value per column expected");
    const auto value = [&relaxed](int column) { return relaxed[static_cast<std::size_t>(column)]; };
    std::vector<MilpRow> rows;
    for (int c = 0; c < static_cast<int>(m_model.arcs.size()); ++c) {
        const MilpArc& arc = m_model.arcs[static_cast<std::size_t>(c)];
        const bool last = arc.position == m_model.nodeCount - 1;
        if (value(c) <= leastViolation || arc.from == 0 || last)
            continue;
        MilpRow row{.name = {}, .upper = 0, .terms = {{c, 1}}};
        double excess = value(c);
        for (const int onward : onwardFrom(arc))
            if (m_model.arcs[static_cast<std::size_t>(onward)].to != arc.from) {
                row.terms.push_back({onward, -1});
                excess -= value(onward);
            }
        if (excess > leastViolation)
            rows.push_back(std::move(row));
    }
    return rows;
}

VisitOrder roundRelaxation(const TvpProblem& problem, const MilpModel& model,
                           std::span<const double> relaxed)
{
    VisitOrder order = byMeanPosition(model, relaxed);
    double cost = objective(problem, order);
    while (improve(problem, order, cost)) {
    }
    return order;
}

} // namespace berg
