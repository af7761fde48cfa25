#pragma once

#include "tests/support/files/export_fixtures.h"

#include <QLocale>

// Fixtures for flight briefs.

namespace berg::test {

inline const QLocale kEnglish(QLocale::English, QLocale::UnitedKingdom);
inline const QLocale kAmerican(QLocale::English, QLocale::UnitedStates);
inline const QLocale kGerman(QLocale::German, QLocale::Germany);

/** Returns the scenario with a start time at which its flights are by day. */
inline Scenario byDay(Scenario scenario)
{
    scenario.startUtc = "2026-05-01T12:00:00Z";
    return scenario;
}

/** Returns a fleet of `uavs` UAVs that share `icebergs` icebergs of `fiveHundred`. */
inline Scenario fleetScenario(int uavs, int icebergs)
{
    Scenario scenario = byDay(fiveHundred());
    scenario.icebergs.resize(static_cast<std::size_t>(icebergs));
    const Uav first = scenario.uavs.front();
    for (int i = 1; i < uavs; ++i) {
        Uav& uav = scenario.uavs.emplace_back(first);
        uav.id = "uav-" + std::to_string(i + 1);
        uav.position_m += Point(300 * i, 0);
        uav.spec.altitude_m += 40 * i;
    }
    return scenario;
}

/** Returns a plan that gives the icebergs to the UAVs in turn. */
inline Plan fleetPlan(int uavs, int icebergs)
{
    Plan plan;
    for (int i = 0; i < uavs; ++i)
        plan.uavs.push_back({.uav = i});
    for (int i = 0; i < icebergs; ++i)
        plan.uavs[static_cast<std::size_t>(i % uavs)].order.push_back(IcebergIndex::of(i));
    return plan;
}

inline ExportContent fleetContent(int uavs, int icebergs)
{
    return planContent(fleetScenario(uavs, icebergs), fleetPlan(uavs, icebergs));
}

/** Returns a scenario with names of 300 characters that break lines and pages. */
inline Scenario longHostile()
{
    Scenario scenario = hostile();
    scenario.notes = "First line\nsecond line\r\n\x0b" + std::string(5000, 'n');
    for (Iceberg& iceberg : scenario.icebergs)
        for (const std::string part = iceberg.name + iceberg.id; iceberg.name.size() < 300;)
            iceberg.name += part + " \xD7\xA7\xD7\xA8\n";
    for (int i = 0; i < 100; ++i)
        scenario.uavs[0].name += "Very long\t";
    scenario.name += std::string(400, 'W');
    return scenario;
}

} // namespace berg::test
