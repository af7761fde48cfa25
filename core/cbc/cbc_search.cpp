#include "core/cbc/cbc_search.h"

#include "core/cbc/cbc_coin.h"
#include "core/cbc/cbc_run.h"
#include "core/plan/problem/milp_relaxation.h"
#include "core/plan/solve/reduced_model.h"

#include <CbcEventHandler.hpp>
#include <CbcHeuristic.hpp>
#include <CbcModel.hpp>
#include <CglCutGenerator.hpp>
#include <CoinError.hpp>
#include <CoinPackedMatrix.hpp>
#include <OsiCuts.hpp>
#include <OsiRowCut.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace berg {

namespace {

/** Largest node limit; CbcModel takes some higher values for debugging switches. */
constexpr std::int64_t kLargestNodeLimit = 900'000'000;

double coinBound(double value)
{
    return std::isinf(value) ? std::copysign(COIN_DBL_MAX, value) : value;
}

void harvestFrom(CbcRun& run, const CbcModel& model)
{
    if (model.bestSolution() != nullptr)
        run.harvest({model.bestSolution(), run.milp().columns.size()});
}

/** Passes on incumbents, bound and stop of the search tree. */
class SearchWatcher final : public CbcEventHandler
{
public:
    using CbcEventHandler::event;
    explicit SearchWatcher(CbcRun& run) : m_run(&run) {}
    [[nodiscard]] CbcEventHandler* clone() const override { return new SearchWatcher(*this); }
    CbcAction event(CbcEvent which) override
    {
        const bool stopping = m_run->mustStop();
        // CBC's heuristics search models of their own with a copy of this handler.
        if (m_run->isMain(model_)) {
            // Only in this event the bound covers all open nodes.
            if (which == treeStatus && !stopping)
                m_run->raiseBound(model_->getBestPossibleObjValue());
            m_run->guard([this] {
                harvestFrom(*m_run, *model_);
                m_run->reportAtIntervals();
            });
        }
        return stopping ? stop : noAction;
    }

private:
    CbcRun* m_run;
};

/**
 * Separates the cuts of `AdmissibleFlow` for CBC. They close most of the gap of the
 * position-indexed relaxation; with them Probing, Gomory, MIR, clique and zero-half cuts cost more
 * time than they save.
 */
class AdmissibleFlowCuts final : public CglCutGenerator
{
public:
    AdmissibleFlowCuts(CbcRun& run, const AdmissibleFlow& flow) : m_run(&run), m_flow(&flow) {}
    [[nodiscard]] CglCutGenerator* clone() const override { return new AdmissibleFlowCuts(*this); }
    void generateCuts(const OsiSolverInterface& solver, OsiCuts& cuts, const CglTreeInfo) override
    {
        const std::size_t columns = m_run->milp().columns.size();
        if (solver.getNumCols() != static_cast<int>(columns))
            return; // a smaller model of one of CBC's heuristics
        constexpr double kLeastViolation = 1e-3;
        m_run->guard([&] {
            const std::span<const double> relaxed{solver.getColSolution(), columns};
            for (const MilpRow& row : m_flow->violated(relaxed, kLeastViolation))
                cuts.insert(cutOf(row));
        });
    }

private:
    static OsiRowCut cutOf(const MilpRow& row)
    {
        std::vector<int> columns;
        std::vector<double> coefficients;
        for (const MilpTerm& term : row.terms) {
            columns.push_back(term.column);
            coefficients.push_back(term.coefficient);
        }
        OsiRowCut cut;
        cut.setRow(static_cast<int>(columns.size()), columns.data(), coefficients.data(), false);
        cut.setLb(coinBound(row.lower));
        cut.setUb(coinBound(row.upper));
        cut.setGloballyValid(true);
        return cut;
    }

    CbcRun* m_run;
    const AdmissibleFlow* m_flow;
};

/** Applies `roundRelaxation` for CBC, which gives an incumbent from every relaxation. */
class RelaxationRounding final : public CbcHeuristic
{
public:
    RelaxationRounding(CbcModel& model, CbcRun& run) : CbcHeuristic(model), m_run(&run) {}
    [[nodiscard]] CbcHeuristic* clone() const override { return new RelaxationRounding(*this); }
    void resetModel(CbcModel* model) override { setModel(model); }
    int solution(double& objectiveValue, double* newSolution) override
    {
        bool better = false;
        if (m_run->isMain(model_))
            m_run->guard([&] { better = round(objectiveValue, newSolution); });
        return better ? 1 : 0;
    }

private:
    bool round(double& objectiveValue, double* newSolution) const
    {
        const MilpModel& milp = m_run->milp();
        const std::span<const double> relaxed{model_->solver()->getColSolution(),
                                              milp.columns.size()};
        const VisitOrder order = roundRelaxation(m_run->problem(), milp, relaxed);
        const double value = m_run->scaledObjective(order);
        if (value >= objectiveValue)
            return false;
        const std::vector<double> columns = encode(milp, order);
        if (decode(milp, columns) != order)
            return false; // it uses an arc missing in the reduced model
        std::copy(columns.begin(), columns.end(), newSolution);
        objectiveValue = value;
        return true;
    }

    CbcRun* m_run;
};

void load(const CbcRun& run, OsiClpSolverInterface& solver)
{
    const MilpModel& milp = run.milp();
    std::vector<int> rowOf;
    std::vector<int> columnOf;
    std::vector<double> coefficients;
    std::vector<double> rowLower;
    std::vector<double> rowUpper;
    for (const MilpRow& row : milp.rows) {
        for (const MilpTerm& term : row.terms) {
            rowOf.push_back(static_cast<int>(rowLower.size()));
            columnOf.push_back(term.column);
            coefficients.push_back(term.coefficient);
        }
        rowLower.push_back(coinBound(row.lower));
        rowUpper.push_back(coinBound(row.upper));
    }
    std::vector<double> lower;
    std::vector<double> upper;
    std::vector<double> costs;
    for (const MilpColumn& column : milp.columns) {
        lower.push_back(coinBound(column.lower));
        upper.push_back(coinBound(column.upper));
        costs.push_back(run.scale() * column.objective);
    }
    const CoinPackedMatrix matrix(true, rowOf.data(), columnOf.data(), coefficients.data(),
                                  static_cast<CoinBigIndex>(coefficients.size()));
    solver.loadProblem(matrix, lower.data(), upper.data(), costs.data(), rowLower.data(),
                       rowUpper.data());
    for (std::size_t c = 0; c < milp.columns.size(); ++c)
        if (milp.columns[c].integer)
            solver.setInteger(static_cast<int>(c));
}

/** Sets limits, gap and starting incumbent. */
void configure(CbcModel& model, const CbcRun& run)
{
    const SolveOptions& options = run.options();
    model.setIntegerTolerance(1e-6);
    model.setAllowableGap(0);
    model.setAllowableFractionGap(run.searchGap());
    model.setPrintFrequency(1); // CBC then checks the gap and calls the watcher at every node
    model.setUseElapsedTime(true);
    if (options.timeLimit_s)
        model.setMaximumSeconds(std::max(0.0, *options.timeLimit_s - run.elapsed_s()));
    if (options.workLimit)
        model.setMaximumNodes(static_cast<int>(std::min(*options.workLimit, kLargestNodeLimit)));
    if (!run.best().empty()) {
        const std::vector<double> columns = encode(run.milp(), run.best());
        model.setBestSolution(columns.data(), static_cast<int>(columns.size()),
                              run.scaledObjective(run.best()));
    }
}

/** Values of CbcModel::secondaryStatus(). */
enum class Ending
{
    Searched = 0,
    NoneBetter = 1,
    Gap = 2,
    Nodes = 3,
    Seconds = 4
};

Ending endingOf(const CbcModel& model)
{
    return static_cast<Ending>(model.secondaryStatus());
}

std::string detailOf(const CbcModel& model)
{
    return "CBC: status " + std::to_string(model.status()) + '/' +
           std::to_string(model.secondaryStatus()) + ", " + std::to_string(model.getNodeCount()) +
           " nodes, " + std::to_string(model.getIterationCount()) + " simplex iterations";
}

/** Derives status and reason from `run` and CBC. The order of the tests matters. */
void conclude(const CbcModel& model, const CbcRun& run, SolveOutcome& outcome)
{
    const Ending ending = endingOf(model);
    const bool noGapLeft = ending == Ending::Searched || ending == Ending::NoneBetter ||
                           (ending == Ending::Gap && run.searchGap() == 0);
    outcome.status = run.best().empty() ? SolveStatus::None : SolveStatus::Feasible;
    if (run.stopped()) {
        outcome.reason = *run.stopped();
    } else if (model.status() == 0 && noGapLeft && !run.best().empty()) {
        outcome.status = SolveStatus::Optimal;
    } else if (ending == Ending::Gap) {
        outcome.reason = StopReason::GapReached;
    } else if (ending == Ending::Nodes) {
        outcome.reason = StopReason::WorkLimit;
    } else if (ending == Ending::Seconds) {
        outcome.reason = StopReason::TimeLimit;
    } else {
        outcome.reason = StopReason::Unable;
        outcome.detail += "; the search failed";
    }
}

SolveOutcome branchAndCut(const OsiClpSolverInterface& relaxation, CbcRun& run)
{
    CbcModel model(relaxation);
    model.passInMessageHandler(relaxation.messageHandler());
    model.setLogLevel(0);
    run.setMain(&model);

    const AdmissibleFlow flow(run.milp());
    AdmissibleFlowCuts cuts(run, flow);
    if (!run.milp().hasOrderColumns) {
        constexpr int kEveryNode = 1;
        model.addCutGenerator(&cuts, kEveryNode, "AdmissibleFlow");
        model.setMaximumCutPassesAtRoot(50);
        model.setMaximumCutPasses(10);
    }
    RelaxationRounding rounding(model, run);
    model.addHeuristic(&rounding, "RelaxationRounding");
    SearchWatcher watcher(run);
    model.passInEventHandler(&watcher);
    configure(model, run);

    model.branchAndBound();
    if (!run.stopped()) {
        harvestFrom(run, model);
        if (endingOf(model) == Ending::Gap)
            // The bound by which the gap was measured.
            run.raiseBound(model.getBestPossibleObjValue());
    }
    run.setMain(nullptr);

    SolveOutcome outcome{.work = model.getNodeCount(), .detail = detailOf(model)};
    conclude(model, run, outcome);
    return outcome;
}

SolveOutcome search(CbcRun& run)
{
    SilentHandler silent;
    const CoinStop stop = [&run] { return run.mustStop(); };
    StoppableClp solver(stop);
    solver.passInMessageHandler(&silent);
    solver.setHintParam(OsiDoReducePrint, true, OsiHintTry);
    SimplexStopper stopper(stop);
    solver.getModelPtr()->passInEventHandler(&stopper);
    load(run, solver);
    constexpr int kNoScaling = 0;
    if (!run.milp().hasOrderColumns)
        solver.getModelPtr()->scaling(kNoScaling); // the coefficients are 1 and -1
    // The dual simplex is used because initialSolve() begins with a crash that does not consult the
    // stopper.
    solver.resolve();
    if (run.mustStop())
        return {.status = run.best().empty() ? SolveStatus::None : SolveStatus::Feasible,
                .reason = *run.stopped(),
                .detail = "CBC: stopped in the first relaxation"};
    if (solver.isProvenOptimal())
        run.raiseBound(solver.getObjValue());
    run.report();
    return branchAndCut(solver, run);
}

/** Returns the outcome of a solve that ended before the search, with the hint as its plan. */
SolveOutcome unsolved(const FleetPlan& hint, StopReason reason)
{
    return {.status = hint.empty() ? SolveStatus::None : SolveStatus::Feasible,
            .reason = reason,
            .plan = hint,
            .hintUsed = !hint.empty()};
}

SolveOutcome solveMilp(const TvpProblem& problem, const SolveOptions& options,
                       const MilpModel& milp)
{
    SolveOutcome outcome;
    CbcRun run(problem, options, milp);
    try {
        outcome = search(run);
    } catch (const CoinError& error) {
        throw Error(ErrorCode::SolverFailed, "cbc",
                    error.className() + "::" + error.methodName() + ": " + error.message());
    }
    run.rethrow();
    if (outcome.reason == StopReason::Unable && outcome.status == SolveStatus::None)
        throw Error(ErrorCode::SolverFailed, "cbc", outcome.detail);
    outcome.plan = {run.best()};
    outcome.bound = run.bound();
    outcome.hintUsed = !options.hint.empty();
    return outcome;
}

SolveOutcome solveReduced(const TvpProblem& problem, const SolveOptions& options)
{
    const SolveWatch watch(options);
    const Stopwatch stopwatch;
    const ReducedModel reduced = reducedModel(problem, options);
    FleetPlan incumbent;
    if (!reduced.incumbent.empty())
        incumbent = {reduced.incumbent};
    SolveOutcome outcome;
    if (const std::optional<StopReason> cut = watch.stopReason()) {
        outcome = unsolved(incumbent, *cut);
    } else {
        SolveOptions warm = options;
        warm.hint = incumbent;
        if (warm.timeLimit_s)
            *warm.timeLimit_s -= stopwatch.elapsed_s();
        outcome = solveMilp(problem, warm, reduced.milp);
        outcome.detail += ", " + std::to_string(reduced.milp.arcs.size()) + " columns";
    }
    outcome.hintUsed = !options.hint.empty();
    return outcome;
}

} // namespace

SolveOutcome searchByCbc(const TvpProblem& problem, Formulation formulation,
                         const SolveOptions& options)
{
    const bool noWork = options.workLimit && *options.workLimit <= 0;
    const bool noTime = options.timeLimit_s && *options.timeLimit_s <= 0;
    if (noWork || noTime)
        return unsolved(options.hint, noWork ? StopReason::WorkLimit : StopReason::TimeLimit);
    switch (formulation) {
    case Formulation::Position:
        return solveMilp(problem, options, positionModel(problem));
    case Formulation::Printed:
        return solveMilp(problem, options, printedModel(problem));
    case Formulation::Reduced:
        return solveReduced(problem, options);
    }
    throw std::logic_error("searchByCbc: no such formulation");
}

} // namespace berg
