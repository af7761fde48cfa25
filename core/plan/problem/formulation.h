#pragma once

#include "core/plan/problem/tvp.h"

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Value of a missing bound of a column or row. */
inline constexpr double kMilpInfinity = std::numeric_limits<double>::infinity();

/** A variable of a MILP, binary by default. */
struct MilpColumn
{
    std::string name;
    double lower = 0;
    double upper = 1;
    double objective = 0;
    bool integer = true;
    bool operator==(const MilpColumn&) const = default;
};

/** One term of a row. */
struct MilpTerm
{
    int column = 0;
    double coefficient = 0;
    bool operator==(const MilpTerm&) const = default;
};

/** A constraint: lower <= sum of the terms <= upper; each column occurs at most once. */
struct MilpRow
{
    std::string name;
    double lower = -kMilpInfinity;
    double upper = kMilpInfinity;
    std::vector<MilpTerm> terms;
    bool operator==(const MilpRow&) const = default;
};

/** Meaning of an arc column: if it is 1, the UAV flies from node `from` to node `to`. */
struct MilpArc
{
    NodeIndex from;
    NodeIndex to;
    /** Position that the arc leaves, 1 = UAV; nullopt if the formulation has none. */
    std::optional<int> position = {};
    bool operator==(const MilpArc&) const = default;
};

/**
 * Mixed-integer linear programme of a target visitation problem as plain data: minimise
 * `objectiveOffset` + sum of objective x column over columns within their bounds and rows. At every
 * integer point the objective is F of Eq. (1) of the visiting order that `decode` returns.
 */
struct MilpModel
{
    std::vector<MilpColumn> columns;
    std::vector<MilpRow> rows;
    double objectiveOffset = 0;
    std::vector<MilpArc> arcs;    ///< `arcs[c]` belongs to `columns[c]`; arcs are the first columns
    bool hasOrderColumns = false; ///< whether a column t(i) for each node follows the arcs
    Route route = Route::Open;
    int nodeCount = 0;
};

/**
 * Returns the MILP as printed, Eq. (1)-(9): y(i,j) for all N^2 arcs and t(i), of which t may be
 * continuous.
 *
 * Eq. (9) is printed with t_{i+1}; only t_j - (t_i + 1) >= -N (1 - y_ij) removes subtours, so the
 * rows use that. y_ii = 0 is added: the paper leaves it out, and a self-loop would then replace an
 * arc of the path at no cost. Eq. (7), t_i != t_j, follows from the rest: the arcs form one path
 * along which t grows by at least 1, and Eq. (8) leaves it the values 1..N. Closed route: (3)-(4)
 * are equalities, (5) is dropped and (9) does not hold for arcs back to the UAV. `problem` must be
 * valid (`validate`) and hold at least one iceberg (else `std::logic_error`), as for
 * `positionModel`.
 */
[[nodiscard]] MilpModel printedModel(const TvpProblem& problem);

/**
 * Returns the position-indexed MILP (Picard and Queyranne 1978): z(i,j,k) = 1 if the arc i -> j
 * leaves position k and so reaches j with t = k + 1; a network flow through the layers 1..N with
 * one visit to each iceberg. It has about n^3 binary columns for n icebergs, and a much tighter
 * relaxation than the printed model. A closed route pays its return leg on the arc into the last
 * position.
 */
[[nodiscard]] MilpModel positionModel(const TvpProblem& problem);

/**
 * Returns all arcs of the position-indexed MILP, sorted by position, from, to; return legs are not
 * arcs.
 */
[[nodiscard]] std::vector<MilpArc> allPositionArcs(int icebergs);

/**
 * Returns the position-indexed MILP with columns for these arcs only, which must allow at least one
 * order.
 */
[[nodiscard]] MilpModel positionModel(const TvpProblem& problem, std::vector<MilpArc> arcs);

/**
 * Returns the visiting order of a solution, or an empty order if its arcs do not form one. Throws
 * `std::logic_error` unless there is one value per column.
 */
[[nodiscard]] VisitOrder decode(const MilpModel& model, std::span<const double> solution);

/**
 * Returns the solution (one value per column) of a visiting order with each iceberg node exactly
 * once, whose arcs the model must hold. Throws `std::logic_error` if the order has another length.
 */
[[nodiscard]] std::vector<double> encode(const MilpModel& model, std::span<const NodeIndex> order);

} // namespace berg
