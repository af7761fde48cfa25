#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <algorithm>
#include <array>

namespace berg::bench {

namespace {

/** Seeds that were not used for tuning. */
constexpr std::int64_t kFirstSeed = 70000;

/** Knowledge about the icebergs, and their number. */
struct Regime
{
    const char* name;
    int icebergs = 12;
    int uavs = 1;
    double velocitySd_mps = 0;
    ObserverSpec observer = {.model = ObserverModel::Kalman};
    FieldRegime drift = FieldRegime::Published;
    double duration_s = 1000;
};

const std::array kRegimes{
    Regime{"simple observer", 12, 1, 0, {}},
    Regime{"5 m, velocity known"},
    Regime{"velocity_sd 0.1", 12, 1, 0.1},
    Regime{"velocity_sd 0.3", 12, 1, 0.3},
    Regime{"0.1, 20 m", 12, 1, 0.1, {.model = ObserverModel::Kalman, .positionSd_m = 20}},
    Regime{"0.1, detection 0.6", 12, 1, 0.1, {.model = ObserverModel::Kalman, .detection = 0.6}},
    Regime{"20: velocity known", 20},
    Regime{"20: velocity_sd 0.1", 20, 1, 0.1},
    Regime{"20: velocity_sd 0.3", 20, 1, 0.3},
    Regime{"20: 0.1, 20 m", 20, 1, 0.1, {.model = ObserverModel::Kalman, .positionSd_m = 20}},
    Regime{"2 UAVs, 0.1", 12, 2, 0.1},
    Regime{"3 UAVs, 0.1", 12, 3, 0.1},
    Regime{.name = "fitted drift, 1 h", .drift = FieldRegime::FittedDrift, .duration_s = 3600},
    Regime{.name = "fitted drift, 8 h", .drift = FieldRegime::FittedDrift, .duration_s = 8 * 3600}};

/** Policies compared with visitation at tau = 1; the last one is under test. */
struct BenchmarkEntry
{
    PolicyKind policy;
    double tau = 1;
};
constexpr std::array kBenchmarkEntries{
    BenchmarkEntry{PolicyKind::Visitation, 0.5}, BenchmarkEntry{PolicyKind::Latency},
    BenchmarkEntry{PolicyKind::Tour}, BenchmarkEntry{PolicyKind::Coverage}};

Scenario scenarioOf(const Regime& regime, std::int64_t seed)
{
    Scenario scenario = randomScenario(seed, {.icebergs = regime.icebergs, .regime = regime.drift});
    scenario.duration_s = regime.duration_s;
    scenario.observer = regime.observer;
    if (regime.drift == FieldRegime::Published)
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocitySd_mps = regime.velocitySd_mps;
    return withUavs(std::move(scenario), regime.uavs);
}

Mission flown(Scenario scenario, const BenchmarkEntry& contestant)
{
    scenario.planner.policy = contestant.policy;
    scenario.planner.tau = contestant.tau;
    Mission mission(scenario, {.record = false});
    mission.advance(scenario.duration_s);
    return mission;
}

/** Flights of one field: changes of zeta in %, and accuracy of the first plan's prediction. */
struct Field
{
    std::array<double, kBenchmarkEntries.size()> change{};
    double againstBest = 0; ///< coverage relative to the best of all others
    double foreseen = 0;    ///< flown zeta relative to the first plan's prediction
    double plans = 0;
};

Field fieldOf(const Scenario& scenario)
{
    const double base_m2s = flown(scenario, {PolicyKind::Visitation}).metrics().zeta_m2s;
    Field field;
    double best_m2s = base_m2s;
    for (std::size_t k = 0; k < kBenchmarkEntries.size(); ++k) {
        const Mission mission = flown(scenario, kBenchmarkEntries[k]);
        const double zeta_m2s = mission.metrics().zeta_m2s;
        field.change[k] = 100 * (zeta_m2s / base_m2s - 1);
        if (k + 1 < kBenchmarkEntries.size()) {
            best_m2s = std::min(best_m2s, zeta_m2s);
            continue;
        }
        field.againstBest = 100 * (zeta_m2s / best_m2s - 1);
        field.foreseen = zeta_m2s / mission.plans().front()->predictedZeta_m2s.value_or(zeta_m2s);
        field.plans = mission.metrics().replans;
    }
    return field;
}

template <class Get>
MeanInterval meanOf(const std::vector<Field>& fields, const Get& get)
{
    std::vector<double> values;
    for (const Field& field : fields)
        values.push_back(get(field));
    return meanInterval(values);
}

void print(const Regime& regime, const std::vector<Field>& fields)
{
    std::printf("%-20s", regime.name);
    for (std::size_t k = 0; k < kBenchmarkEntries.size(); ++k) {
        const MeanInterval mean = meanOf(fields, [k](const Field& f) { return f.change[k]; });
        std::printf(" %+6.1f +-%4.1f", mean.mean, mean.high - mean.mean);
    }
    std::vector<double> against;
    for (const Field& field : fields)
        against.push_back(field.againstBest);
    const Summary best = summarise(against);
    const auto better = std::ranges::count_if(against, [](double change) { return change < 0; });
    const double worst =
        std::ranges::max(fields, {}, [](const Field& f) { return f.change.back(); }).change.back();
    std::printf("  %+6.1f %+6.1f %3td/%zu %+6.0f %+6.0f %7.2f %6.0f\n", best.mean, best.median,
                better, fields.size(), std::ranges::max(against), worst,
                meanOf(fields, [](const Field& f) { return f.foreseen; }).mean,
                meanOf(fields, [](const Field& f) { return f.plans; }).mean);
    std::fflush(stdout);
}

} // namespace

void observer(int scenarios)
{
    observerFrom(kFirstSeed, scenarios, {});
}

void observerFrom(std::int64_t firstSeed, int scenarios, std::string_view only)
{
    std::printf("Change of zeta against visitation at tau = 1 in %%, mean over fields and 95 %% "
                "interval\n%-20s %13s %13s %13s %13s  %s\n%-20s %56s %6s %6s %6s %6s %6s %7s %6s\n",
                "", "tau 0.5", "latency", "tour", "coverage", "coverage against the best of them",
                "", "", "mean", "median", "better", "worst", "worst", "flown/", "plans");
    for (const Regime& regime : kRegimes) {
        if (!only.empty() && only != regime.name)
            continue;
        std::vector<Field> fields;
        for (std::int64_t seed = firstSeed; seed < firstSeed + scenarios; ++seed)
            fields.push_back(fieldOf(scenarioOf(regime, seed)));
        print(regime, fields);
    }
}

} // namespace berg::bench
