#pragma once

#include "core/plan/problem/order_costs.h"

#include <array>
#include <span>
#include <vector>

namespace berg {

/** A change of an order; positions count from 1. `delta` is the change of the cost. */
struct OrderMove
{
    /** Kind of a move: reverse a piece, exchange two icebergs, relocate a piece. */
    enum class Kind
    {
        None,
        Reverse,
        Exchange,
        Relocate
    };
    Kind kind = Kind::None;
    int first = 0; ///< first position of the piece (Exchange: one of the two)
    int last = 0;  ///< last position of the piece (Exchange: the other one)
    int after = 0; ///< Relocate: the piece goes behind this position, which is outside the piece
    bool turned = false; ///< Relocate: the piece is reversed
    double delta = 0;
};

/** Sums along an order up to position p, from which moves are evaluated. */
template <class Costs>
struct OrderSums;

template <>
struct OrderSums<VisitCosts>
{
    double forward = 0;  ///< legs 0 -> 1 -> .. -> p
    double backward = 0; ///< the same legs flown backwards
    double sigma = 0;    ///< sum of sigma up to p
    double moment = 0;   ///< sum of sigma times position up to p
};

template <>
struct OrderSums<LatencyCosts>
{
    double forward = 0;      ///< legs 0 -> 1 -> .. -> p
    double backward = 0;     ///< the same legs flown backwards
    double sigma = 0;        ///< sum of sigma up to p
    double forwardSeen = 0;  ///< sum of leg times the sigma of the positions before it
    double backwardSeen = 0; ///< that sum with the legs flown backwards
};

/**
 * An order with prefix sums along it, from which every move is evaluated in O(1), also with
 * asymmetric distances. Making a move costs O(n).
 */
template <class Costs>
class OrderMoves
{
public:
    /** `order` must hold each iceberg once. `costs` must outlive the object. */
    OrderMoves(const Costs& costs, std::span<const NodeIndex> order);

    [[nodiscard]] int icebergs() const { return m_costs.icebergs; }
    /**
     * Returns the node at position 0 (the UAV) .. n, and 0 again at n + 1 (the end of the route).
     */
    [[nodiscard]] NodeIndex at(int position) const
    {
        return m_node[static_cast<std::size_t>(position)];
    }
    [[nodiscard]] int positionOf(NodeIndex node) const { return m_position[toIndex(node)]; }
    [[nodiscard]] VisitOrder order() const;
    /** Replaces the order by one that holds each iceberg once. */
    void assign(std::span<const NodeIndex> order);
    /** Returns the cost of the whole order, equal to `Costs::total` up to rounding. */
    [[nodiscard]] double cost() const;
    /**
     * Returns the largest change of cost, up or down, that may be rounding alone: the sums may be
     * far larger than the cost.
     */
    [[nodiscard]] double rounding() const;

    /** Returns the change of cost if positions first .. last are flown backwards; first < last. */
    [[nodiscard]] double reversal(int first, int last) const;
    /** Returns the change of cost if the icebergs at two positions change places; a < b. */
    [[nodiscard]] double exchange(int a, int b) const;
    /** Returns the change of cost of a relocation; `after` < first - 1 or > last. */
    [[nodiscard]] double relocation(int first, int last, int after, bool turned) const;

    /**
     * Returns the best move that lowers the cost and has the iceberg at `position` as an end of a
     * piece or as partner; its kind is None if no move lowers the cost.
     */
    [[nodiscard]] OrderMove bestMoveAt(int position) const;

    /** Makes the move; does nothing for the kind None. */
    void apply(const OrderMove& move);

private:
    using Sums = OrderSums<Costs>;
    [[nodiscard]] const Sums& sums(int position) const
    {
        return m_sums[static_cast<std::size_t>(position)];
    }
    /** Positions first .. last as a piece of another order. */
    struct Piece
    {
        int first = 0;
        int last = 0;
        bool turned = false;
    };
    /** Returns the change of cost if a stretch is assembled from its pieces in another order. */
    template <std::size_t Count>
    [[nodiscard]] double rearrangement(const std::array<Piece, Count>& pieces) const
        requires(Costs::kWeighted);
    [[nodiscard]] Sums next(const Sums& last, int position) const;
    void refresh(int firstChanged);

    const Costs& m_costs;
    VisitOrder m_node;           ///< n + 2
    std::vector<int> m_position; ///< N, by node
    std::vector<Sums> m_sums;    ///< n + 2
};

/**
 * Returns the order by largest sigma, then least distance from the UAV, then smallest number: the
 * optimum at mu = 0.
 */
[[nodiscard]] VisitOrder sigmaOrder(const TvpProblem& problem);

} // namespace berg
