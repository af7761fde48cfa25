#include "core/plan/policy/policy.h"
#include "core/presets/presets.h"
#include "tests/bench/world_parts.h"

#include <memory>
#include <string>

namespace berg::bench {

namespace {

/** Plans as if tailwind and headwind cancelled, like a planner that ignores the wind. */
class WindlessSolver : public TvpSolver
{
public:
    [[nodiscard]] AnswerSource source() const override { return AnswerSource::Exact; }
    [[nodiscard]] std::optional<IssueReason> unsupportedReason(const TvpProblem&) const override
    {
        return std::nullopt;
    }

protected:
    [[nodiscard]] SolveOutcome doSolve(const TvpProblem& problem,
                                       const SolveOptions& options) const override
    {
        TvpProblem calm = problem;
        calm.distance_m = (problem.distance_m + problem.distance_m.transpose()) / 2;
        return m_solver->solve(calm, options);
    }

private:
    std::unique_ptr<TvpSolver> m_solver = makeSolver(Backend::Auto, Formulation::Position);
};

Mission flown(const Scenario& scenario, std::unique_ptr<TvpSolver> solver = nullptr)
{
    Mission mission(scenario, {}, std::move(solver));
    mission.advance(scenario.duration_s);
    return mission;
}

Row zetaAndVisits(const Mission& mission)
{
    return {mission.metrics().zeta_m2s, static_cast<double>(mission.metrics().visits)};
}

} // namespace

void wind(int scenarios)
{
    std::printf("%-24s %11s %11s\n", "wind", "zeta", "visits");
    for (const PolicyKind policy : {PolicyKind::Visitation, PolicyKind::Latency, PolicyKind::Path})
        for (const double wind_mps : {0.0, 5.0, 10.0, 15.0}) {
            std::vector<Row> unknown;
            std::vector<Row> known;
            for (int seed = 1; seed <= scenarios; ++seed) {
                Scenario scenario = randomScenario(seed);
                scenario.planner.policy = policy;
                scenario.wind_mps = {wind_mps, 0};
                known.push_back(zetaAndVisits(flown(scenario)));
                unknown.push_back(
                    zetaAndVisits(flown(scenario, std::make_unique<WindlessSolver>())));
            }
            std::printf("%s, %g m/s\n", nameOf(kPolicyNames, policy).c_str(), wind_mps);
            printMeans("  not planned with", unknown);
            printMeans("  planned with", known);
            printDifference("  zeta", unknown, known);
        }
}

void asset(int scenarios)
{
    std::printf("%-24s %11s %11s %11s %11s\n", "gain", "zeta", "weighted", "sigma near",
                "visits near");
    constexpr double kRange_m = 1500;
    std::vector<std::vector<Row>> all;
    for (const double gain : {0.0, 2.0, 5.0, 10.0}) {
        std::vector<Row> rows;
        for (int seed = 1; seed <= scenarios; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.asset = Asset{.position_m = {1000, 1000}, .range_m = kRange_m, .gain = gain};
            const Mission mission = flown(scenario);
            // Near means inside the asset's range, by true position.
            const Recorder& recorder = mission.recorder();
            double near_m2 = 0;
            int nearCount = 0;
            double weighted = 0;
            for (std::size_t row = 0; row < recorder.samples().size(); ++row) {
                weighted += recorder.samples()[row].weightedSum_m2;
                for (const IcebergSample& iceberg : recorder.icebergs(row))
                    if ((iceberg.truth_m - scenario.asset->position_m).norm() < kRange_m) {
                        near_m2 += iceberg.sigma_m2;
                        ++nearCount;
                    }
            }
            int visits = 0;
            for (const MissionEvent& event : mission.events())
                if (event.kind == EventKind::Reached) {
                    const Point there_m = scenario.icebergs[toIndex(*event.iceberg)].position_m;
                    visits += (there_m - scenario.asset->position_m).norm() < kRange_m;
                }
            rows.push_back({mission.metrics().zeta_m2s, weighted,
                            nearCount > 0 ? near_m2 / nearCount : 0, static_cast<double>(visits)});
        }
        std::printf("%-3g", gain);
        printMeans("", rows);
        all.push_back(rows);
        if (all.size() > 1) {
            printDifference("  zeta", all.front(), rows, 0);
            printDifference("  sigma near the asset", all.front(), rows, 2);
        }
    }
}

void area(int scenarios)
{
    std::printf("%-24s %11s %11s\n", "leavers", "zeta inside", "visits");
    std::vector<Row> kept;
    std::vector<Row> dropped;
    for (int seed = 1; seed <= scenarios; ++seed) {
        Scenario scenario = randomScenario(seed);
        scenario.duration_s = 2000;
        for (Iceberg& iceberg : scenario.icebergs)
            iceberg.velocity_mps *= 4; // up to 1.6 m/s, so that some icebergs leave
        const std::vector<Point> area_m{{0, 0}, {5000, 0}, {5000, 4000}, {0, 4000}};
        // Both are judged by the icebergs truly inside.
        const auto row = [&](const Mission& mission) {
            double zeta_m2s = 0;
            for (std::size_t k = 0; k < mission.recorder().samples().size(); ++k)
                for (const IcebergSample& iceberg : mission.recorder().icebergs(k))
                    if (insidePolygon(area_m, iceberg.truth_m))
                        zeta_m2s += iceberg.sigma_m2; // one sample per second
            return Row{zeta_m2s, static_cast<double>(mission.metrics().visits)};
        };
        kept.push_back(row(flown(scenario)));
        scenario.area_m = area_m;
        dropped.push_back(row(flown(scenario)));
    }
    printMeans("flown to all the same", kept);
    printMeans("dropped", dropped);
    printDifference("zeta inside", kept, dropped);
}

void autopilot(int scenarios)
{
    std::printf("%-24s %11s %11s\n", "autopilot, planner", "zeta", "visits");
    std::vector<Row> ideal;
    const auto fly = [&](const char* name, double autopilot_s, double planning_s) {
        std::vector<Row> rows;
        for (int seed = 1; seed <= scenarios; ++seed) {
            Scenario scenario = randomScenario(seed);
            scenario.uavs[0].spec.autopilot_s = autopilot_s;
            scenario.planningTime_s = planning_s;
            rows.push_back(zetaAndVisits(flown(scenario)));
        }
        printMeans(name, rows);
        if (ideal.empty())
            ideal = rows;
        else
            printDifference("  zeta", ideal, rows);
    };
    fly("each step, at once", 0, 0);
    fly("each second, at once", 1, 0);
    fly("each step, 2 s late", 0, 2);
    fly("each step, 10 s late", 0, 10);
    fly("each step, 30 s late", 0, 30);
}

} // namespace berg::bench
