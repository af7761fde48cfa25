#pragma once

#include "core/plan/solve/tvp.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace berg {

inline constexpr double kMilpInfinity = std::numeric_limits<double>::infinity();

/** A variable of a MILP: a binary one unless told otherwise. */
struct MilpColumn
{
    std::string name;
    double lower = 0;
    double upper = 1;
    double objective = 0;
    bool integer = true;
    bool operator==(const MilpColumn&) const = default;
};

struct MilpTerm
{
    int column = 0;
    double coefficient = 0;
    bool operator==(const MilpTerm&) const = default;
};

/** lower <= sum of the terms <= upper; each column at most once. */
struct MilpRow
{
    std::string name;
    double lower = -kMilpInfinity;
    double upper = kMilpInfinity;
    std::vector<MilpTerm> terms;
    bool operator==(const MilpRow&) const = default;
};

/** What an arc column says when it is 1: fly from node `from` to node `to`. */
struct MilpArc
{
    int from = 0;
    int to = 0;
    int position = 0; ///< position left by the arc, 1 = UAV; 0 where the formulation has none
    bool operator==(const MilpArc&) const = default;
};

/**
 * Mixed-integer linear programme of a target visitation problem as plain data: minimise
 * `objectiveOffset` + sum of objective x column over columns within their bounds and rows. At
 * every integer point the objective is F of Eq. (1) of the visiting order that `decode` gives.
 */
struct MilpModel
{
    std::vector<MilpColumn> columns;
    std::vector<MilpRow> rows;
    double objectiveOffset = 0;
    std::vector<MilpArc> arcs;    ///< `arcs[c]` belongs to `columns[c]`; arcs are the first columns
    bool hasOrderColumns = false; ///< behind the arcs one column t(i) for each node
    Route route = Route::Open;
    int nodeCount = 0;
};

/**
 * The MILP as printed, Eq. (1)-(9): y(i,j) for all N^2 arcs and t(i), of which t may be continuous.
 *
 * Eq. (9) is printed with t_{i+1}; only t_j - (t_i + 1) >= -N (1 - y_ij) removes subtours, so
 * that is what the rows say. y_ii = 0 is added: the paper leaves it out, and a self-loop would then
 * replace an arc of the path at no cost. Eq. (7), t_i != t_j, follows from the rest: the arcs form
 * one path along which t grows by at least 1, and Eq. (8) leaves it the values 1..N. Closed route:
 * (3)-(4) are equalities, (5) is dropped and (9) does not hold for arcs back to the UAV.
 * `problem` must be valid (`validate`) and hold at least one iceberg, as for `positionModel`.
 */
[[nodiscard]] MilpModel printedModel(const TvpProblem& problem);

/**
 * Position-indexed MILP (Picard and Queyranne 1978): z(i,j,k) = 1 when the arc i -> j leaves
 * position k and so reaches j with t = k + 1; a network flow through the layers 1..N with one visit
 * to each iceberg. About n^3 binary columns for n icebergs, and a much tighter relaxation than the
 * printed model. A closed route pays its return leg on the arc into the last position.
 */
[[nodiscard]] MilpModel positionModel(const TvpProblem& problem);

/** The arcs of that model: by position, from, to. */
[[nodiscard]] std::vector<MilpArc> allPositionArcs(int icebergs);

/** The same with the columns of these arcs only, which must hold at least one order. */
[[nodiscard]] MilpModel positionModel(const TvpProblem& problem, std::vector<MilpArc> arcs);

/** Visiting order of a solution (one value per column); empty when its arcs do not form one. */
[[nodiscard]] VisitOrder decode(const MilpModel& model, std::span<const double> solution);

/** The solution (one value per column) of a visiting order: each iceberg node exactly once. */
[[nodiscard]] std::vector<double> encode(const MilpModel& model, std::span<const int> order);

} // namespace berg
