#include "core/base/random.h"
#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <cmath>
#include <utility>

namespace berg::bench {

namespace {

/**
 * The field of a seed with true velocities that differ from the given ones by `sd_mps` along each
 * axis. They are recorded tracks, so the world is the same whatever the observer believes.
 */
Scenario misjudged(std::int64_t seed, double sd_mps, double duration_s)
{
    Scenario scenario = randomScenario(seed);
    scenario.duration_s = duration_s;
    for (Iceberg& iceberg : scenario.icebergs) {
        Random random(static_cast<std::uint64_t>(seed), stableHash(iceberg.id + "/true velocity"));
        Point velocity_mps = iceberg.velocity_mps;
        velocity_mps.x() += sd_mps * random.normal();
        velocity_mps.y() += sd_mps * random.normal();
        iceberg.track = {
            .time_s = {0, duration_s},
            .position_m = {iceberg.position_m, iceberg.position_m + velocity_mps * duration_s}};
    }
    return scenario;
}

void believe(Scenario& scenario, double sd_mps)
{
    scenario.observer.model = ObserverModel::Kalman;
    for (Iceberg& iceberg : scenario.icebergs)
        iceberg.velocitySd_mps = sd_mps;
}

/** Values: zeta, estimate error (root mean square over time and icebergs), lost, found, visits. */
Row flown(const Scenario& scenario)
{
    Mission mission(scenario);
    double error_m2 = 0;
    int samples = 0;
    for (double time_s = 10; time_s <= scenario.duration_s; time_s += 10) {
        mission.advance(time_s);
        const Simulation& now = mission.simulation();
        for (const IcebergIndex i : now.icebergs()) {
            error_m2 += (now.observer().estimate_m(i) - now.truth_m(i)).squaredNorm();
            ++samples;
        }
    }
    return {mission.metrics().zeta_m2s, std::sqrt(error_m2 / samples),
            static_cast<double>(countOf(mission, EventKind::Lost)),
            static_cast<double>(countOf(mission, EventKind::Found)),
            static_cast<double>(mission.metrics().visits)};
}

template <class Change>
std::vector<Row> fly(int scenarios, double sd_mps, double duration_s, const Change& change)
{
    std::vector<Row> rows;
    for (int seed = 1; seed <= scenarios; ++seed) {
        Scenario scenario = misjudged(seed, sd_mps, duration_s);
        change(scenario);
        rows.push_back(flown(scenario));
    }
    return rows;
}

} // namespace

void filter(int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s %11s\n", "true velocity off by", "zeta", "error m",
                "lost", "found", "visits");
    for (const double sd_mps : {0.05, 0.1, 0.2, 0.4}) {
        std::printf("%g m/s\n", sd_mps);
        const auto simple = fly(scenarios, sd_mps, 1000, [](Scenario&) {});
        const auto fixed = fly(scenarios, sd_mps, 1000, [](Scenario& s) { believe(s, 0); });
        const auto kalman = fly(scenarios, sd_mps, 1000, [&](Scenario& s) { believe(s, sd_mps); });
        printMeans("  simple", simple);
        printMeans("  filter, velocity fixed", fixed);
        printMeans("  filter", kalman);
        printDifference("  error, filter", simple, kalman, 1);
    }
}

void lost(int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s %11s\n", "velocity sd, search", "zeta", "error m",
                "lost", "found", "visits");
    const std::pair<SearchPattern, const char*> searches[] = {{SearchPattern::None, "  none"},
                                                              {SearchPattern::Square, "  square"},
                                                              {SearchPattern::Sector, "  sector"}};
    for (const double detection : {1.0, 0.8})
        for (const double sd_mps : {0.3, 0.6}) {
            std::printf("%g m/s, detection %g, 2000 s\n", sd_mps, detection);
            std::vector<Row> none;
            for (const auto& [search, name] : searches) {
                const auto rows = fly(scenarios, sd_mps, 2000, [&, pattern = search](Scenario& s) {
                    believe(s, sd_mps);
                    s.observer.search = pattern;
                    s.observer.detection = detection;
                });
                printMeans(name, rows);
                double found = 0;
                double all = 0;
                for (const Row& row : rows) {
                    all += row[2];
                    found += row[3];
                }
                std::printf("    recovered %.1f %% of %.0f\n", 100 * found / all, all);
                if (none.empty())
                    none = rows;
                else
                    printDifference("    zeta", none, rows);
            }
        }
}

} // namespace berg::bench
