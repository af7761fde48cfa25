#pragma once

#include "core/study/benchmark.h"

#include <vector>

namespace berg::test {

/** Returns a row with recognisable times: the worst is three times the median. */
inline BenchmarkRow benchmarkRow(const BenchmarkSolver& solver, int icebergs, double median_s)
{
    BenchmarkRow row{.icebergs = icebergs, .solver = solver, .instances = 10, .proven = 10};
    row.seconds = {.n = 10, .mean = 1.2 * median_s, .median = median_s};
    row.worst_s = 3 * median_s;
    return row;
}

/** Returns a table as measured on a machine of 2026; `cbc-printed` stops at 6 icebergs. */
inline std::vector<BenchmarkRow> benchmarkTable()
{
    struct Times
    {
        const char* solver;
        std::vector<std::pair<int, double>> medians_s;
    };
    const std::vector<Times> table{
        {"exact",
         {{2, 4e-7},
          {6, 2e-6},
          {10, 2e-5},
          {12, 9e-5},
          {16, 1.2e-3},
          {20, 2.6e-3},
          {30, 0.015},
          {40, 0.08},
          {60, 0.6},
          {80, 2.9}}},
        {"heuristic",
         {{2, 4e-6},
          {6, 7e-5},
          {10, 2.4e-4},
          {12, 3.7e-4},
          {16, 1.3e-3},
          {20, 6e-3},
          {30, 0.022},
          {40, 0.083},
          {60, 0.58},
          {80, 2.3}}},
        {"cbc-reduced",
         {{2, 2e-4}, {6, 4e-4}, {10, 5e-4}, {16, 1.2e-3}, {20, 6e-3}, {30, 0.02}, {40, 0.07}}},
        {"cbc-position", {{2, 2e-4}, {6, 1e-3}, {10, 0.016}, {12, 0.05}, {16, 0.2}, {20, 2.4}}},
        {"cbc-printed", {{2, 5e-4}, {6, 0.48}}}};
    std::vector<BenchmarkRow> rows;
    for (const Times& times : table)
        for (const auto& [icebergs, median_s] : times.medians_s)
            rows.push_back(
                benchmarkRow(*valueOf(kBenchmarkSolverNames, times.solver), icebergs, median_s));
    rows.back().cut = 2;
    rows.back().proven = 8;
    BenchmarkRow none{.icebergs = 10, .solver = rows.back().solver};
    none.note = "not tried: 6 icebergs took too long";
    rows.push_back(none);
    return rows;
}

} // namespace berg::test
