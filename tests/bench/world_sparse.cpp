// Fields as at sea rather than in the paper: sparse or large, and monitored for hours.

#include "core/base/random.h"
#include "core/bound/zeta_bound.h"
#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <optional>
#include <string>

namespace berg::bench {

namespace {

constexpr double kHour_s = 3600;

/** A row of the table. */
struct SparseRow
{
    const char* name;
    int icebergs = 12;
    double spacing_m = 4000; ///< side of a square with one iceberg on average
    double duration_s = 8 * kHour_s;
    int uavs = 1;
    bool variedGrowth = false;    ///< q from 0.005 to 0.1 m2/s, uniform in its logarithm
    bool unknownVelocity = false; ///< Kalman, 5 m, velocities known to 0.1 m/s
    double endurance_s = 0;       ///< zero means unlimited
};

const std::array kSparseRows{
    SparseRow{"paper", 12, 0, 1000},
    SparseRow{"12/1300/1h", 12, 1300, kHour_s},
    SparseRow{"40/1300/1h", 40, 1300, kHour_s},
    SparseRow{"12/4000/1h", 12, 4000, kHour_s},
    SparseRow{"12/4000/4h", 12, 4000, 4 * kHour_s},
    SparseRow{"40/4000/2h", 40, 4000, 2 * kHour_s},
    SparseRow{"40/4000/8h", 40, 4000, 8 * kHour_s},
    SparseRow{.name = "40/4000/8h/q", .icebergs = 40, .variedGrowth = true},
    SparseRow{"40/10000/24h", 40, 10000, 24 * kHour_s},
    SparseRow{"100/1300/2h", 100, 1300, 2 * kHour_s},
    SparseRow{"100/4000/8h", 100, 4000, 8 * kHour_s},
    SparseRow{"100/4000/24h", 100, 4000, 24 * kHour_s},
    SparseRow{"200/4000/8h", 200, 4000, 8 * kHour_s},
    SparseRow{"300/1300/2h", 300, 1300, 2 * kHour_s},
    SparseRow{"300/4000/2h", 300, 4000, 2 * kHour_s},
    SparseRow{"100/1300/24h", 100, 1300, 24 * kHour_s},
    SparseRow{"40/4000/8h/2uav", 40, 4000, 8 * kHour_s, 2},
    SparseRow{"40/4000/8h/3uav", 40, 4000, 8 * kHour_s, 3},
    SparseRow{"100/1300/4h/3uav", 100, 1300, 4 * kHour_s, 3},
    SparseRow{"100/1300/24h/3uav", 100, 1300, 24 * kHour_s, 3},
    SparseRow{.name = "40/4000/8h/kalman", .icebergs = 40, .unknownVelocity = true},
    SparseRow{.name = "40/4000/8h/sorties", .icebergs = 40, .endurance_s = 1.5 * kHour_s}};

/** Square field with the default width; drift up to 0.2 m/s along each axis. */
Scenario sparseScenario(const SparseRow& row, std::int64_t seed)
{
    if (row.spacing_m <= 0)
        return randomScenario(seed);
    FieldSpec field{.icebergs = row.icebergs};
    field.size_m *= row.spacing_m * std::sqrt(row.icebergs / field.size_m.prod());
    Scenario scenario = randomScenario(seed, field);
    scenario.duration_s = row.duration_s;
    Random random(static_cast<std::uint64_t>(seed), stableHash("sparse"));
    for (Iceberg& iceberg : scenario.icebergs) {
        constexpr double kDrift_mps = 0.2;
        iceberg.velocity_mps.x() = random.uniform(-kDrift_mps, kDrift_mps);
        iceberg.velocity_mps.y() = random.uniform(-kDrift_mps, kDrift_mps);
        const double q_m2ps = 0.005 * std::pow(20.0, random.uniform());
        if (row.variedGrowth)
            iceberg.q_m2ps = q_m2ps;
        if (row.unknownVelocity)
            iceberg.velocitySd_mps = 0.1;
    }
    if (row.unknownVelocity)
        scenario.observer = {.model = ObserverModel::Kalman};
    scenario = withUavs(std::move(scenario), row.uavs);
    for (Uav& uav : scenario.uavs)
        uav.spec.endurance_s = row.endurance_s;
    return scenario;
}

/** Results of one flight, with CPU times. */
struct SparseFlight
{
    double zeta_m2s = 0;
    double first_s = 0;
    double next_s = 0; ///< mean of all plans after the first
    double all_s = 0;
    int plans = 0;
};

double processor_s()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

SparseFlight sparseFlight(Scenario scenario, PolicyKind policy)
{
    scenario.planner.policy = policy;
    Mission mission(scenario, {.record = false});
    SparseFlight flight;
    double later_s = 0;
    for (double until_s = scenario.dt_s; until_s < scenario.duration_s + 1; until_s += 1) {
        const int before = mission.metrics().replans;
        const double begin_s = processor_s();
        mission.advance(std::min(until_s, scenario.duration_s));
        const double took_s = processor_s() - begin_s;
        flight.all_s += took_s;
        if (before == 0)
            flight.first_s = took_s;
        else if (mission.metrics().replans > before)
            later_s += took_s;
    }
    flight.plans = mission.metrics().replans;
    flight.zeta_m2s = mission.metrics().zeta_m2s;
    flight.next_s = later_s / std::max(1, flight.plans - 1);
    return flight;
}

/** Results by policy, then by field. */
using SparseFlights = std::map<PolicyKind, std::vector<SparseFlight>>;

void printRow(const SparseRow& row, const SparseFlights& flights,
              const std::vector<double>& boundShares)
{
    const std::vector<SparseFlight>& own = flights.at(PolicyKind::Coverage);
    std::printf("%-20s", row.name);
    for (const PolicyKind other : {PolicyKind::Latency, PolicyKind::Visitation}) {
        const auto flown = flights.find(other);
        if (flown == flights.end()) {
            std::printf(" %16s", "-");
            continue;
        }
        std::vector<double> change;
        for (std::size_t k = 0; k < own.size(); ++k)
            change.push_back(100 * (own[k].zeta_m2s / flown->second[k].zeta_m2s - 1));
        const MeanInterval mean = meanInterval(change);
        std::printf(" %+8.2f +- %4.2f", mean.mean, mean.high - mean.mean);
    }
    SparseFlight sum;
    for (const SparseFlight& flight : own) {
        const auto n = static_cast<double>(own.size());
        sum.first_s += flight.first_s / n;
        sum.next_s += flight.next_s / n;
        sum.all_s += flight.all_s / n;
        sum.plans += flight.plans;
    }
    std::printf(" %4zu %8.0f %8.1f %8.1f %6d", own.size(), 1e3 * sum.first_s, 1e3 * sum.next_s,
                sum.all_s, sum.plans / static_cast<int>(own.size()));
    if (!boundShares.empty())
        std::printf(" %6.3f", meanInterval(boundShares).mean);
    std::printf("\n");
    std::fflush(stdout);
}

void flyRow(const SparseRow& row, const SparseOptions& options)
{
    SparseFlights flights;
    std::vector<double> boundShares;
    for (std::int64_t seed = options.firstSeed; seed < options.firstSeed + options.fields; ++seed) {
        const Scenario scenario = sparseScenario(row, seed);
        for (const PolicyKind policy :
             {PolicyKind::Coverage, PolicyKind::Latency, PolicyKind::Visitation}) {
            const std::string name(nameOf(kPolicyNames, policy));
            if (policy != PolicyKind::Coverage && options.against.find(name) == std::string::npos)
                continue;
            const SparseFlight flight = sparseFlight(scenario, policy);
            flights[policy].push_back(flight);
            std::fprintf(stderr, "%s seed %lld %s zeta %.0f first %.0f ms next %.1f ms\n", row.name,
                         static_cast<long long>(seed), name.c_str(), flight.zeta_m2s,
                         1e3 * flight.first_s, 1e3 * flight.next_s);
        }
        if (options.bound)
            boundShares.push_back(zetaLowerBound(scenario).zeta_m2s /
                                  flights[PolicyKind::Coverage].back().zeta_m2s);
    }
    printRow(row, flights, boundShares);
}

} // namespace

bool sparse(const SparseOptions& options)
{
    std::printf("Change of zeta of coverage in %%, mean over fields and 95 %% interval; times of "
                "the processor in ms, of a flight in s\n%-20s %16s %16s %4s %8s %8s %8s %6s%s\n",
                "icebergs/spacing", "latency", "visitation", "n", "first", "next", "flight",
                "plans", options.bound ? "  bound" : "");
    bool isKnown = false;
    for (const SparseRow& row : kSparseRows) {
        if (!options.row.empty() && options.row != row.name)
            continue;
        isKnown = true;
        flyRow(row, options);
    }
    return isKnown;
}

} // namespace berg::bench
