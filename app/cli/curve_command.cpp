#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/checks/validate.h"
#include "core/io/files/certificate_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/curve_result.h"
#include "core/mission/mission.h"
#include "core/mission/plan_requests.h"
#include "core/plan/policy/fleet_task.h"
#include "core/plan/policy/tau_curve.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

namespace berg::cli {

namespace {

struct CurveArguments
{
    std::string file;
    double tauMax = 5;
    std::string outputFile;
    std::string certificateFile;
    bool force = false;
    bool json = false;
};

std::string uavId(const CurveReport& report, std::size_t order)
{
    return word(report.scenario.uavs[static_cast<std::size_t>(report.uavs[order])].id);
}

std::string curveTable(const CurveReport& report)
{
    std::vector<std::vector<std::string>> rows{
        {"tau from", "tau to", "whole order m", "reward m2", "proven", "order"}};
    for (const CurveInterval& interval : report.curve.intervals) {
        std::string order;
        for (std::size_t k = 0; k < interval.plan.size(); ++k) {
            order += k == 0 ? std::string() : ' ' + std::string(kBetweenOrders);
            for (const int number : icebergNumbers(report, interval.plan[k]))
                order += (order.empty() ? "" : " ") + std::to_string(number);
        }
        rows.push_back({fixed(interval.tauFrom, 5), fixed(interval.tauTo, 5),
                        grouped(interval.distance_m), fixed(interval.reward_m2, 2),
                        interval.proven ? "yes" : "no", std::move(order)});
    }
    std::string text = tableLines(rows, rows.front().size() - 1);
    text += "order: icebergs by their place in the scenario, 1 is the first";
    for (std::size_t k = 1; k < report.uavs.size(); ++k)
        text += (k == 1 ? "; those of " + uavId(report, 0) + " | " : " | ") + uavId(report, k);
    return text + '\n';
}

/** Every order at both ends of its interval: optimal there, it is optimal between, because F is
 * linear in tau and the optimum concave. */
Certificate certificateOf(const FleetTask& task, const TauCurve& curve, const std::stop_token& stop)
{
    FleetProblem problem = task.problem;
    Certificate certificate{.problem = problem};
    const double muPerTau = fleetTuningWeight(problem, task.betweenStarts_m, 1).mu;
    for (const CurveInterval& interval : curve.intervals)
        for (const double tau : {interval.tauFrom, interval.tauTo}) {
            problem.mu = muPerTau * tau;
            certificate.proofs.push_back(certify(problem, interval.plan, stop));
        }
    return certificate;
}

int runCurve(const CurveArguments& arguments, const std::stop_token& stop)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--output", .path = arguments.outputFile},
                            {.option = "--certificate", .path = arguments.certificateFile}},
                .force = arguments.force,
                .json = arguments.json});
    const Scenario scenario = reading([&] { return loadScenario(arguments.file); });
    printWarnings(arguments.file, validate(scenario));
    const Mission mission(scenario, {.record = false});
    const PlanRequest request = clusteredRequest(mission.simulation());
    const FleetTask task = visitationTask(request, scenario.planner.route);
    if (!arguments.certificateFile.empty() && task.ids.empty())
        throw Error(ErrorCode::Unsupported, arguments.file, {IssueId::NoProblemSolved});

    const Stopwatch watch;
    TauCurve curve;
    {
        ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "proving the curve"), {}),
                        !arguments.json);
        curve = tauCurve(
            task.problem, task.betweenStarts_m,
            {.tauMax = arguments.tauMax, .stop = stop, .onProgress = [&bar](const TauCurve& known) {
                 const auto proven = std::count_if(known.intervals.begin(), known.intervals.end(),
                                                   [](const CurveInterval& i) { return i.proven; });
                 bar.update(static_cast<double>(proven) /
                            static_cast<double>(known.intervals.size()));
             }});
    }
    if (curve.reason == StopReason::Cancelled)
        throw Interrupted{};
    std::vector<int> uavs;
    for (const int uav : task.uavs)
        uavs.push_back(request.uavs[static_cast<std::size_t>(uav)].uav);
    const CurveReport report{.curve = curve,
                             .scenario = scenario,
                             .ids = task.ids,
                             .uavs = uavs,
                             .clusters = request.clusters};
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile, .content = curveCsv(report)});
    if (!arguments.certificateFile.empty()) {
        const Certificate certificate = certificateOf(task, curve, stop);
        files.push_back(
            {.path = arguments.certificateFile, .content = certificateJson(certificate)});
    }
    if (stop.stop_requested())
        throw Interrupted{};
    deliver(files, arguments.json ? curveJson(report, watch.elapsed_s()) : curveTable(report));
    return kDone;
}

} // namespace

void addCurveCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("curve", "All optimal plans from a scenario's start, for every tau "
                                    "from 0 to --tau-max (5)");
    CurveArguments& a = argumentsOf(*command, action, runCurve);
    command->add_option("SCENARIO", a.file, "The file to plan from")->required();
    command->add_option("--tau-max", a.tauMax, "Largest trade-off (5)")
        ->check(numberFrom(1e-6, 100.0));
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the table");
    addOutputFile(*command, "--certificate", a.certificateFile,
                  "File for proofs of the orders, for independent checking");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
