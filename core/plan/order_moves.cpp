#include "core/plan/order_moves.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace berg {

VisitCosts::VisitCosts(const TvpProblem& problem)
    : icebergs(problem.icebergCount())
    , legs(problem.mu * problem.distance_m.transpose())
    , sigma(problem.sigma_m2)
{
    legs.diagonal().setZero(); // never read, may be anything in the problem
    if (problem.route == Route::Open)
        legs.row(0).setZero();
}

double VisitCosts::total(std::span<const int> order) const
{
    double sum = 0;
    int from = 0;
    int position = 0;
    for (const int node : order) {
        sum += leg(from, node) + visit(node, ++position);
        from = node;
    }
    return sum + leg(from, 0);
}

OrderMoves::OrderMoves(const VisitCosts& costs, std::span<const int> order)
    : m_costs(costs)
    , m_node(static_cast<std::size_t>(costs.icebergs) + 2, 0)
    , m_position(static_cast<std::size_t>(costs.icebergs) + 1, 0)
    , m_sums(static_cast<std::size_t>(costs.icebergs) + 2)
{
    assign(order);
}

void OrderMoves::assign(std::span<const int> order)
{
    std::copy(order.begin(), order.end(), m_node.begin() + 1);
    refresh(1);
}

VisitOrder OrderMoves::order() const
{
    return {m_node.begin() + 1, m_node.end() - 1};
}

double OrderMoves::cost() const
{
    const Prefix& end = m_sums.back();
    return end.forward + end.moment + end.sigma; // sigma (p + 1) = moment + sigma
}

void OrderMoves::refresh(int firstChanged)
{
    for (int p = firstChanged; p <= icebergs() + 1; ++p) {
        const int node = at(p);
        const int before = at(p - 1);
        const Prefix& last = sums(p - 1);
        const double sigma = m_costs.sigma[static_cast<std::size_t>(node)];
        m_sums[static_cast<std::size_t>(p)] = {.forward = last.forward + m_costs.leg(before, node),
                                               .backward =
                                                   last.backward + m_costs.leg(node, before),
                                               .sigma = last.sigma + sigma,
                                               .moment = last.moment + sigma * p};
        m_position[static_cast<std::size_t>(node)] = p;
    }
    m_position[0] = 0;
}

double OrderMoves::reversal(int first, int last) const
{
    const Prefix& a = sums(first);
    const Prefix& b = sums(last);
    const Prefix& before = sums(first - 1);
    const double legs = m_costs.leg(at(first - 1), at(last)) +
                        m_costs.leg(at(first), at(last + 1)) -
                        m_costs.leg(at(first - 1), at(first)) - m_costs.leg(at(last), at(last + 1));
    const double inside = (b.backward - a.backward) - (b.forward - a.forward);
    // Position p becomes first + last - p.
    const double waiting =
        (first + last) * (b.sigma - before.sigma) - 2 * (b.moment - before.moment);
    return legs + inside + waiting;
}

double OrderMoves::exchange(int a, int b) const
{
    if (b == a + 1)
        return reversal(a, b);
    const int x = at(a);
    const int y = at(b);
    const int beforeX = at(a - 1);
    const int afterX = at(a + 1);
    const int beforeY = at(b - 1);
    const int afterY = at(b + 1);
    const double gained = m_costs.leg(beforeX, y) + m_costs.leg(y, afterX) +
                          m_costs.leg(beforeY, x) + m_costs.leg(x, afterY);
    const double saved = m_costs.leg(beforeX, x) + m_costs.leg(x, afterX) +
                         m_costs.leg(beforeY, y) + m_costs.leg(y, afterY);
    const double sigmaX = m_costs.sigma[static_cast<std::size_t>(x)];
    const double sigmaY = m_costs.sigma[static_cast<std::size_t>(y)];
    return gained - saved + (sigmaX - sigmaY) * (b - a);
}

double OrderMoves::relocation(int first, int last, int after, bool turned) const
{
    const int before = at(first - 1);
    const int behind = at(last + 1);
    const int head = turned ? at(last) : at(first);
    const int tail = turned ? at(first) : at(last);
    double delta = m_costs.leg(before, behind) - m_costs.leg(before, at(first)) -
                   m_costs.leg(at(last), behind);
    delta += m_costs.leg(at(after), head) + m_costs.leg(tail, at(after + 1)) -
             m_costs.leg(at(after), at(after + 1));

    const Prefix& a = sums(first);
    const Prefix& b = sums(last);
    const Prefix& o = sums(first - 1);
    const int length = last - first + 1;
    const double pieceSigma = b.sigma - o.sigma;
    if (turned) {
        delta += (b.backward - a.backward) - (b.forward - a.forward);
        delta += (first + last) * pieceSigma - 2 * (b.moment - o.moment);
    }
    if (after > last)
        delta += (after - last) * pieceSigma - length * (sums(after).sigma - b.sigma);
    else
        delta += length * (o.sigma - sums(after).sigma) - (first - 1 - after) * pieceSigma;
    return delta;
}

OrderMove OrderMoves::bestMoveAt(int position) const
{
    using Kind = OrderMove::Kind;
    const int n = icebergs();
    OrderMove best;
    const auto consider = [&best](double delta, const OrderMove& move) {
        if (delta < best.delta) {
            best = move;
            best.delta = delta;
        }
    };
    for (int other = 1; other <= n; ++other) {
        if (other == position)
            continue;
        const int a = std::min(position, other);
        const int b = std::max(position, other);
        consider(reversal(a, b), {.kind = Kind::Reverse, .first = a, .last = b});
        consider(exchange(a, b), {.kind = Kind::Exchange, .first = a, .last = b});
    }
    constexpr int kLongestPiece = 3;
    for (int last = position; last <= std::min(n, position + kLongestPiece - 1); ++last)
        for (int after = 0; after <= n; ++after) {
            if (after >= position - 1 && after <= last)
                continue;
            consider(relocation(position, last, after, false),
                     {.kind = Kind::Relocate, .first = position, .last = last, .after = after});
            if (last > position)
                consider(relocation(position, last, after, true), {.kind = Kind::Relocate,
                                                                   .first = position,
                                                                   .last = last,
                                                                   .after = after,
                                                                   .turned = true});
        }
    return best;
}

void OrderMoves::apply(const OrderMove& move)
{
    const auto place = [this](int position) { return m_node.begin() + position; };
    switch (move.kind) {
    case OrderMove::Kind::None:
        return;
    case OrderMove::Kind::Reverse:
        std::reverse(place(move.first), place(move.last + 1));
        break;
    case OrderMove::Kind::Exchange:
        std::iter_swap(place(move.first), place(move.last));
        break;
    case OrderMove::Kind::Relocate:
        if (move.turned)
            std::reverse(place(move.first), place(move.last + 1));
        if (move.after > move.last)
            std::rotate(place(move.first), place(move.last + 1), place(move.after + 1));
        else
            std::rotate(place(move.after + 1), place(move.first), place(move.last + 1));
        break;
    }
    const bool forward = move.kind != OrderMove::Kind::Relocate || move.after > move.last;
    refresh(forward ? move.first : move.after + 1);
}

VisitOrder sigmaOrder(const TvpProblem& problem)
{
    VisitOrder order(static_cast<std::size_t>(problem.icebergCount()));
    std::iota(order.begin(), order.end(), 1);
    std::sort(order.begin(), order.end(), [&problem](int a, int b) {
        const double sigmaA = problem.sigma_m2[static_cast<std::size_t>(a)];
        const double sigmaB = problem.sigma_m2[static_cast<std::size_t>(b)];
        return std::tuple(-sigmaA, problem.distance_m(0, a), a) <
               std::tuple(-sigmaB, problem.distance_m(0, b), b);
    });
    return order;
}

} // namespace berg
