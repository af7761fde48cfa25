#pragma once

#include "tests/support/plan/fleet_problems.h"

#include <QtTest>

namespace berg::test {

/** Adds the columns kind and tau of `fetchedFleet` with a row for each pair. */
inline void addFleetRows(bool latency = true)
{
    struct Named
    {
        FleetKind kind;
        const char* name;
    };
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("tau");
    for (const Named& kind :
         {Named{FleetKind::Plain, "plain"}, Named{FleetKind::Unlike, "unlike, asymmetric"},
          Named{FleetKind::Assigned, "assigned"}, Named{FleetKind::Closed, "closed"}})
        for (const double tau : {0.0, 0.5, 1.0, 3.0, 10.0})
            QTest::addRow("%s, tau %g", kind.name, tau) << static_cast<int>(kind.kind) << tau;
    if (latency)
        QTest::addRow("latency") << static_cast<int>(FleetKind::Latency) << 1.0;
}

inline FleetProblem fetchedFleet(std::uint64_t seed, int uavs, int icebergs)
{
    QFETCH(int, kind);
    QFETCH(double, tau);
    return randomFleet(seed, uavs, icebergs, tau, static_cast<FleetKind>(kind));
}

/** Returns whether two objectives differ only by rounding, relative to F + N sum(sigma). */
inline bool sameObjective(const FleetProblem& problem, double a, double b)
{
    constexpr double kRounding = 1e-11; // rounding of sums of a few hundred numbers
    return std::abs(a - b) <= kRounding * (std::abs(b) + objectiveShift(problem));
}

} // namespace berg::test
