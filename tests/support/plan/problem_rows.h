#pragma once

#include "tests/support/plan/brute_force.h"

#include <QtTest>

namespace berg::test {

/** A row for each trade-off, open and closed, symmetric and asymmetric. */
inline void addProblemRows()
{
    QTest::addColumn<double>("tau");
    QTest::addColumn<bool>("closed");
    QTest::addColumn<bool>("asymmetric");
    for (const double tau : {0.5, 1.0, 3.0})
        for (const bool closed : {false, true})
            for (const bool asymmetric : {false, true})
                QTest::addRow("tau %g, %s, %s", tau, closed ? "closed" : "open",
                              asymmetric ? "asymmetric" : "symmetric")
                    << tau << closed << asymmetric;
}

/** Returns the random problem of the present row. */
inline TvpProblem fetchedProblem(std::uint64_t seed, int icebergs)
{
    QFETCH(double, tau);
    QFETCH(bool, closed);
    QFETCH(bool, asymmetric);
    return randomProblem(seed, icebergs, tau, closed ? Route::Closed : Route::Open, asymmetric);
}

} // namespace berg::test
