#pragma once

#include "core/plan/problem/formulation.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace berg::test {

/** Returns the objective of a solution, one value per column, offset included. */
inline double objectiveValue(const MilpModel& model, std::span<const double> solution)
{
    double value = model.objectiveOffset;
    for (std::size_t c = 0; c < solution.size(); ++c)
        value += model.columns[c].objective * solution[c];
    return value;
}

/**
 * Returns the largest violation of a bound, a row or the integrality of a column; 0 if feasible.
 */
inline double violation(const MilpModel& model, std::span<const double> solution)
{
    double worst = 0;
    for (std::size_t c = 0; c < solution.size(); ++c) {
        const MilpColumn& column = model.columns[c];
        worst = std::max({worst, column.lower - solution[c], solution[c] - column.upper});
        if (column.integer)
            worst = std::max(worst, std::abs(solution[c] - std::round(solution[c])));
    }
    for (const MilpRow& row : model.rows) {
        double sum = 0;
        for (const MilpTerm& term : row.terms)
            sum += term.coefficient * solution[static_cast<std::size_t>(term.column)];
        worst = std::max({worst, row.lower - sum, sum - row.upper});
    }
    return worst;
}

} // namespace berg::test
