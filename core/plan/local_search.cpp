#include "core/plan/local_search.h"

#include "core/base/random.h"
#include "core/plan/layered_bound.h"
#include "core/plan/order_moves.h"
#include "core/plan/solve_watch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace berg {

namespace {

/** Gains below this share of the cost are rounding, not gains: a descent must come to an end. */
constexpr double kLeastGain = 1e-10;

/**
 * Descent by first improvement over icebergs, best move of each iceberg. Icebergs whose
 * neighbours have not changed since they were looked at in vain are not looked at again.
 */
class Descent
{
public:
    Descent(const VisitCosts& costs, const VisitOrder& order, const SolveWatch& watch)
        : m_moves(costs, order), m_watch(watch), m_active(order.size() + 1, true)
    {
    }

    [[nodiscard]] double cost() const { return m_moves.cost(); }
    [[nodiscard]] VisitOrder order() const { return m_moves.order(); }

    void assign(const VisitOrder& order) { m_moves.assign(order); }
    void activateAll() { m_active.assign(m_active.size(), true); }
    /** Makes a move, good or bad. */
    void make(const OrderMove& move)
    {
        const int end = m_moves.icebergs() + 1;
        for (const int position : {move.first - 1, move.first, move.first + 1, move.last - 1,
                                   move.last, move.last + 1, move.after, move.after + 1})
            m_active[static_cast<std::size_t>(m_moves.at(std::clamp(position, 0, end)))] = true;
        m_moves.apply(move);
    }

    /** Goes down to a local optimum, or until the solve is cut. */
    void run()
    {
        const double least = kLeastGain * cost();
        for (bool again = true; again;) {
            again = false;
            for (int position = 1; position <= m_moves.icebergs(); ++position) {
                const auto node = static_cast<std::size_t>(m_moves.at(position));
                if (!m_active[node])
                    continue;
                if (++m_looks % kLooksPerCheck == 0 && m_watch.cut())
                    return;
                again = true;
                const OrderMove move = m_moves.bestMoveAt(position);
                if (move.delta < -least)
                    make(move);
                else
                    m_active[node] = false;
            }
        }
    }

private:
    static constexpr int kLooksPerCheck = 16;

    OrderMoves m_moves;
    const SolveWatch& m_watch;
    std::vector<bool> m_active; ///< by node
    int m_looks = 0;
};

/** What the next iceberg of a greedy order is chosen by. */
enum class Greed
{
    Nearest,  ///< shortest leg
    Ratio,    ///< shortest leg per sigma
    Sigma,    ///< largest sigma
    Earlier,  ///< leg less the cost of waiting for a part of the time that is left
    Earliest, ///< the same with twice that part
};

/** The smaller the better. */
double greedyValue(Greed greed, double leg, double sigma, int left)
{
    constexpr double kPart = 0.125;
    switch (greed) {
    case Greed::Nearest:
        return leg;
    case Greed::Ratio:
        return leg / (sigma + 1e-9); // sigma 0 comes last
    case Greed::Sigma:
        return -sigma;
    case Greed::Earlier:
        return leg - kPart * sigma * left;
    case Greed::Earliest:
        return leg - 2 * kPart * sigma * left;
    }
    return leg;
}

/** Ties go to the shorter leg, then to the smaller number. */
VisitOrder greedyOrder(const VisitCosts& costs, Greed greed)
{
    VisitOrder order;
    std::vector<bool> used(costs.sigma.size(), false);
    for (int left = costs.icebergs; left > 0; --left) {
        const int from = order.empty() ? 0 : order.back();
        int best = 0;
        std::pair<double, double> least;
        for (int j = 1; j <= costs.icebergs; ++j) {
            if (used[static_cast<std::size_t>(j)])
                continue;
            const double leg = costs.leg(from, j);
            const std::pair value{
                greedyValue(greed, leg, costs.sigma[static_cast<std::size_t>(j)], left), leg};
            if (best == 0 || value < least) {
                best = j;
                least = value;
            }
        }
        used[static_cast<std::size_t>(best)] = true;
        order.push_back(best);
    }
    return order;
}

/** Restarts from a disturbed order: enough for the optimum in nine cases of ten at 40 icebergs. */
std::int64_t restartsFor(std::int64_t icebergs)
{
    if (icebergs < 3)
        return 0; // a descent tries everything
    return std::max<std::int64_t>(10, std::min(icebergs * icebergs / 8, 150'000 / icebergs));
}

/** Two neighbouring pieces of the order change places: no single move of the descent undoes it. */
OrderMove disturbance(Random& random, int icebergs)
{
    constexpr int kWidest = 50;
    const int width = std::min(icebergs, kWidest);
    const auto draw = [&random](int count) {
        return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
    };
    const int start = draw(icebergs - width + 1);
    std::array<int, 3> ends{};
    do {
        for (int& end : ends)
            end = start + draw(width + 1);
        std::sort(ends.begin(), ends.end());
    } while (ends[0] == ends[1] || ends[1] == ends[2]);
    OrderMove move;
    move.kind = OrderMove::Kind::Relocate;
    move.first = ends[0] + 1;
    move.last = ends[1];
    move.after = ends[2];
    return move;
}

/** One solve: the incumbent and how it gets better. */
class Search
{
public:
    Search(const TvpProblem& problem, const SolveOptions& options)
        : m_problem(problem)
        , m_options(options)
        , m_watch(options)
        , m_costs(problem)
        , m_shift(objectiveShift(problem))
    {
        m_outcome.status = SolveStatus::Feasible;
    }

    SolveOutcome run()
    {
        construct();
        if (mayGoOn() && disturb())
            bound();
        m_outcome.order = m_best;
        m_outcome.hintUsed = !m_options.hint.empty();
        return std::move(m_outcome);
    }

private:
    /** Local optima from the hint and from greedy orders; at least the first one's start. */
    void construct()
    {
        if (!m_options.hint.empty())
            descendFrom(m_options.hint);
        for (const Greed greed :
             {Greed::Nearest, Greed::Ratio, Greed::Sigma, Greed::Earlier, Greed::Earliest}) {
            if (!m_best.empty() && !mayGoOn())
                return;
            descendFrom(greedyOrder(m_costs, greed));
        }
    }

    void descendFrom(const VisitOrder& order)
    {
        Descent descent(m_costs, order, m_watch);
        descent.run();
        keep(descent);
    }

    /** Iterated local search; returns whether all restarts were made. */
    bool disturb()
    {
        const std::int64_t wanted = restartsFor(m_costs.icebergs);
        const std::int64_t count = std::min(wanted, m_options.workLimit.value_or(wanted));
        Random random(2015, static_cast<std::uint64_t>(m_costs.icebergs));
        Descent descent(m_costs, m_best, m_watch);
        descent.run();
        keep(descent);
        VisitOrder current = m_best;
        double currentCost = m_bestCost;
        for (; m_outcome.work < count && mayGoOn(); ++m_outcome.work) {
            descent.make(disturbance(random, m_costs.icebergs));
            descent.run();
            keep(descent);
            // Slightly worse orders are accepted, less and less so: without that the search
            // stays in one valley.
            const double progress =
                static_cast<double>(m_outcome.work) / static_cast<double>(count);
            const double tolerance = 0.4 / m_costs.icebergs * (1 - progress);
            if (descent.cost() <= currentCost * (1 + tolerance)) {
                currentCost = descent.cost();
                current = descent.order();
            } else {
                descent.assign(current);
            }
        }
        if (count < wanted && m_outcome.work == count)
            m_outcome.reason = StopReason::WorkLimit;
        return m_outcome.work == wanted;
    }

    void bound()
    {
        BoundOptions options;
        options.gap = m_options.gap;
        // About 1.5 s, seldom used up below 60 icebergs; the plain relaxation is slower to pay.
        options.workLimit = m_costs.icebergs < 128 ? 900'000'000 : 2'000'000'000;
        options.cut = [this] { return !mayGoOn(); };
        options.onImproved = [this](const VisitOrder& order, double bound) {
            m_watch.report(order, objective(m_problem, order), boundOfObjective(bound));
        };
        const BoundResult result = improveBound(m_costs, m_best, options);
        m_best = result.order;
        m_bestCost = m_costs.total(m_best);
        m_outcome.bound = boundOfObjective(result.bound);
        if (!result.reached)
            return;
        constexpr double kProven = 2e-9; // the bound's own margin and its rounding
        if (m_bestCost - result.bound <= kProven * m_bestCost)
            m_outcome.status = SolveStatus::Optimal;
        else
            m_outcome.reason = StopReason::GapReached;
        m_watch.report(m_best, objective(m_problem, m_best), m_outcome.bound);
    }

    /** Nothing for 0: that every cost is positive goes without saying. */
    [[nodiscard]] std::optional<double> boundOfObjective(double bound) const
    {
        return bound > 0 ? std::optional(bound - m_shift) : std::nullopt;
    }

    void keep(const Descent& descent)
    {
        if (!m_best.empty() && descent.cost() >= m_bestCost * (1 - kLeastGain))
            return;
        m_best = descent.order();
        m_bestCost = descent.cost();
        m_watch.report(m_best, objective(m_problem, m_best), std::nullopt);
    }

    /** Notes the reason when not. */
    bool mayGoOn()
    {
        const std::optional<StopReason> cut = m_watch.cut();
        if (cut)
            m_outcome.reason = *cut;
        return !cut;
    }

    const TvpProblem& m_problem;
    const SolveOptions& m_options;
    SolveWatch m_watch;
    VisitCosts m_costs;
    double m_shift; ///< cost = objective + shift
    VisitOrder m_best;
    double m_bestCost = 0;
    SolveOutcome m_outcome;
};

} // namespace

std::string LocalSearch::whyNot(const TvpProblem&) const
{
    return {};
}

SolveOutcome LocalSearch::doSolve(const TvpProblem& problem, const SolveOptions& options) const
{
    if (problem.mu > 0)
        return Search(problem, options).run();

    SolveOutcome outcome;
    outcome.status = SolveStatus::Optimal;
    outcome.order = sigmaOrder(problem);
    const double value = objective(problem, outcome.order);
    SolveWatch(options).report(outcome.order, value, value);
    return outcome;
}

} // namespace berg
