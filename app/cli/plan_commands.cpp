#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/checks/validate.h"
#include "core/io/files/certificate_json.h"
#include "core/io/files/problem_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/results/plan_result.h"
#include "core/mission/mission.h"
#include "core/plan/problem/tuning.h"
#include "core/plan/solve/latency_problem.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

namespace berg::cli {

namespace {

/** Options of both `solve` and `plan`. */
struct SolveArguments
{
    std::string file;
    std::optional<double> tau;
    std::optional<double> mu;           ///< `solve` alone
    std::optional<Criterion> criterion; ///< the same
    bool countsReturn = false;          ///< the same
    std::optional<PolicyKind> policy;   ///< `plan` alone: a problem file has none
    std::optional<Backend> backend;
    std::optional<Formulation> formulation;
    std::optional<Route> route;
    bool verify = false;
    std::optional<double> timeLimit_s;
    std::optional<std::int64_t> workLimit;
    double gap = 0;
    std::string certificateFile;
    bool force = false;
    bool json = false;
};

/** How `solve` and `plan` differ: what is in the file, and what holds where nothing is given. */
struct FileWords
{
    std::string name;
    std::string solver;
    std::string formulation;
    bool isProblem = false; ///< it may be judged by latency, and takes mu in place of tau
};

void addArguments(CLI::App& command, SolveArguments& a, const FileWords& words)
{
    const std::string unlimited =
        "(none; auto and heuristic stop after about one second of computing, exact at the proof)";
    command
        .add_option(words.name, a.file,
                    words.isProblem
                        ? "The file to plan from: a problem, or a TSPLIB instance (.tsp, .atsp), "
                          "whose node 1 is the start"
                        : "The file to plan from")
        ->required();
    command
        .add_option("-t,--tau", a.tau,
                    "Trade-off: 0 most uncertain first, large shortest path (the file's)")
        ->check(numberFrom(0.0, 100.0));
    if (words.isProblem) {
        command.add_option("--mu", a.mu, "Distance weight, instead of tau (the file's)")
            ->check(numberFrom(0.0, kLargestProblemNumber));
        addNamed(command, "--criterion", a.criterion, kCriterionNames,
                 "Objective of the order (visitation); latency is the sum of sigma times the "
                 "distance flown until there, each place counted once where all sigmas are 0");
        command.add_flag("--return", a.countsReturn,
                         "With latency: count the return to the start as arrival at one more "
                         "place of sigma 1");
    }
    addNamed(command, "--backend", a.backend, kBackendNames, "Solver (" + words.solver + ')');
    addNamed(command, "--formulation", a.formulation, kFormulationNames,
             "MILP of cbc (" + words.formulation +
                 "); of --verify (position up to 16 icebergs, reduced beyond)");
    addNamed(command, "--route", a.route, kRouteNames, "Path or round trip (the file's)");
    command.add_flag("--verify", a.verify, "Solve with a second, independent solver and compare");
    command.add_option("--time-limit", a.timeLimit_s, "Seconds " + unlimited)
        ->check(numberFrom(0.0, 1e9));
    command
        .add_option("--work-limit", a.workLimit,
                    "Solver steps, the same result every time " + unlimited)
        ->transform(wholeFrom(0, std::int64_t{1} << 60));
    command.add_option("--gap", a.gap, "Stop within this relative gap, such as 0.01 (0)")
        ->check(numberFrom(0.0, 1.0));
    addOutputFile(command, "--certificate", a.certificateFile,
                  "File for a proof of the bound, for independent checking");
    addForce(command, a.force);
    command.add_flag("--json", a.json, "Print one JSON document");
}

SolveOptions optionsOf(const SolveArguments& arguments, const std::stop_token& stop)
{
    return {.timeLimit_s = arguments.timeLimit_s,
            .workLimit = arguments.workLimit,
            .gap = arguments.gap,
            .stop = stop};
}

std::string provenWords(SolveStatus status, std::optional<double> gap)
{
    if (status == SolveStatus::Optimal)
        return "proven optimal";
    return gap ? "within " + fixed(100 * *gap, 2) + " % of optimal" : "not proven, no bound";
}

std::string solverWords(const FleetProblem& problem, const SolveOutcome& outcome)
{
    std::optional<double> gap;
    if (outcome.bound)
        gap = relativeGap(problem, outcome.objective, *outcome.bound);
    return provenWords(outcome.status, gap);
}

std::string noPlan(const SolveOutcome& outcome)
{
    return "No plan: " + (outcome.detail.empty() ? "a limit came first" : outcome.detail) + '\n';
}

/** "cbc" or, when it matters, "cbc (reduced)". */
std::string nameOfSecond(const SecondOpinion& second)
{
    std::string name = nameOf(kSourceNames, second.outcome.source);
    if (second.formulation)
        name += " (" + nameOf(kFormulationNames, *second.formulation) + ')';
    return name;
}

/** Why the second opinion is none. */
std::string whyNotVerified(const PlanReport& report)
{
    const SolveOutcome& second = report.secondOpinion->outcome;
    switch (second.reason) {
    case StopReason::TimeLimit:
        return "came to the time limit";
    case StopReason::MemoryLimit:
        return "came to the memory limit";
    case StopReason::Unable:
        return "cannot: " + second.detail;
    case StopReason::Cancelled:
    case StopReason::WorkLimit:
    case StopReason::GapReached:
    case StopReason::Finished:
        break;
    }
    return second.status == SolveStatus::Optimal ? "proves that a better order exists"
                                                 : "gave no proof";
}

std::string verificationLine(const PlanReport& report)
{
    const SecondOpinion& second = *report.secondOpinion;
    std::string text = "verify     ";
    switch (second.verdict) {
    case Verdict::Agrees:
        text += "agrees: " + nameOfSecond(second);
        break;
    case Verdict::Disagrees:
        text += "DISAGREES: " + nameOfSecond(second);
        break;
    case Verdict::NotVerified:
        text += "not verified: " + nameOfSecond(second) + ' ' + whyNotVerified(report);
        break;
    }
    if (second.outcome.status != SolveStatus::None)
        text += ", objective " + fixed(second.outcome.objective, 3) + " (" +
                solverWords(report.plan.problem, second.outcome) + ", " +
                fixed(1000 * second.outcome.elapsed_s, 1) + " ms)";
    return text + '\n';
}

/** Ids, or the numbers of a bare problem. */
std::string orderWords(const PlanReport& report, const UavPlan& uav)
{
    std::string text;
    for (const std::string& id : report.idsOf(uav.order))
        text += ' ' + word(id);
    if (report.scenario == nullptr)
        for (const int number : report.numbersOf(uav.order))
            text += ' ' + std::to_string(number);
    return text;
}

/** A line for each UAV; the only one needs no name. */
std::string orderLines(const PlanReport& report)
{
    const std::vector<UavPlan>& uavs = report.plan.uavs;
    if (const UavPlan& only = uavs.front(); uavs.size() == 1)
        return "order     " + orderWords(report, only) + '\n' +
               (only.thisSortie
                    ? "sortie     the first " + std::to_string(*only.thisSortie) + ", then home\n"
                    : "");
    std::string text;
    for (std::size_t k = 0; k < uavs.size(); ++k) {
        const UavLength& length = report.lengths[k];
        text += rowLabel(report.uavId(k)) + orderWords(report, uavs[k]) + "  (" +
                grouped(length.distance_m) + " m";
        if (uavs[k].thisSortie)
            text += ", the first " + std::to_string(*uavs[k].thisSortie) + ", then home";
        if (length.slot_s)
            text += ", recovery slot " + grouped(*length.slot_s) + " s";
        text += ")\n";
    }
    return text;
}

constexpr std::array<Named<LengthKind>, 3> kPathNames{{
    {LengthKind::Order, "whole order, straight"},
    {LengthKind::Round, "whole round, straight"},
    {LengthKind::Flight, "as flown, with turns"},
}};

std::string reportText(const PlanReport& report, bool json)
{
    if (json)
        return planJson(report);
    const SolveOutcome& outcome = report.plan.outcome;
    if (outcome.status == SolveStatus::None)
        return noPlan(outcome);
    std::string text = orderLines(report);
    for (const IcebergList& members : report.clusters()) {
        text += "together  ";
        for (const std::string& id : report.idsOf(members))
            text += ' ' + word(id);
        text += '\n';
    }
    const std::optional<double> objective = report.objective();
    text += "objective  " + (objective ? fixed(*objective, 3) : std::string("none")) + "  (" +
            solverWords(report.plan.problem, outcome) + ", " + fixed(1000 * outcome.elapsed_s, 1) +
            " ms, " + nameOf(kSourceNames, outcome.source) + ")\ndistance   " +
            grouped(report.distance_m) + " m  (" + nameOf(kPathNames, report.path) + ")" +
            (report.mu() ? "   mu " + fixed(*report.mu(), 6) : std::string()) + '\n';
    if (report.secondOpinion)
        text += verificationLine(report);
    if (report.weather)
        text += "weather    " + word(report.weatherLine) + '\n';
    return text;
}

void checkOutcome(const SolveOutcome& outcome, const std::string& file)
{
    if (outcome.reason == StopReason::Cancelled)
        throw Interrupted{};
    if (outcome.reason == StopReason::Unable)
        throw Error(ErrorCode::Unsupported, file,
                    {outcome.whyUnable.value_or(IssueReason{IssueId::Verbatim, {outcome.detail}})});
}

/** Proves the plan anew. */
NewFile certificateOf(const PlanReport& report, const SolveArguments& arguments,
                      const std::stop_token& stop)
{
    const Certificate certificate{
        .problem = report.plan.problem,
        .proofs = {certify(report.plan.problem, report.plan.outcome.plan, stop)}};
    if (stop.stop_requested())
        throw Interrupted{};
    return {.path = arguments.certificateFile, .content = certificateJson(certificate)};
}

void checkSolveFiles(const SolveArguments& arguments)
{
    checkFiles({.inputs = {arguments.file},
                .outputs = {{.option = "--certificate", .path = arguments.certificateFile}},
                .force = arguments.force,
                .json = arguments.json});
}

/** Fixed routes that go on and the plans of several UAVs with aim points solve none. */
void checkProblem(const PlanReport& report, const SolveArguments& arguments)
{
    const bool certifies = !arguments.certificateFile.empty();
    if (report.plan.outcome.status == SolveStatus::None || (!certifies && !arguments.verify))
        return;
    if (isFleetPlan(report.plan.problem, report.plan.outcome.plan) &&
        (!certifies || report.plan.problem.icebergCount() > 0))
        return;
    if (arguments.policy)
        throw wrongOptions(arguments.verify ? "--policy, --verify" : "--policy, --certificate",
                           {IssueId::NoProblemSolved});
    throw Error(ErrorCode::Unsupported, arguments.file, {IssueId::NoProblemSolved});
}

int conclude(PlanReport& report, const SolveArguments& arguments, const SolveOptions& options)
{
    checkOutcome(report.plan.outcome, arguments.file);
    checkProblem(report, arguments);
    if (arguments.verify)
        report.secondOpinion =
            secondOpinion(report.plan.problem, report.plan.outcome, options, arguments.formulation);
    if (report.secondOpinion && report.secondOpinion->outcome.reason == StopReason::Cancelled)
        throw Interrupted{};
    std::vector<NewFile> files;
    if (!arguments.certificateFile.empty() && report.plan.outcome.status != SolveStatus::None)
        files.push_back(certificateOf(report, arguments, options.stop));
    deliver(files, reportText(report, arguments.json));
    if (report.plan.outcome.status == SolveStatus::None)
        return kLimitWithoutPlan;
    if (!report.secondOpinion || report.secondOpinion->verdict != Verdict::Disagrees)
        return kDone;
    printMessage(said(
        QT_TRANSLATE_NOOP(
            "CommandLine",
            "%1: %2 and %3 contradict each other. One of the two is wrong; do not use this order."),
        {arguments.file, nameOf(kSourceNames, report.plan.outcome.source),
         nameOfSecond(*report.secondOpinion)}));
    return kFailure;
}

/** Options of `solve` that contradict each other. */
void checkProblemOptions(const SolveArguments& arguments)
{
    const auto exclude = [](const std::string& one, const std::string& other) {
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"), {one, other});
    };
    if (arguments.tau && arguments.mu)
        exclude("--tau", "--mu");
    const std::string latency = "--criterion latency";
    if (arguments.criterion != Criterion::Latency) {
        if (arguments.countsReturn)
            exclude("--return", "--criterion visitation");
        return;
    }
    if (arguments.tau)
        exclude(latency, "--tau");
    if (arguments.route)
        exclude(latency, "--route");
    if (arguments.backend == Backend::Cbc)
        throw wrongOptions("--criterion, --backend", {IssueId::CbcLatency});
    if (arguments.verify && arguments.formulation)
        throw wrongOptions("--criterion, --formulation", {IssueId::CbcLatency});
}

/** The problem of the file as the options have it. */
TvpProblem problemAsked(const TvpProblem& given, const SolveArguments& arguments)
{
    TvpProblem problem = given;
    problem.route = arguments.route.value_or(problem.route);
    if (arguments.criterion == Criterion::Latency)
        problem = latencyProblem(std::move(problem));
    if (arguments.tau)
        problem.mu = tuningWeight(problem, *arguments.tau).mu;
    if (arguments.mu)
        problem.mu = *arguments.mu;
    return problem;
}

/** Refuses icebergs that may be visited after the return, as nothing is lost by it. */
void checkReturn(const TvpProblem& problem, const std::string& file)
{
    std::vector<Issue> issues;
    for (std::size_t i = 1; i < problem.sigma_m2.size(); ++i)
        if (std::optional<IssueReason> fault = outOfLimits(
                problem.sigma_m2[i], {.low = 0, .high = kLargestProblemNumber, .above = true}))
            issues.push_back({Severity::Error, entryPath("sigma", i), std::move(*fault)});
    if (!issues.empty())
        throw Error(ErrorCode::InvalidInput, file, std::move(issues));
}

/** The answer to a problem; `order` is without the return. */
struct SolvedProblem
{
    FleetProblem problem;
    SolveOutcome outcome;
    VisitOrder order;
    double distance_m = 0;
};

SolvedProblem solved(TvpProblem problem, const TvpSolver& solver, const SolveOptions& options,
                     bool countsReturn)
{
    const TvpProblem asked = countsReturn ? withReturn(problem) : problem;
    SolvedProblem result{
        .problem = problemOf(asked), .outcome = solver.solve(asked, options), .order = {}};
    if (countsReturn) {
        putReturnLast(asked, result.outcome);
        problem.route = Route::Closed;
    }
    result.order = result.outcome.order();
    if (countsReturn && !result.order.empty())
        result.order.pop_back();
    result.distance_m = flownDistance(problem, result.order);
    return result;
}

int solveProblem(const SolveArguments& arguments, const std::stop_token& stop)
{
    checkProblemOptions(arguments);
    checkSolveFiles(arguments);
    const ProblemFile file = reading([&] { return loadProblem(arguments.file); });
    printWarnings(arguments.file, file.hints);
    const TvpProblem problem = problemAsked(file.problem, arguments);
    if (arguments.countsReturn)
        checkReturn(problem, arguments.file);
    const SolveOptions options = optionsOf(arguments, stop);
    const auto solver = makeSolver(arguments.backend.value_or(Backend::Auto),
                                   arguments.formulation.value_or(Formulation::Position));
    SolvedProblem answer = solved(problem, *solver, options, arguments.countsReturn);
    UavPlan only;
    for (const NodeIndex node : answer.order)
        only.order.push_back(IcebergIndex::of(node.number() - 1));
    PlanReport report{.plan = {.uavs = {std::move(only)},
                               .outcome = std::move(answer.outcome),
                               .problem = std::move(answer.problem)},
                      .distance_m = answer.distance_m,
                      .firstNumber = file.isTsplib ? 2 : 1}; // its first node is the start
    return conclude(report, arguments, options);
}

/** Reports a problem that does not depend on options as an error of the file. */
void checkChoices(const SolveArguments& arguments, const PlannerSettings& planner)
{
    if ((arguments.policy || arguments.backend) && planner.policy == PolicyKind::Latency &&
        planner.backend == Backend::Cbc)
        throw wrongOptions("--policy, --backend", {IssueId::CbcLatency});
    if (arguments.verify && arguments.formulation && planner.policy == PolicyKind::Latency)
        throw wrongOptions("--verify, --formulation", {IssueId::CbcLatency});
}

int planScenario(const SolveArguments& arguments, const std::stop_token& stop)
{
    checkSolveFiles(arguments);
    Scenario scenario = reading([&] { return loadScenario(arguments.file); });
    PlannerSettings& planner = scenario.planner;
    planner.tau = arguments.tau.value_or(planner.tau);
    planner.route = arguments.route.value_or(planner.route);
    planner.policy = arguments.policy.value_or(planner.policy);
    planner.backend = arguments.backend.value_or(planner.backend);
    planner.formulation = arguments.formulation.value_or(planner.formulation);
    checkChoices(arguments, planner);
    printWarnings(arguments.file, validate(scenario));

    const SolveOptions options = optionsOf(arguments, stop);
    Plan plan = naming(arguments.file, [&] { return planFromStart(scenario, options); });
    checkOutcome(plan.outcome, arguments.file);
    PlanReport report = planReport(scenario, std::move(plan));
    return conclude(report, arguments, options);
}

} // namespace

void addPlanCommands(CLI::App& app, Action& action)
{
    CLI::App* solve = app.add_subcommand("solve", "Solve one path-planning problem");
    addArguments(
        *solve, argumentsOf(*solve, action, solveProblem),
        {.name = "PROBLEM", .solver = "auto", .formulation = "position", .isProblem = true});
    CLI::App* plan = app.add_subcommand("plan", "Plan the visiting order from a scenario's start");
    SolveArguments& scenario = argumentsOf(*plan, action, planScenario);
    addArguments(*plan, scenario,
                 {.name = "SCENARIO", .solver = "the scenario's", .formulation = "the scenario's"});
    addNamed(*plan, "--policy", scenario.policy, kPolicyNames,
             "How the order is chosen (the scenario's)");
}

} // namespace berg::cli
