#include "app/cli/commands.h"
#include "app/cli/flight_files.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/bound/zeta_bound.h"
#include "core/checks/validate.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/result_json.h"
#include "core/io/results/weather_result.h"
#include "core/io/text/atomic_file.h"
#include "core/mission/flight_places.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

namespace berg::cli {

namespace {

struct SimulateArguments
{
    std::string file;
    std::optional<double> tau;
    std::optional<PolicyKind> policy;
    std::optional<double> duration_s;
    std::optional<double> dt_s;
    std::optional<std::int64_t> seed;
    bool noNoise = false;
    bool bound = false;
    std::string outputFolder;
    bool force = false;
    bool json = false;

    [[nodiscard]] bool changesScenario() const
    {
        return tau || policy || duration_s || dt_s || seed || noNoise;
    }
};

/** The scenario with the changes of the command line; faults name the option's field. */
Scenario changed(Scenario scenario, const SimulateArguments& arguments)
{
    scenario.planner.tau = arguments.tau.value_or(scenario.planner.tau);
    scenario.planner.policy = arguments.policy.value_or(scenario.planner.policy);
    scenario.duration_s = arguments.duration_s.value_or(scenario.duration_s);
    scenario.dt_s = arguments.dt_s.value_or(scenario.dt_s);
    scenario.seed = arguments.seed.value_or(scenario.seed);
    scenario.noise = scenario.noise && !arguments.noNoise;
    return scenario;
}

/** A flight and the files that are being written of it. */
struct Flown
{
    std::unique_ptr<FlightFiles> files; ///< null if no files were requested
    Mission mission;
    FlightPlaces places = {};
};

std::unique_ptr<FlightFiles> filesOf(const SimulateArguments& arguments, const Scenario& scenario,
                                     std::span<const Intervention> changes)
{
    if (arguments.outputFolder.empty())
        return nullptr;
    return std::make_unique<FlightFiles>(arguments.outputFolder, scenario, changes);
}

Flown flyScenario(const SimulateArguments& arguments, const std::string& text,
                  const std::stop_token& stop)
{
    const Scenario scenario =
        reading([&] { return changed(scenarioFromJson(text, arguments.file), arguments); });
    if ((arguments.dt_s || arguments.duration_s) && scenario.dt_s > scenario.duration_s)
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--dt, --duration: the time step is longer than the duration"));
    if (arguments.policy == PolicyKind::Latency && scenario.planner.backend == Backend::Cbc)
        throw wrongOptions("--policy", {IssueId::CbcLatency});
    printWarnings(arguments.file, validate(scenario));
    MissionOptions options;
    options.record = !arguments.outputFolder.empty();
    Flown flown{.files = nullptr,
                .mission = naming(arguments.file, [&] { return Mission(scenario, options); })};
    flown.files = filesOf(arguments, scenario, {});
    if (flown.files)
        flown.mission.streamSamplesTo(flown.files->sink());
    ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "flying"), {}), !arguments.json);
    flown.places.note(flown.mission.simulation());
    const auto status = flown.mission.advance(scenario.duration_s, stop, [&](double time_s) {
        bar.update(time_s / scenario.duration_s);
        flown.places.note(flown.mission.simulation());
    });
    flown.places.finish(flown.mission.simulation());
    if (status == AdvanceStatus::Cancelled)
        throw Interrupted{};
    return flown;
}

/** Flies a run file again and checks it against what it recorded. */
Flown replayRun(const SimulateArguments& arguments, const std::string& text,
                const std::stop_token& stop)
{
    if (arguments.changesScenario())
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "a run file is replayed exactly as flown; --tau, --policy, --duration, "
                           "--dt, --seed and --no-noise apply to scenarios only"));
    const RunFile run = reading([&] { return runFromJson(text, arguments.file); });
    std::unique_ptr<FlightFiles> files = filesOf(arguments, run.scenario, run.interventions);
    ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "replaying"), {}), !arguments.json);
    const auto show = [&](double time_s) {
        bar.update(run.flownUntil_s > 0 ? time_s / run.flownUntil_s : 1);
    };
    FlightPlaces places;
    const SampleSink toFiles = files ? files->sink() : SampleSink();
    const SampleSink sink = [&](const Sample& sample, std::span<const IcebergSample> icebergs) {
        places.note(sample);
        if (toFiles)
            toFiles(sample, icebergs);
    };
    Mission mission = naming(arguments.file, [&] { return replay(run, stop, show, sink); });
    if (stop.stop_requested())
        throw Interrupted{};
    if (std::vector<Issue> issues = compareRun(run, runOf(mission)); !issues.empty())
        throw Error(ErrorCode::ReplayMismatch, arguments.file, std::move(issues));
    places.finish(mission.simulation());
    return {.files = std::move(files), .mission = std::move(mission), .places = std::move(places)};
}

/** Returns a lower bound on the zeta of any flight at the time reached; nullopt if it was
 * interrupted. */
std::optional<BoundPoint> lowerBound(const Mission& mission, bool quiet,
                                     const std::stop_token& stop)
{
    const auto isAny = [&mission](auto member) {
        return std::ranges::any_of(mission.interventions(), [member](const Intervention& change) {
            return (change.*member).has_value();
        });
    };
    if (isAny(&Intervention::seen))
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--bound does not apply to runs with reported sightings"));
    if (isAny(&Intervention::wind_mps))
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--bound does not apply to runs in which the wind changed"));
    if (isAny(&Intervention::removed))
        throw UsageError(QT_TRANSLATE_NOOP(
            "CommandLine", "--bound does not apply to runs from which an iceberg was removed"));
    ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "bounding"), {}), !quiet);
    const ZetaBound bound = zetaLowerBound(
        mission.scenario(), {.stop = stop, .onProgress = [&](const BoundProgress& progress) {
                                 bar.update(progress.share);
                             }});
    if (bound.cancelled)
        return std::nullopt;
    return bound.by(mission.simulation().time_s());
}

/** Visits and distance of each UAV, and the least distance between two of them. */
std::string fleetLines(const Mission& mission)
{
    std::string text;
    for (const UavFigures& uav : uavFigures(mission))
        text += rowLabel(uav.id) + std::to_string(uav.visits) + " visits, " + grouped(uav.flown_m) +
                " m\n";
    if (const std::optional<double> closest_m = mission.simulation().fleet().closest_m())
        text += "closest   " + grouped(*closest_m) + " m between two UAVs of one altitude layer\n";
    return text;
}

std::string boundLine(const BoundPoint& bound, double zeta_m2s)
{
    return (isUsefulBound(bound.zeta_m2s, zeta_m2s)
                ? "bound     lower bound on zeta "
                : "bound     no useful lower bound on zeta; proven are ") +
           grouped(bound.zeta_m2s) + " m2 s, from visit " +
           (bound.isFromRates ? "rates" : "sequences") + '\n';
}

std::string summary(const Mission& mission, const std::optional<BoundPoint>& bound,
                    const std::optional<WeatherVerdict>& weather, double elapsed_s, bool replayed)
{
    const Metrics metrics = mission.metrics();
    const Scenario& scenario = mission.scenario();
    std::string text = scenario.name.empty() ? "" : word(scenario.name) + '\n';
    text += "zeta      " + grouped(metrics.zeta_m2s) + " m2 s\n";
    if (bound)
        text += boundLine(*bound, metrics.zeta_m2s);
    text += "visits    " + std::to_string(metrics.visits) + "   plans " +
            std::to_string(metrics.replans) + "\nflown     " + grouped(metrics.flown_m) + " m in " +
            grouped(mission.simulation().time_s()) + " s  (policy " +
            nameOf(kPolicyNames, scenario.planner.policy) + ", tau " +
            fixed(scenario.planner.tau, 2) + ")\ncomputed  in " + fixed(elapsed_s, 3) + " s\n";
    text += fleetLines(mission);
    std::string events;
    for (const auto& [name, count] : worldEvents(mission))
        events += (events.empty() ? "events    " : ", ") + std::to_string(count) + ' ' + name;
    if (!events.empty())
        text += events + '\n';
    if (weather)
        text += "weather   " + word(weatherLine(scenario, *weather)) + '\n';
    if (replayed)
        text += "replay    equal to the recorded run\n";
    return text;
}

int simulate(const SimulateArguments& arguments, const std::stop_token& stop)
{
    const Stopwatch watch;
    const std::string& folder = arguments.outputFolder;
    if (folder == "-")
        throw UsageError(kNoStream, {"--output"});
    checkFiles({.inputs = {arguments.file},
                .outputs = outputsIn("--output", folder, FlightFiles::kNames),
                .force = arguments.force});
    const std::string text = reading([&] { return readFile(arguments.file); });
    const bool replayed = formatOf(text, arguments.file) == "bergwatch-run";
    const Flown flown =
        replayed ? replayRun(arguments, text, stop) : flyScenario(arguments, text, stop);
    const Mission& mission = flown.mission;
    std::optional<BoundPoint> bound;
    std::optional<double> bound_m2s;
    if (arguments.bound)
        bound = lowerBound(mission, arguments.json, stop);
    if (bound)
        bound_m2s = bound->zeta_m2s;
    std::optional<WeatherVerdict> weather;
    if (hasWeatherLimits(mission.scenario()))
        weather = weatherAlong(mission.scenario(), flown.places.flights());
    const std::string result = arguments.json
                                   ? simulateJson(mission, bound_m2s, watch.elapsed_s(), weather)
                                   : summary(mission, bound, weather, watch.elapsed_s(), replayed);
    deliver(result, [&flown] {
        if (!flown.files)
            return;
        flown.files->add(flown.mission);
        flown.files->set().write();
    });
    if (!arguments.bound || bound_m2s)
        return kDone;
    printMessage(said(
        QT_TRANSLATE_NOOP("CommandLine",
                          "interrupted: the flight is complete, but its lower bound is missing"),
        {}));
    return kInterrupted;
}

} // namespace

void addSimulateCommand(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand(
        "simulate", "Fly a scenario and measure zeta, or replay and check a run");
    SimulateArguments& a = argumentsOf(*command, action, simulate);
    command->add_option("FILE", a.file, "Scenario (.berg) or run (.bergrun)")->required();
    command->add_option("-t,--tau", a.tau, "Trade-off of the policy visitation (the scenario's)")
        ->check(numberFrom(0.0, 100.0));
    addNamed(*command, "--policy", a.policy, kPolicyNames,
             "How the next iceberg is chosen (the scenario's)");
    command->add_option("--duration", a.duration_s, "Seconds of flight (the scenario's)")
        ->check(numberFrom(1e-9, 604800.0));
    command->add_option("--dt", a.dt_s, "Time step, s (the scenario's)")
        ->check(numberFrom(0.01, 1.0));
    command->add_option("--seed", a.seed, "Seed of the noise (the scenario's)")
        ->transform(wholeFrom(0, std::int64_t{1} << 53));
    command->add_flag("--no-noise", a.noNoise, "Icebergs move only with their known velocity");
    command->add_flag("--bound", a.bound,
                      "Also find a lower bound on zeta of any flight of the scenario");
    command->add_option("-o,--output", a.outputFolder,
                        "Folder for tables and the run file (none is written)");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
