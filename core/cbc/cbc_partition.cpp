#include "core/cbc/cbc_partition.h"

#include "core/cbc/cbc_coin.h"

#include <CbcModel.hpp>
#include <CoinError.hpp>
#include <CoinPackedMatrix.hpp>

#include <vector>

namespace berg {

namespace {

/** Scaled value of the slack, chosen to suit Clp's absolute tolerances. */
constexpr double kScaledSlack = 1000;

void load(const CbcPartition& partition, OsiClpSolverInterface& solver)
{
    std::vector<int> rows;
    std::vector<int> columns;
    std::vector<double> costs;
    for (std::size_t column = 0; column < partition.columns.size(); ++column) {
        costs.push_back(kScaledSlack * partition.costs[column] / partition.slack);
        for (const int row : partition.columns[column]) {
            rows.push_back(row);
            columns.push_back(static_cast<int>(column));
        }
    }
    const std::vector<double> ones(rows.size(), 1.0);
    CoinPackedMatrix matrix(true, rows.data(), columns.data(), ones.data(),
                            static_cast<CoinBigIndex>(rows.size()));
    matrix.setDimensions(partition.rows, static_cast<int>(costs.size()));
    const std::vector<double> lower(costs.size(), 0.0);
    const std::vector<double> upper(costs.size(), 1.0);
    const std::vector<double> one(static_cast<std::size_t>(partition.rows), 1.0);
    solver.loadProblem(matrix, lower.data(), upper.data(), costs.data(), one.data(), one.data());
    for (std::size_t column = 0; column < costs.size(); ++column)
        solver.setInteger(static_cast<int>(column));
}

CbcChoice search(const CbcPartition& partition)
{
    SilentHandler silent;
    OsiClpSolverInterface solver;
    solver.passInMessageHandler(&silent);
    solver.setHintParam(OsiDoReducePrint, true, OsiHintTry);
    load(partition, solver);
    solver.resolve();
    if (solver.isProvenPrimalInfeasible() ||
        (solver.isProvenOptimal() && solver.getObjValue() >= kScaledSlack))
        return {.complete = true};
    CbcModel model(solver);
    model.passInMessageHandler(&silent);
    model.setLogLevel(0);
    model.setIntegerTolerance(1e-6);
    model.setAllowableGap(0);
    model.setAllowableFractionGap(0);
    model.setCutoff(kScaledSlack);
    model.branchAndBound();
    CbcChoice choice{.complete = model.isProvenOptimal() || model.isProvenInfeasible()};
    if (const double* solution = model.bestSolution())
        for (std::size_t column = 0; column < partition.columns.size(); ++column)
            if (solution[column] > 0.5)
                choice.columns.push_back(static_cast<int>(column));
    return choice;
}

} // namespace

CbcChoice bestPartition(const CbcPartition& partition)
{
    try {
        return search(partition);
    } catch (const CoinError& error) {
        throw Error(ErrorCode::SolverFailed, "cbc", error.message());
    }
}

} // namespace berg
