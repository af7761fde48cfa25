// Endurance and geofence.

#include "tests/bench/world_parts.h"
#include "tests/support/flight/fenced_scenario.h"

#include <limits>

namespace berg::bench {

namespace {

constexpr double kDuration_s = 4000;
constexpr double kEndurance_s = 1200;

struct Flight
{
    double zeta_m2s = 0;
    double visits = 0;
    double sorties = 0;
    double outside = 0; ///< number of samples outside the area, ten per second
    double margin_s = std::numeric_limits<double>::infinity(); ///< smallest margin at a landing
};

Flight fly(const Scenario& scenario)
{
    Mission mission(scenario, {.sampleInterval_s = 0.1, .keyframeInterval_s = 1e9});
    mission.advance(scenario.duration_s);
    Flight flight{.zeta_m2s = mission.metrics().zeta_m2s,
                  .visits = static_cast<double>(mission.metrics().visits),
                  .sorties = 1.0 + countOf(mission, EventKind::TookOff)};
    double start_s = 0;
    for (const MissionEvent& event : mission.events()) {
        if (event.kind == EventKind::TookOff)
            start_s = event.time_s;
        if (event.kind == EventKind::Landed)
            flight.margin_s = std::min(flight.margin_s, scenario.uavs[0].spec.endurance_s -
                                                            (event.time_s - start_s));
    }
    for (const Sample& sample : mission.recorder().samples())
        if (!scenario.area_m.empty() &&
            !insidePolygon(scenario.area_m, sample.uavs[0].pose.position_m))
            ++flight.outside;
    return flight;
}

/** `make` draws a scenario, `change` applies the condition to it. */
template <class Make, class Change>
void compare(const char* title, int scenarios, const Make& make, const Change& change)
{
    std::vector<Row> without;
    std::vector<Row> with;
    double margin_s = std::numeric_limits<double>::infinity();
    for (int seed = 1; seed <= scenarios; ++seed) {
        Scenario scenario = make(seed);
        const auto row = [](const Flight& f) {
            return Row{f.zeta_m2s, f.visits, f.sorties, f.outside};
        };
        without.push_back(row(fly(scenario)));
        change(scenario);
        const Flight flight = fly(scenario);
        with.push_back(row(flight));
        margin_s = std::min(margin_s, flight.margin_s);
    }
    std::printf("%-24s %11s %11s %11s %11s\n", title, "zeta", "visits", "sorties", "outside");
    printMeans("  without", without);
    printMeans("  with", with);
    printDifference("  zeta", without, with);
    if (std::isfinite(margin_s))
        std::printf("  least margin at a landing %.1f s\n", margin_s);
}

} // namespace

void endurance(int scenarios)
{
    for (const double wind_mps : {0.0, 10.0})
        compare(
            wind_mps > 0 ? "endurance, 10 m/s" : "endurance, calm", scenarios,
            [&](int seed) {
                Scenario s = randomScenario(seed);
                s.duration_s = kDuration_s;
                s.wind_mps = {0.8 * wind_mps, -0.6 * wind_mps};
                return s;
            },
            [](Scenario& s) {
                s.uavs[0].spec.endurance_s = kEndurance_s;
                s.uavs[0].turnaround_s = 600;
            });
}

void geofence(int scenarios)
{
    for (const double wind_mps : {0.0, 5.0, 10.0})
        for (const double endurance_s : {0.0, kEndurance_s}) {
            std::printf("wind %.0f m/s, endurance %.0f s\n", wind_mps, endurance_s);
            compare(
                "geofence", scenarios,
                [&](int seed) {
                    Scenario s = test::fencedScenario(seed, {0.8 * wind_mps, -0.6 * wind_mps});
                    s.duration_s = kDuration_s;
                    s.geofence = false;
                    s.uavs[0].spec.endurance_s = endurance_s;
                    return s;
                },
                [](Scenario& s) { s.geofence = true; });
        }
}

} // namespace berg::bench
