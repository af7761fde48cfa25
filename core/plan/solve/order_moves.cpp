#include "core/plan/solve/order_moves.h"

#include "core/plan/proof/certified.h"
#include "core/plan/solve/search_effort.h"

#include <algorithm>
#include <tuple>

namespace berg {

template <class Costs>
OrderMoves<Costs>::OrderMoves(const Costs& costs, std::span<const NodeIndex> order)
    : m_costs(costs)
    , m_node(static_cast<std::size_t>(costs.icebergs) + 2)
    , m_position(static_cast<std::size_t>(costs.icebergs) + 1, 0)
    , m_sums(static_cast<std::size_t>(costs.icebergs) + 2)
{
    assign(order);
}

template <class Costs>
void OrderMoves<Costs>::assign(std::span<const NodeIndex> order)
{
    std::copy(order.begin(), order.end(), m_node.begin() + 1);
    refresh(1);
}

template <class Costs>
VisitOrder OrderMoves<Costs>::order() const
{
    return {m_node.begin() + 1, m_node.end() - 1};
}

template <class Costs>
double OrderMoves<Costs>::cost() const
{
    const Sums& end = m_sums.back();
    if constexpr (Costs::kWeighted)
        return m_costs.sigmaSum * end.forward - end.forwardSeen;
    else
        return end.forward + end.moment + end.sigma; // sigma (p + 1) = moment + sigma
}

template <class Costs>
double OrderMoves<Costs>::rounding() const
{
    const Sums& end = m_sums.back();
    const double legs = end.forward + end.backward;
    const int n = icebergs();
    // A move has up to five pieces, each with a product or two of differences of sums over n
    // icebergs.
    if constexpr (Costs::kWeighted)
        return roundingMargin(2 * n, m_costs.sigmaSum * legs);
    else
        return roundingMargin(2 * n, legs + end.moment + n * end.sigma);
}

template <class Costs>
OrderSums<Costs> OrderMoves<Costs>::next(const Sums& last, int position) const
{
    const NodeIndex node = at(position);
    const double sigma = m_costs.sigmaOf(node);
    const double forward = m_costs.leg(at(position - 1), node);
    const double backward = m_costs.leg(node, at(position - 1));
    Sums sums{.forward = last.forward + forward,
              .backward = last.backward + backward,
              .sigma = last.sigma + sigma};
    if constexpr (Costs::kWeighted) {
        sums.forwardSeen = last.forwardSeen + forward * last.sigma;
        sums.backwardSeen = last.backwardSeen + backward * last.sigma;
    } else {
        sums.moment = last.moment + sigma * position;
    }
    return sums;
}

template <class Costs>
void OrderMoves<Costs>::refresh(int firstChanged)
{
    for (int p = firstChanged; p <= icebergs() + 1; ++p) {
        m_sums[static_cast<std::size_t>(p)] = next(sums(p - 1), p);
        m_position[toIndex(at(p))] = p;
    }
    m_position[0] = 0;
}

template <class Costs>
template <std::size_t Count>
double OrderMoves<Costs>::rearrangement(const std::array<Piece, Count>& pieces) const
    requires(Costs::kWeighted)
{
    int first = icebergs();
    int last = 1;
    for (const Piece& piece : pieces) {
        first = std::min(first, piece.first);
        last = std::max(last, piece.last);
    }
    const Sums& before = sums(first - 1);

    double unseen = m_costs.sigmaSum - before.sigma;
    double cost = 0;
    NodeIndex from = at(first - 1);
    for (const Piece& piece : pieces) {
        const Sums& head = sums(piece.first);
        const Sums& tail = sums(piece.last);
        const Sums& outside = sums(piece.first - 1);
        if (piece.turned) {
            cost += m_costs.leg(from, at(piece.last)) * unseen;
            cost += (unseen - tail.sigma) * (tail.backward - head.backward) +
                    (tail.backwardSeen - head.backwardSeen);
            from = at(piece.first);
        } else {
            cost += m_costs.leg(from, at(piece.first)) * unseen;
            cost += (unseen + outside.sigma) * (tail.forward - head.forward) -
                    (tail.forwardSeen - head.forwardSeen);
            from = at(piece.last);
        }
        unseen -= tail.sigma - outside.sigma;
    }
    cost += m_costs.leg(from, at(last + 1)) * unseen;

    const Sums& behind = sums(last + 1);
    return cost - (m_costs.sigmaSum * (behind.forward - before.forward) -
                   (behind.forwardSeen - before.forwardSeen));
}

template <class Costs>
double OrderMoves<Costs>::reversal(int first, int last) const
{
    if constexpr (Costs::kWeighted) {
        return rearrangement(std::array{Piece{first, last, true}});
    } else {
        const Sums& a = sums(first);
        const Sums& b = sums(last);
        const Sums& before = sums(first - 1);
        const double legs =
            m_costs.leg(at(first - 1), at(last)) + m_costs.leg(at(first), at(last + 1)) -
            m_costs.leg(at(first - 1), at(first)) - m_costs.leg(at(last), at(last + 1));
        const double inside = (b.backward - a.backward) - (b.forward - a.forward);
        // Position p becomes first + last - p.
        const double waiting =
            (first + last) * (b.sigma - before.sigma) - 2 * (b.moment - before.moment);
        return legs + inside + waiting;
    }
}

template <class Costs>
double OrderMoves<Costs>::exchange(int a, int b) const
{
    if (b == a + 1)
        return reversal(a, b);
    if constexpr (Costs::kWeighted) {
        return rearrangement(std::array{Piece{b, b}, Piece{a + 1, b - 1}, Piece{a, a}});
    } else {
        const NodeIndex x = at(a);
        const NodeIndex y = at(b);
        const NodeIndex beforeX = at(a - 1);
        const NodeIndex afterX = at(a + 1);
        const NodeIndex beforeY = at(b - 1);
        const NodeIndex afterY = at(b + 1);
        const double gained = m_costs.leg(beforeX, y) + m_costs.leg(y, afterX) +
                              m_costs.leg(beforeY, x) + m_costs.leg(x, afterY);
        const double saved = m_costs.leg(beforeX, x) + m_costs.leg(x, afterX) +
                             m_costs.leg(beforeY, y) + m_costs.leg(y, afterY);
        const double sigmaX = m_costs.sigmaOf(x);
        const double sigmaY = m_costs.sigmaOf(y);
        return gained - saved + (sigmaX - sigmaY) * (b - a);
    }
}

template <class Costs>
double OrderMoves<Costs>::relocation(int first, int last, int after, bool turned) const
{
    if constexpr (Costs::kWeighted) {
        return after > last
                   ? rearrangement(std::array{Piece{last + 1, after}, Piece{first, last, turned}})
                   : rearrangement(
                         std::array{Piece{first, last, turned}, Piece{after + 1, first - 1}});
    } else {
        const NodeIndex before = at(first - 1);
        const NodeIndex behind = at(last + 1);
        const NodeIndex head = turned ? at(last) : at(first);
        const NodeIndex tail = turned ? at(first) : at(last);
        double delta = m_costs.leg(before, behind) - m_costs.leg(before, at(first)) -
                       m_costs.leg(at(last), behind);
        delta += m_costs.leg(at(after), head) + m_costs.leg(tail, at(after + 1)) -
                 m_costs.leg(at(after), at(after + 1));

        const Sums& a = sums(first);
        const Sums& b = sums(last);
        const Sums& o = sums(first - 1);
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
}

template <class Costs>
OrderMove OrderMoves<Costs>::bestMoveAt(int position) const
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

template <class Costs>
void OrderMoves<Costs>::apply(const OrderMove& move)
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

template class OrderMoves<VisitCosts>;
template class OrderMoves<LatencyCosts>;

VisitOrder sigmaOrder(const TvpProblem& problem)
{
    VisitOrder order = ascendingOrder(problem.icebergCount());
    std::sort(order.begin(), order.end(), [&problem](NodeIndex a, NodeIndex b) {
        const double sigmaA = problem.sigma_m2[toIndex(a)];
        const double sigmaB = problem.sigma_m2[toIndex(b)];
        return std::tuple(-sigmaA, legBetween(problem.distance_m, 0, a), a) <
               std::tuple(-sigmaB, legBetween(problem.distance_m, 0, b), b);
    });
    return order;
}

} // namespace berg
