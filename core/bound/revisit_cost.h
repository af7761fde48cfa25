#pragma once

#include <span>
#include <vector>

namespace berg {

/** Cells of time, and the multipliers of having one iceberg in view in each of them. */
struct ViewPrices
{
    std::span<const double> edges_s;   ///< Edges of the cells, ascending from 0.
    std::span<const double> visit_m2s; ///< Cost of the beginning of a stay in view, for each cell.
    std::span<const double> stay_m2ps; ///< Cost of each second of a stay, for each cell.
};

/** Growth of sigma of one iceberg in the simple model. */
struct SigmaGrowth
{
    double q_m2ps = 0;        ///< Growth of sigma; it must be positive.
    double atStart_m2 = 0;    ///< Sigma when the iceberg begins to count.
    int startCell = 0;        ///< The iceberg counts from the first edge of this cell on.
    bool mayBeInView = false; ///< A stay may have begun before the iceberg counts.
};

/**
 * Returns, for each edge of the cells, a lower bound in m2 s on the integral of sigma plus the
 * costs of all stays in view up to the edge, whatever the stays are. The bound is 0 up to the edge
 * at which the iceberg begins to count. All costs must be non-negative.
 *
 * Proof. Sigma grows by q a second when the iceberg is out of view and is 0 in view, so that a gap
 * of length g between two stays costs q g^2 / 2, the first one besides g times the sigma at the
 * start. With c = q x (usual gap), W(t) = (least cost of all that ends with an instant t in view)
 * - c t changes in a gap by q g^2 / 2 - c g, which is flat about the usual gap. So a bound on W in
 * each cell by dynamic programming over the cell of the instant before, with the best gap that the
 * two cells allow, loses little to the width of the cells. Within one cell W falls by c times its
 * width at most, less what a visit or the stay costs meanwhile.
 */
[[nodiscard]] std::vector<double> revisitCosts_m2s(const ViewPrices& prices,
                                                   const SigmaGrowth& growth);

} // namespace berg
