// Separation of UAVs in one altitude layer.

#include "core/checks/validate.h"
#include "tests/bench/world_parts.h"
#include "tests/support/flight/fleet_case.h"
#include "tests/support/flight/pad_fleet.h"

#include <map>

namespace berg::bench {

namespace {

/** UAVs along the western edge, evenly, heading as the first, all of one layer. */
Scenario inOneLayer(std::int64_t seed, int uavs)
{
    Scenario scenario = randomScenario(seed);
    const Uav first = scenario.uavs.front();
    for (int i = 1; i < uavs; ++i) {
        scenario.uavs.push_back(first);
        scenario.uavs.back().id = "uav-" + std::to_string(i + 1);
        scenario.uavs.back().position_m.y() += 1000.0 * i;
    }
    return scenario;
}

Row rowOf(const test::FleetOutcome& flight, double separation_m)
{
    return {flight.zeta_m2s,
            static_cast<double>(flight.visits),
            flight.longest_s,
            static_cast<double>(flight.landings),
            static_cast<double>(flight.late),
            static_cast<double>(flight.spent),
            flight.isInside ? 0.0 : 1.0,
            flight.least_m < separation_m ? 1.0 : 0.0};
}

/** Flies the same scenarios with and without separation. */
class Pairs
{
public:
    void fly(Scenario scenario)
    {
        const double separation_m = scenario.separation_m;
        const test::FleetOutcome apart = test::flownFleet(scenario);
        m_apart.push_back(rowOf(apart, separation_m));
        std::vector<double>& waits_s = m_waits_s[scenario.uavs.size()];
        waits_s.insert(waits_s.end(), apart.waits_s.begin(), apart.waits_s.end());
        scenario.separation_m = 0;
        m_free.push_back(rowOf(test::flownFleet(scenario), separation_m));
    }
    void print(const char* name) const
    {
        std::printf("%s: %d\n", name, static_cast<int>(m_free.size()));
        printMeans("  kept apart", m_apart);
        printMeans("  not kept apart", m_free);
        printDifference("  zeta", m_free, m_apart);
        for (const auto* rows : {&m_apart, &m_free}) {
            std::vector<double> waits_s;
            for (const Row& row : *rows)
                waits_s.push_back(row[2]);
            std::ranges::sort(waits_s);
            std::printf("  longest wait, s: median %.0f, 99 %% %.0f, all %.0f\n",
                        waits_s[waits_s.size() / 2], waits_s[waits_s.size() * 99 / 100],
                        waits_s.back());
        }
        for (auto [uavs, waits_s] : m_waits_s)
            if (!waits_s.empty()) {
                std::ranges::sort(waits_s);
                std::printf(
                    "  %zu UAVs, %zu landings later than foreseen, s: 99 %% %.0f, all %.0f\n", uavs,
                    waits_s.size(), waits_s[waits_s.size() * 99 / 100], waits_s.back());
            }
        std::fflush(stdout);
    }

private:
    std::vector<Row> m_apart;
    std::vector<Row> m_free;
    /** Waiting times before landing, by number of UAVs. */
    std::map<std::size_t, std::vector<double>> m_waits_s;
};

} // namespace

void separation(int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s %11s %11s %11s %11s\n", "", "zeta", "visits",
                "longest wait", "landings", "late", "spent", "outside", "too near");
    for (const int uavs : {2, 3, 5}) {
        Pairs pairs;
        for (int seed = 1; seed <= std::min(scenarios, 50); ++seed)
            pairs.fly(inOneLayer(seed, uavs));
        pairs.print((std::to_string(uavs) + " UAVs, 12 icebergs").c_str());
    }
    Pairs pairs;
    for (int seed = 1, left = scenarios; left > 0; ++seed) {
        const Scenario scenario = test::FleetCase(seed).scenario();
        if (scenario.uavs.size() < 2 || hasErrors(validate(scenario)))
            continue;
        --left;
        pairs.fly(scenario);
    }
    pairs.print("random fleets");
}

/** Flies fleets that share pads; prints each failure, then the counts of all. */
void pads(int scenarios)
{
    int landings = 0;
    int reserves = 0;
    int unwarned = 0;
    int spent = 0;
    int broken = 0;
    int outside = 0;
    for (std::int64_t seed = 1, left = scenarios; left > 0; ++seed) {
        const std::optional<Scenario> scenario = test::flyablePadFleet(seed);
        if (!scenario)
            continue;
        --left;
        const test::FleetOutcome flight = test::flownFleet(*scenario);
        landings += flight.landings;
        reserves += flight.late;
        unwarned += test::isWarnedOfCrowd(*scenario) ? 0 : flight.late;
        spent += flight.spent;
        broken += flight.staysApart ? 0 : 1;
        outside += flight.isInside ? 0 : 1;
        std::printf("fleet %d: %d UAVs, zeta %.1f, %d landings, %d with reserve, %d too late%s%s\n",
                    static_cast<int>(seed), static_cast<int>(scenario->uavs.size()),
                    flight.zeta_m2s, flight.landings, flight.late, flight.spent,
                    flight.staysApart ? "" : ", too near again",
                    flight.isInside ? "" : ", outside");
        std::fflush(stdout);
    }
    std::printf(
        "%d fleets, %d landings: %d used reserve (%d not warned of), %d after the endurance; "
        "%d fleets too near again, %d outside\n",
        scenarios, landings, reserves, unwarned, spent, broken, outside);
}

} // namespace berg::bench
