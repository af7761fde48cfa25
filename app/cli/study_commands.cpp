#include "app/cli/commands.h"
#include "core/io/atomic_file.h"
#include "core/io/result_json.h"
#include "core/io/scenario_json.h"
#include "core/scenario/presets.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

namespace berg::cli {

namespace {

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);)
        parts.push_back(part);
    return parts;
}

double numberOf(const std::string& option, const std::string& text)
{
    double value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        throw UsageError{option + ": " + text + " is not a number"};
    return value;
}

/** "0:5:0.5" or "0,0.5,1" or both mixed; the end of a range is included. */
std::vector<double> tausOf(const std::string& text)
{
    constexpr std::size_t kMost = 100000;
    std::vector<double> taus;
    for (const std::string& part : split(text, ',')) {
        const std::vector<std::string> range = split(part, ':');
        const double first = numberOf("--tau", range.at(0));
        const double last = range.size() > 1 ? numberOf("--tau", range[1]) : first;
        const double step = range.size() > 2 ? numberOf("--tau", range[2]) : 1;
        if (range.size() == 2 || range.size() > 3 || !(step > 0) || first < 0 || last < first ||
            last > 100 || (last - first) / step > static_cast<double>(kMost))
            throw UsageError{"--tau: " + part + " is not A:B:STEP with 0 <= A <= B <= 100"};
        const auto count = static_cast<int>(std::floor((last - first) / step + 1e-9));
        for (int k = 0; k <= count; ++k)
            taus.push_back(first + k * step);
    }
    return taus;
}

struct SweepArguments
{
    std::vector<std::string> files;
    int random = 0;
    std::string taus;
    std::string policies = "visitation";
    int runs = 1;
    int threads = 0;
    std::string outputFile;
    bool json = false;
};

SweepSpec specOf(const SweepArguments& arguments)
{
    SweepSpec spec;
    for (const std::string& file : arguments.files)
        spec.scenarios.push_back(loadScenario(file));
    for (int seed = 1; seed <= arguments.random; ++seed)
        spec.scenarios.push_back(randomScenario(seed));
    if (spec.scenarios.empty())
        throw UsageError{"sweep: name scenarios, or give --random N"};
    for (const std::string& name : split(arguments.policies, ',')) {
        const auto policy = valueOf(kPolicyNames, name);
        if (!policy)
            throw UsageError{"--policies: " + name + " is none of " + allowedNames(kPolicyNames)};
        spec.policies.push_back(*policy);
    }
    spec.taus = tausOf(arguments.taus);
    spec.runs = arguments.runs;
    return spec;
}

std::string column(const std::string& text, std::size_t width)
{
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string sweepTable(const SweepResult& result)
{
    std::string text = "policy           tau      n      mean       +-    median    "
                       "25 %      75 %  stuck\n";
    for (const SweepRow& row : result.rows) {
        const Summary& s = row.summary;
        std::string policy = nameOf(kPolicyNames, row.policy);
        policy.resize(12, ' ');
        text += policy + column(row.tau ? fixed(*row.tau, 2) : "-", 8) +
                column(std::to_string(s.n), 7) + column(grouped(s.mean), 10) +
                column(grouped(s.standardError), 9) + column(grouped(s.median), 10) +
                column(grouped(s.quartile1), 10) + column(grouped(s.quartile3), 10) +
                column(fixed(100 * row.stuckShare, 1) + " %", 9) + '\n';
    }
    return text + "zeta in m2 s; stuck: two icebergs at most in the last half of the run\n";
}

int runSweep(const SweepArguments& arguments, const std::stop_token& stop)
{
    const SweepSpec spec = specOf(arguments);
    const auto count = static_cast<double>(missionCount(spec));
    ProgressBar bar("flying " + grouped(count) + " missions", !arguments.json);
    const Stopwatch watch;
    const SweepResult result = sweep(
        spec, {.threads = arguments.threads, .stop = stop, .onProgress = [&](std::size_t done) {
                   bar.update(static_cast<double>(done) / count);
               }});
    if (!result.complete)
        throw Interrupted{};
    if (!arguments.outputFile.empty())
        writeFileAtomically(arguments.outputFile, sweepCsv(result));
    print(arguments.json ? sweepJson(result, watch.elapsed_s()) : sweepTable(result));
    return kDone;
}

struct BenchmarkArguments
{
    std::vector<int> sizes{2, 6, 10, 12, 16, 20, 30, 40, 60, 80};
    int repeat = 10;
    std::string backends;
    double seconds = 60;
    std::string outputFile;
    bool json = false;
};

std::string millis(double seconds)
{
    return fixed(1000 * seconds, seconds < 0.01 ? 3 : 1);
}

/** How many times as fast as CPLEX. */
std::string speedUp(double paper_s, double ours_s)
{
    if (ours_s <= 0)
        return "-";
    const double ratio = paper_s / ours_s;
    return (ratio < 10 ? fixed(ratio, 1) : grouped(ratio)) + " x";
}

std::string paperColumns(const BenchmarkRow& row)
{
    for (const PaperTime& paper : paperTable2()) {
        if (paper.icebergs != row.icebergs || row.seconds.n == 0)
            continue;
        return column(fixed(paper.average_s, 2), 13) + column(fixed(paper.worst_s, 2), 11) +
               column(speedUp(paper.average_s, row.seconds.mean), 13) +
               column(speedUp(paper.worst_s, row.worst_s), 13);
    }
    return column("-", 13) + column("-", 11) + column("-", 13) + column("-", 13);
}

std::string benchmarkTable(const std::vector<BenchmarkRow>& rows)
{
    std::string text = "icebergs  solver         proven  average ms   median ms    worst ms  "
                       "worst gap  paper avg s    worst s     speed-up     at worst\n";
    for (const BenchmarkRow& row : rows) {
        std::string solver = nameOf(kBenchmarkSolverNames, row.solver);
        solver.resize(13, ' ');
        text += column(std::to_string(row.icebergs), 8) + "  " + solver;
        if (!row.note.empty()) {
            text += "  " + row.note + '\n';
            continue;
        }
        const bool timed = row.seconds.n > 0;
        text += column(std::to_string(row.proven) + '/' + std::to_string(row.instances), 8) +
                column(timed ? millis(row.seconds.mean) : "-", 12) +
                column(timed ? millis(row.seconds.median) : "-", 12) +
                column(timed ? millis(row.worst_s) : "-", 12) +
                column(row.worstGap ? fixed(100 * *row.worstGap, 2) + " %" : "-", 11) +
                paperColumns(row);
        text += row.cut > 0 ? "  " + std::to_string(row.cut) + " cut by the budget\n" : "\n";
    }
    return text + "Table 1 instances of the paper, tau 0.5; times of those that were not cut. The "
                  "paper's are CPLEX, 2015.\n";
}

std::vector<BenchmarkSolver> benchmarkSolversOf(const std::string& names)
{
    if (names.empty())
        return benchmarkSolvers();
    std::vector<BenchmarkSolver> solvers;
    for (const std::string& name : split(names, ',')) {
        const auto solver = valueOf(kBenchmarkSolverNames, name == "cbc" ? "cbc-position" : name);
        if (!solver)
            throw UsageError{"--backends: " + name + " is none of " +
                             allowedNames(kBenchmarkSolverNames)};
        solvers.push_back(*solver);
    }
    return solvers;
}

int benchmark(const BenchmarkArguments& arguments, const std::stop_token& stop)
{
    const BenchmarkSpec spec{.sizes = arguments.sizes,
                             .solvers = benchmarkSolversOf(arguments.backends),
                             .repeat = arguments.repeat,
                             .budget_s = arguments.seconds};
    std::vector<BenchmarkRow> rows;
    {
        ProgressBar bar("solving", !arguments.json);
        rows = runBenchmark(spec, stop, [&bar](const BenchmarkProgress& progress) {
            bar.update(static_cast<double>(progress.done) / static_cast<double>(progress.count));
        });
    }
    // Ctrl-C keeps what has been measured.
    if (!arguments.outputFile.empty())
        writeFileAtomically(arguments.outputFile, benchmarkCsv(rows));
    print(arguments.json ? benchmarkJson(rows) : benchmarkTable(rows));
    if (!stop.stop_requested())
        return kDone;
    std::fputs("interrupted: the table ends early\n", stderr);
    return kInterrupted;
}

void addSweep(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand("sweep", "Measure zeta against tau and policy");
    const auto arguments = std::make_shared<SweepArguments>();
    SweepArguments& a = *arguments;
    command->add_option("SCENARIO", a.files, "Scenarios to fly");
    command->add_option("--random", a.random, "Also fly N random scenarios (seeds 1 .. N)")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--tau", a.taus, "A:B:STEP, or values with commas")->required();
    command->add_option("--policies", a.policies, "With commas: " + allowedNames(kPolicyNames));
    command->add_option("--runs", a.runs, "Noise seeds for each scenario")
        ->check(CLI::Range(1, 1000000));
    command->add_option("--threads", a.threads, "0: one per core; never changes the result")
        ->check(CLI::Range(0, 1024));
    command->add_option("--output", a.outputFile, "CSV file for the table");
    command->add_flag("--json", a.json, "Print one JSON document");
    command->callback([arguments, &action] {
        action = [arguments](const std::stop_token& stop) { return runSweep(*arguments, stop); };
    });
}

void addBenchmark(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("benchmark", "Solution times beside Table 2 of the paper");
    const auto arguments = std::make_shared<BenchmarkArguments>();
    BenchmarkArguments& a = *arguments;
    command->add_option("--sizes", a.sizes, "Numbers of icebergs, with commas")
        ->delimiter(',')
        ->check(CLI::Range(0, 500));
    command->add_option("--repeat", a.repeat, "Instances of each size")
        ->check(CLI::Range(1, 10000));
    command->add_option("--backends", a.backends,
                        "With commas, by default all but auto: " +
                            allowedNames(kBenchmarkSolverNames));
    command->add_option("--seconds", a.seconds, "Budget for everything")
        ->check(CLI::Range(0.001, 1e7));
    command->add_option("--output", a.outputFile, "CSV file for the table");
    command->add_flag("--json", a.json, "Print one JSON document");
    command->callback([arguments, &action] {
        action = [arguments](const std::stop_token& stop) { return benchmark(*arguments, stop); };
    });
}

} // namespace

void addStudyCommands(CLI::App& app, Action& action)
{
    addSweep(app, action);
    addBenchmark(app, action);
}

} // namespace berg::cli
