#pragma once

#include "core/plan/tvp.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace berg {

/**
 * Eq. (1) plus the constant N sum(sigma), laid out for inner loops: a leg from i to j flown into
 * position p (1 for the first iceberg, so t = p + 1) costs mu d(i,j) + sigma_j (p + 1) >= 0.
 */
struct VisitCosts
{
    explicit VisitCosts(const TvpProblem& problem);

    [[nodiscard]] double leg(int from, int to) const { return legs(to, from); }
    [[nodiscard]] double visit(int node, int position) const
    {
        return sigma[static_cast<std::size_t>(node)] * (position + 1);
    }
    /** Sum of an order's costs: `objective` + `objectiveShift`. */
    [[nodiscard]] double total(std::span<const int> order) const;

    int icebergs = 0;
    Eigen::MatrixXd legs;      ///< N x N, column = from, row = to, mu d; row 0 is the end of the
                               ///< route: 0 when open, the way back when closed
    std::vector<double> sigma; ///< N, m^2
};

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

/**
 * An order with prefix sums along it (legs both ways, sigma, sigma times position), by which every
 * move is valued in O(1), asymmetric distances included. Making a move costs O(n).
 */
class OrderMoves
{
public:
    /** Keeps a reference to `costs`. */
    OrderMoves(const VisitCosts& costs, std::span<const int> order);

    [[nodiscard]] int icebergs() const { return m_costs.icebergs; }
    /** Node at position 0 (the UAV) .. n, and 0 again at n + 1 (the end of the route). */
    [[nodiscard]] int at(int position) const { return m_node[static_cast<std::size_t>(position)]; }
    [[nodiscard]] int positionOf(int node) const
    {
        return m_position[static_cast<std::size_t>(node)];
    }
    [[nodiscard]] VisitOrder order() const;
    void assign(std::span<const int> order);
    /** Cost of the whole order, as `VisitCosts::total` up to rounding. */
    [[nodiscard]] double cost() const;

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
    struct Prefix
    {
        double forward = 0;  ///< legs 0 -> 1 -> .. -> p
        double backward = 0; ///< the same legs flown the other way
        double sigma = 0;    ///< sum of sigma up to p
        double moment = 0;   ///< sum of sigma times position up to p
    };
    [[nodiscard]] const Prefix& sums(int position) const
    {
        return m_sums[static_cast<std::size_t>(position)];
    }
    void refresh(int firstChanged);

    const VisitCosts& m_costs;
    std::vector<int> m_node;     ///< n + 2
    std::vector<int> m_position; ///< N, by node
    std::vector<Prefix> m_sums;  ///< n + 2
};

/** Largest sigma first, then nearest to the UAV, then smallest number: the optimum at mu = 0. */
[[nodiscard]] VisitOrder sigmaOrder(const TvpProblem& problem);

} // namespace berg
