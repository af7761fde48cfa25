#pragma once

#include "core/plan/solve/order_costs.h"

#include <array>
#include <span>
#include <vector>

namespace berg {

/** A change of an order: positions count from 1. `delta` is what it adds to the cost. */
struct OrderMove
{
    enum class Kind
    {
        None,
        Reverse,
        Exchange,
        Relocate
    };
    Kind kind = Kind::None;
    int first = 0;       ///< first position of the piece (Exchange: one of the two)
    int last = 0;        ///< last position of the piece (Exchange: the other one)
    int after = 0;       ///< Relocate: goes behind this position, outside the piece
    bool turned = false; ///< Relocate: flown the other way round
    double delta = 0;
};

/** Sums along an order up to position p, by which moves are valued. */
template <class Costs>
struct OrderSums;

template <>
struct OrderSums<VisitCosts>
{
    double forward = 0;  ///< legs 0 -> 1 -> .. -> p
    double backward = 0; ///< the same legs flown the other way
    double sigma = 0;    ///< sum of sigma up to p
    double moment = 0;   ///< sum of sigma times position up to p
};

template <>
struct OrderSums<LatencyCosts>
{
    double forward = 0;      ///< legs 0 -> 1 -> .. -> p
    double backward = 0;     ///< the same legs flown the other way
    double sigma = 0;        ///< sum of sigma up to p
    double forwardSeen = 0;  ///< sum of leg times the sigma of the positions before it
    double backwardSeen = 0; ///< the same with the legs flown the other way
};

/**
 * An order with prefix sums along it, by which every move is valued in O(1), asymmetric distances
 * included. Making a move costs O(n).
 */
template <class Costs>
class OrderMoves
{
public:
    /** Keeps a reference to `costs`. */
    OrderMoves(const Costs& costs, std::span<const int> order);

    [[nodiscard]] int icebergs() const { return m_costs.icebergs; }
    /** Node at position 0 (the UAV) .. n, and 0 again at n + 1 (the end of the route). */
    [[nodiscard]] int at(int position) const { return m_node[static_cast<std::size_t>(position)]; }
    [[nodiscard]] int positionOf(int node) const
    {
        return m_position[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] VisitOrder order() const;
    void assign(std::span<const int> order);
    /** Cost of the whole order, as `Costs::total` up to rounding. */
    [[nodiscard]] double cost() const;
    /** A change of cost that is less, either way, may be rounding alone: the sums may be far larger
     * than the cost. */
    [[nodiscard]] double rounding() const;

    /** Change of cost when positions first .. last are flown backwards; first < last. */
    [[nodiscard]] double reversal(int first, int last) const;
    /** Change of cost when the icebergs at two positions change places; a < b. */
    [[nodiscard]] double exchange(int a, int b) const;
    /** Change of cost of a relocation; `after` < first - 1 or > last. */
    [[nodiscard]] double relocation(int first, int last, int after, bool turned) const;

    /** The best move that takes the iceberg at `position` as end of a piece or as partner. */
    [[nodiscard]] OrderMove bestMoveAt(int position) const;

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
    /** Change of cost when a stretch is put together anew from its pieces. */
    template <std::size_t Count>
    [[nodiscard]] double rearrangement(const std::array<Piece, Count>& pieces) const
        requires(Costs::kWeighted);
    [[nodiscard]] Sums next(const Sums& last, int position) const;
    void refresh(int firstChanged);

    const Costs& m_costs;
    std::vector<int> m_node;     ///< n + 2
    std::vector<int> m_position; ///< N, by node
    std::vector<Sums> m_sums;    ///< n + 2
};

/** Largest sigma first, then nearest to the UAV, then smallest number: the optimum at mu = 0. */
[[nodiscard]] VisitOrder sigmaOrder(const TvpProblem& problem);

} // namespace berg
