#include "core/bound/revisit_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

constexpr double kNoCost = std::numeric_limits<double>::infinity();

class RevisitTable
{
public:
    RevisitTable(const ViewPrices& prices, const SigmaGrowth& growth)
        : m_prices(prices)
        , m_growth(growth)
        , m_cells(prices.visit_m2s.size())
        , m_start(static_cast<std::size_t>(growth.startCell))
        , m_start_s(prices.edges_s[m_start])
        , m_inView(m_cells, kNoCost)
        , m_leastBefore(m_cells + 1, kNoCost)
        , m_stay(m_cells + 1, kNoCost)
    {
        double visit_m2s = 0;
        for (std::size_t k = m_start; k < m_cells; ++k)
            visit_m2s += prices.visit_m2s[k] * width_s(k);
        const double rest_s = prices.edges_s[m_cells] - m_start_s;
        if (rest_s > 0)
            m_usual_s = std::sqrt(2 * visit_m2s / rest_s / growth.q_m2ps);
    }

    std::vector<double> costs_m2s()
    {
        std::vector<double> costs_m2s(m_cells + 1, 0.0);
        if (m_growth.mayBeInView)
            m_stay[m_start] = 0;
        for (std::size_t cell = m_start; cell < m_cells; ++cell) {
            pass(cell);
            costs_m2s[cell + 1] = std::max(0.0, costUntil_m2s(cell + 1));
        }
        return costs_m2s;
    }

private:
    [[nodiscard]] double edge_s(std::size_t k) const { return m_prices.edges_s[k]; }
    [[nodiscard]] double width_s(std::size_t cell) const { return edge_s(cell + 1) - edge_s(cell); }
    [[nodiscard]] double slope_m2() const { return m_growth.q_m2ps * m_usual_s; }

    /** Returns the least change of W in a gap within these limits. */
    [[nodiscard]] double gap_m2s(double least_s, double most_s) const
    {
        const double gap_s = std::clamp(m_usual_s, std::max(0.0, least_s), most_s);
        return m_growth.q_m2ps * gap_s * (gap_s / 2 - m_usual_s);
    }
    /** Returns the least change of W in the gap from the start, within these limits. */
    [[nodiscard]] double firstGap_m2s(double least_s, double most_s) const
    {
        const double best_s = m_usual_s - m_growth.atStart_m2 / m_growth.q_m2ps;
        const double gap_s = std::clamp(best_s, least_s, most_s);
        return m_growth.q_m2ps * gap_s * (gap_s / 2 - best_s);
    }

    /**
     * Returns the least W after a gap that ends between two instants and begins in a cell before
     * `end`.
     */
    [[nodiscard]] double afterGap_m2s(std::size_t end, double from_s, double to_s) const
    {
        double least_m2s = firstGap_m2s(from_s - m_start_s, to_s - m_start_s);
        for (std::size_t cell = end; cell-- > m_start;) {
            const double shortest_s = from_s - edge_s(cell + 1);
            if (shortest_s > m_usual_s && // Longer gaps cost more from here on.
                m_leastBefore[cell + 1] + gap_m2s(shortest_s, shortest_s) >= least_m2s)
                break;
            least_m2s =
                std::min(least_m2s, m_inView[cell] + gap_m2s(shortest_s, to_s - edge_s(cell)));
        }
        return least_m2s;
    }

    /** Updates the least costs at the end of the cell. */
    void pass(std::size_t cell)
    {
        const double width_s = this->width_s(cell);
        const double visit_m2s = m_prices.visit_m2s[cell];
        const double through_m2s = (m_prices.stay_m2ps[cell] - slope_m2()) * width_s;
        // The UAV may come back within the cell.
        const double again_m2s = visit_m2s - slope_m2() * width_s;
        const double within_m2s = std::min({0.0, through_m2s, again_m2s});
        const double arrived_m2s = afterGap_m2s(cell, edge_s(cell), edge_s(cell + 1)) + visit_m2s;
        m_inView[cell] = std::min(arrived_m2s, m_stay[cell]) + within_m2s;
        m_stay[cell + 1] =
            std::min(m_stay[cell] + std::min(through_m2s, again_m2s), arrived_m2s + within_m2s);
        m_leastBefore[cell + 1] = std::min(m_leastBefore[cell], m_inView[cell]);
    }

    [[nodiscard]] double costUntil_m2s(std::size_t edge) const
    {
        const double end_s = edge_s(edge);
        return std::min(afterGap_m2s(edge, end_s, end_s), m_stay[edge]) +
               slope_m2() * (end_s - m_start_s);
    }

    const ViewPrices& m_prices;
    const SigmaGrowth& m_growth;
    std::size_t m_cells;
    std::size_t m_start;
    double m_start_s;
    double m_usual_s = 0;              ///< Gap about which W is flat.
    std::vector<double> m_inView;      ///< Bound on W at the last instant in view, for each cell.
    std::vector<double> m_leastBefore; ///< Least of `m_inView` in all cells before each edge.
    std::vector<double> m_stay; ///< Bound on W in a stay that lasts over the edge, for each edge.
};

} // namespace

std::vector<double> revisitCosts_m2s(const ViewPrices& prices, const SigmaGrowth& growth)
{
    return RevisitTable(prices, growth).costs_m2s();
}

} // namespace berg
