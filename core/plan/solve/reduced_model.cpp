#include "core/plan/solve/reduced_model.h"

#include "core/plan/proof/layered_bound.h"
#include "core/plan/solve/engine.h"
#include "core/plan/solve/order_moves.h"
#include "core/plan/solve/solve_watch.h"

namespace berg {

namespace {

/**
 * Returns the cheapest order one move away that costs more, or the order itself if there is none.
 */
VisitOrder cheapestNeighbour(const VisitCosts& costs, const VisitOrder& order)
{
    using Kind = OrderMove::Kind;
    OrderMoves moves(costs, order);
    const double least = 1e-7 * costs.total(order); // smaller differences may be rounding
    OrderMove cheapest;
    const auto consider = [&](double delta, const OrderMove& move) {
        if (delta > least && (cheapest.kind == Kind::None || delta < cheapest.delta)) {
            cheapest = move;
            cheapest.delta = delta;
        }
    };
    for (int a = 1; a < costs.icebergs; ++a)
        for (int b = a + 1; b <= costs.icebergs; ++b) {
            consider(moves.reversal(a, b), {.kind = Kind::Reverse, .first = a, .last = b});
            consider(moves.exchange(a, b), {.kind = Kind::Exchange, .first = a, .last = b});
        }
    moves.apply(cheapest);
    return moves.order();
}

} // namespace

ReducedModel reducedModel(const TvpProblem& problem, const SolveOptions& options)
{
    const SolveWatch watch(options);
    ReducedModel reduced;
    // With the optimum as incumbent few columns remain, so it pays to search for it with the bound.
    reduced.incumbent =
        LocalSearch()
            .solve(problem,
                   {.timeLimit_s = options.timeLimit_s, .hint = options.hint, .stop = options.stop})
            .order();
    if (reduced.incumbent.empty() || watch.stopReason())
        return reduced;

    constexpr std::int64_t kMostWork = 900'000'000; // seldom used up
    const VisitCosts costs(problem);
    const BoundOptions bound{.workLimit = kMostWork,
                             .isStopped = [&watch] { return watch.stopReason().has_value(); }};
    std::vector<MilpArc> arcs =
        survivingArcs(costs, cheapestNeighbour(costs, reduced.incumbent), bound);
    if (!watch.stopReason())
        reduced.milp = positionModel(problem, std::move(arcs));
    return reduced;
}

} // namespace berg
