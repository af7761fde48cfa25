#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/io/results/result_json.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace berg::cli {

namespace {

struct BenchmarkArguments
{
    std::vector<int> sizes{2, 6, 10, 12, 16, 20, 30, 40, 60, 80};
    int repeat = 10;
    std::string backends;
    double seconds = 60;
    std::string outputFile;
    bool force = false;
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
            throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--backends: %1 is none of %2"),
                             {name, allowedNames(kBenchmarkSolverNames)});
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
    checkFiles({.inputs = {},
                .outputs = {{.option = "--output", .path = arguments.outputFile}},
                .force = arguments.force,
                .json = arguments.json});
    std::vector<BenchmarkRow> rows;
    {
        ProgressBar bar(said(QT_TRANSLATE_NOOP("CommandLine", "solving"), {}), !arguments.json);
        rows = runBenchmark(spec, stop, [&bar](const BenchmarkProgress& progress) {
            bar.update(static_cast<double>(progress.done) / static_cast<double>(progress.count));
        });
    }
    // Ctrl-C keeps what has been measured.
    std::vector<NewFile> files;
    if (!arguments.outputFile.empty())
        files.push_back({.path = arguments.outputFile, .content = benchmarkCsv(rows)});
    deliver(files, arguments.json ? benchmarkJson(rows) : benchmarkTable(rows));
    if (!stop.stop_requested())
        return kDone;
    printMessage(
        said(QT_TRANSLATE_NOOP("CommandLine", "interrupted: the table is incomplete"), {}));
    return kInterrupted;
}

} // namespace

void addBenchmarkCommand(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("benchmark", "Solution times beside Table 2 of the paper");
    BenchmarkArguments& a = argumentsOf(*command, action, benchmark);
    command
        ->add_option("--sizes", a.sizes,
                     "Numbers of icebergs, with commas (2 to 80; the paper's end at 20)")
        ->delimiter(',')
        ->transform(wholeFrom(0, 500));
    command->add_option("--repeat", a.repeat, "Instances of each size (10)")
        ->transform(wholeFrom(1, 10000));
    command->add_option("--backends", a.backends,
                        "With commas (all but auto): " + allowedNames(kBenchmarkSolverNames));
    command->add_option("--seconds", a.seconds, "Budget for everything (60)")
        ->check(numberFrom(0.001, 1e7));
    addOutputFile(*command, "-o,--output", a.outputFile, "CSV file for the table");
    addForce(*command, a.force);
    command->add_flag("--json", a.json, "Print one JSON document");
}

} // namespace berg::cli
