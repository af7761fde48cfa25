#include "core/plan/problem/formulation.h"

#include <cstddef>
#include <optional>

namespace berg {

namespace {

/** Returns the unsigned index of a node, position or column number. */
std::size_t at(int number)
{
    return static_cast<std::size_t>(number);
}

std::string label(const char* symbol, std::initializer_list<int> indices)
{
    std::string text = symbol;
    for (const int index : indices)
        text += '_' + std::to_string(index);
    return text;
}

MilpModel emptyModel(const TvpProblem& problem)
{
    require(problem.icebergCount() >= 1, "formulation: a problem without icebergs has no MILP");
    MilpModel model;
    // F = -sum sigma_i (N - t_i) + mu D = -N sum(sigma) + sum sigma_i t_i + mu D
    model.objectiveOffset = -objectiveShift(problem);
    model.route = problem.route;
    model.nodeCount = problem.nodeCount();
    return model;
}

// ---- as printed ------------------------------------------------------------------------------

/** Returns the column of y(from, to). */
int printedArc(int nodes, int from, int to)
{
    return from * nodes + to;
}

/** Returns the column of t(node). */
int printedOrder(int nodes, int node)
{
    return nodes * nodes + node;
}

void addPrintedColumns(const TvpProblem& problem, MilpModel& model)
{
    const int nodes = problem.nodeCount();
    for (int i = 0; i < nodes; ++i)
        for (int j = 0; j < nodes; ++j) {
            const bool selfLoop = i == j;
            model.arcs.push_back({.from = NodeIndex::of(i), .to = NodeIndex::of(j)});
            model.columns.push_back(
                {.name = label("y", {i, j}),
                 .upper = selfLoop ? 0.0 : 1.0,
                 .objective = selfLoop ? 0.0 : problem.mu * problem.distance_m(i, j)});
        }
    model.hasOrderColumns = true;
    for (int i = 0; i < nodes; ++i)
        model.columns.push_back({.name = label("t", {i}),
                                 .lower = 1, // Eq. (8); Eq. (6) for the UAV
                                 .upper = i == 0 ? 1.0 : static_cast<double>(nodes),
                                 .objective = problem.sigma_m2[at(i)],
                                 .integer = false});
}

void addPrintedDegrees(MilpModel& model)
{
    const int nodes = model.nodeCount;
    const double lower = model.route == Route::Closed ? 1.0 : -kMilpInfinity;
    for (const bool into : {true, false}) // Eq. (3), then Eq. (4)
        for (int i = 0; i < nodes; ++i) {
            MilpRow row{
                .name = label(into ? "into" : "out", {i}), .lower = lower, .upper = 1, .terms = {}};
            for (int j = 0; j < nodes; ++j)
                row.terms.push_back({into ? printedArc(nodes, j, i) : printedArc(nodes, i, j), 1});
            model.rows.push_back(std::move(row));
        }
    if (model.route == Route::Closed)
        return;
    MilpRow row{.name = "arcs", .lower = nodes - 1.0, .upper = nodes - 1.0, .terms = {}}; // Eq. (5)
    for (int c = 0; c < nodes * nodes; ++c)
        row.terms.push_back({c, 1});
    model.rows.push_back(std::move(row));
}

/** Adds the corrected Eq. (9): t_j - t_i - N y_ij >= 1 - N. */
void addPrintedSequence(MilpModel& model)
{
    const int nodes = model.nodeCount;
    const int firstTo = model.route == Route::Closed ? 1 : 0;
    for (int i = 0; i < nodes; ++i)
        for (int j = firstTo; j < nodes; ++j)
            if (i != j)
                model.rows.push_back({.name = label("seq", {i, j}),
                                      .lower = 1.0 - nodes,
                                      .terms = {{printedArc(nodes, i, j), -1.0 * nodes},
                                                {printedOrder(nodes, i), -1},
                                                {printedOrder(nodes, j), 1}}});
}

// ---- position-indexed ------------------------------------------------------------------------

void addPositionColumns(const TvpProblem& problem, MilpModel& model)
{
    for (const MilpArc& arc : model.arcs) {
        double distance_m = legBetween(problem.distance_m, arc.from, arc.to);
        if (problem.route == Route::Closed && arc.position == problem.icebergCount())
            distance_m += legBetween(problem.distance_m, arc.to, 0);
        model.columns.push_back(
            {.name = label("z", {arc.from.number(), arc.to.number(), *arc.position}),
             .objective = problem.mu * distance_m +
                          problem.sigma_m2[toIndex(arc.to)] * (*arc.position + 1)});
    }
}

/**
 * Adds rows by which each iceberg is visited, one unit leaves the UAV, and flow that enters iceberg
 * j at position k leaves it from there. Rows without a column are left out.
 */
void addPositionRows(MilpModel& model)
{
    const int icebergs = model.nodeCount - 1;
    std::vector<MilpRow> visits;
    for (int j = 1; j <= icebergs; ++j)
        visits.push_back({.name = label("visit", {j}), .lower = 1, .upper = 1, .terms = {}});
    MilpRow start{.name = "start", .lower = 1, .upper = 1, .terms = {}};
    std::vector<MilpRow> flows; // (j, k), k = 2..n
    for (int k = 2; k <= icebergs; ++k)
        for (int j = 1; j <= icebergs; ++j)
            flows.push_back({.name = label("flow", {j, k}), .lower = 0, .upper = 0, .terms = {}});
    const auto flow = [&](NodeIndex j, int k) -> MilpRow& {
        return flows[at((k - 2) * icebergs + j.number() - 1)];
    };

    for (int c = 0; c < static_cast<int>(model.arcs.size()); ++c) {
        const MilpArc& arc = model.arcs[at(c)];
        visits[toIndex(arc.to) - 1].terms.push_back({c, 1});
        MilpRow& source = arc.position == 1 ? start : flow(arc.from, *arc.position);
        source.terms.push_back({c, arc.position == 1 ? 1.0 : -1.0});
        if (*arc.position < icebergs)
            flow(arc.to, *arc.position + 1).terms.push_back({c, 1});
    }
    visits.push_back(std::move(start));
    for (std::vector<MilpRow>* rows : {&visits, &flows})
        for (MilpRow& row : *rows)
            if (!row.terms.empty())
                model.rows.push_back(std::move(row));
}

} // namespace

MilpModel printedModel(const TvpProblem& problem)
{
    MilpModel model = emptyModel(problem);
    addPrintedColumns(problem, model);
    addPrintedDegrees(model);
    addPrintedSequence(model);
    return model;
}

std::vector<MilpArc> allPositionArcs(int icebergs)
{
    std::vector<MilpArc> arcs;
    for (const NodeIndex j : icebergNodes(icebergs))
        arcs.push_back({.from = 0, .to = j, .position = 1});
    for (int k = 2; k <= icebergs; ++k)
        for (const NodeIndex i : icebergNodes(icebergs))
            for (const NodeIndex j : icebergNodes(icebergs))
                if (i != j)
                    arcs.push_back({.from = i, .to = j, .position = k});
    return arcs;
}

MilpModel positionModel(const TvpProblem& problem)
{
    return positionModel(problem, allPositionArcs(problem.icebergCount()));
}

MilpModel positionModel(const TvpProblem& problem, std::vector<MilpArc> arcs)
{
    MilpModel model = emptyModel(problem);
    model.arcs = std::move(arcs);
    addPositionColumns(problem, model);
    addPositionRows(model);
    return model;
}

VisitOrder decode(const MilpModel& model, std::span<const double> solution)
{
    require(solution.size() == model.columns.size(), "decode: one value per column expected");
    VisitOrder next(at(model.nodeCount));
    for (std::size_t c = 0; c < model.arcs.size(); ++c)
        if (solution[c] > 0.5)
            next[toIndex(model.arcs[c].from)] = model.arcs[c].to;

    VisitOrder order;
    std::vector<bool> seen(at(model.nodeCount), false);
    for (NodeIndex node = next[0]; node != 0 && !seen[toIndex(node)]; node = next[toIndex(node)]) {
        seen[toIndex(node)] = true;
        order.push_back(node);
    }
    return static_cast<int>(order.size()) == model.nodeCount - 1 ? order : VisitOrder{};
}

std::vector<double> encode(const MilpModel& model, std::span<const NodeIndex> order)
{
    require(static_cast<int>(order.size()) == model.nodeCount - 1,
            "encode: a visiting order of all icebergs expected");
    std::vector<std::optional<NodeIndex>> next(at(model.nodeCount));
    std::vector<int> position(at(model.nodeCount), 1);
    NodeIndex from;
    for (const NodeIndex to : order) {
        next[toIndex(from)] = to;
        position[toIndex(to)] = position[toIndex(from)] + 1;
        from = to;
    }
    // Only the printed model has an arc back to the UAV.
    next[toIndex(from)] = model.route == Route::Closed ? std::optional(NodeIndex()) : std::nullopt;

    std::vector<double> solution(model.columns.size(), 0.0);
    for (std::size_t c = 0; c < model.arcs.size(); ++c) {
        const MilpArc& arc = model.arcs[c];
        const bool flown = next[toIndex(arc.from)] == arc.to;
        if (flown && (!arc.position || arc.position == position[toIndex(arc.from)]))
            solution[c] = 1;
    }
    if (model.hasOrderColumns)
        for (int node = 0; node < model.nodeCount; ++node)
            solution[model.arcs.size() + at(node)] = position[at(node)];
    return solution;
}

} // namespace berg
