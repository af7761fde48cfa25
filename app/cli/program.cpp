#include "app/cli/program.h"

#include "app/cli/options.h"
#include "app/cli/usage.h"
#include "core/io/results/result_json.h"
#include "core/io/text/read_budget.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <sstream>
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace berg::cli {

namespace {

constexpr const char* kNoMemory = QT_TRANSLATE_NOOP("CommandLine", "there is not enough memory");
constexpr const char* kInternal = "internal error: %1"; // for developers

int exitCodeOf(const Error& error)
{
    switch (error.code()) {
    case ErrorCode::FileNotFound:
    case ErrorCode::FileUnreadable:
    case ErrorCode::FileTooLarge:
    case ErrorCode::SyntaxError:
    case ErrorCode::WrongFormat:
    case ErrorCode::UnsupportedVersion:
    case ErrorCode::InvalidInput:
    case ErrorCode::Unsupported:
        return kBadInput;
    case ErrorCode::FileUnwritable:
    case ErrorCode::SolverFailed:
    case ErrorCode::ReplayMismatch:
        return kFailure;
    }
    return kFailure;
}

/** Which command reads the kind of file that was given in place of another; empty when none does,
 * or when it is the command that was given. */
std::string hintOf(const Error& error, const std::string& command)
{
    static constexpr std::pair<std::string_view, std::string_view> kHints[] = {
        {"bergwatch-problem",
         QT_TRANSLATE_NOOP("CommandLine", "This is a planning problem: use 'solve'.")},
        {"bergwatch-scenario",
         QT_TRANSLATE_NOOP("CommandLine",
                           "This is a scenario: use 'plan', 'simulate' or 'export'.")},
        {"bergwatch-run",
         QT_TRANSLATE_NOOP("CommandLine", "This is a run: use 'simulate' or 'export'.")},
        {"bergwatch-study", QT_TRANSLATE_NOOP("CommandLine", "This is a study: use 'study'.")}};
    const IssueReason& reason = error.issues().front().reason;
    if (reason.id == IssueId::UnknownFormat && command == "import")
        return said(
            QT_TRANSLATE_NOOP(
                "CommandLine",
                "Name the columns of a table: --map latitude=COLUMN --map longitude=COLUMN."),
            {});
    constexpr std::int64_t kLiteral = 5; // a word may begin as "false" does
    const bool isOtherText = reason.id == IssueId::JsonSyntax &&
                             std::get<std::int64_t>(reason.arguments[0]) == 1 &&
                             std::get<std::int64_t>(reason.arguments[1]) <= kLiteral;
    if (command == "forecast" || command == "drift")
        return isOtherText || reason.id == IssueId::Missing
                   ? said(QT_TRANSLATE_NOOP("CommandLine",
                                            "A forecast is the JSON reply of MET Norway's "
                                            "locationforecast or oceanforecast, NetCDF or GRIB."),
                          {})
                   : std::string();
    if (isOtherText && command != "import")
        return said(
            QT_TRANSLATE_NOOP("CommandLine",
                              "This is not a Bergwatch file. To read sightings, use 'import'."),
            {});
    if (reason.id == IssueId::OtherFormat)
        for (const auto& [given, hint] : kHints)
            if (std::get<std::string>(reason.arguments.back()) == given)
                return said(hint, {});
    return {};
}

/** The command line, and the output for messages. */
struct CommandWords
{
    const Program& program;
    const std::vector<std::string>& words;
};

/** Reports a failure as a sentence on stderr and, with --json, as an object on stdout. */
int failed(const CommandWords& line, int exitCode, const std::string& text, const std::string& json)
{
    if (line.program.isSilent) {
        // Open MPI 5 ends all processes with the first that fails: the one that reports comes
        // first.
        std::this_thread::sleep_for(std::chrono::seconds(1));
        return exitCode;
    }
    printMessage(text);
    if (std::ranges::find(line.words, "--json") != line.words.end())
        std::fputs(json.c_str(), stdout); // that nobody reads it changes nothing
    return exitCode;
}

int failed(const CommandWords& line, int exitCode, const char* kind, const Sentence& text)
{
    const FileFindings finding{
        .file = {}, .issues = {{Severity::Error, {}, {IssueId::Verbatim, {text.english}}}}};
    return failed(line, exitCode, text.said, failureJson(kind, finding));
}

void addCompletion(CLI::App& app, Action& action)
{
    CLI::App* command = app.add_subcommand("completion", "Print a script that completes commands");
    const auto shell = std::make_shared<std::string>();
    command->add_option("SHELL", *shell, "bash")
        ->required()
        ->check(CLI::Validator(
            [](const std::string& name) {
                return name == "bash"
                           ? std::string()
                           : inOne(
                                 sentence(QT_TRANSLATE_NOOP("CommandLine",
                                                            "there is no completion script for %1"),
                                          {word(name)}));
            },
            ""));
    command->callback([shell, &app, &action] {
        action = [&app](const std::stop_token&) {
            print(bashCompletion(app));
            return kDone;
        };
    });
}

/** How the line is wrong, in one sentence, and where to read how it should be. */
int wrongUsage(const CLI::App& app, const CommandWords& line, const Sentence& fault)
{
    const std::string command = commandOf(app, line.words);
    const FileFindings finding{
        .file = command, .issues = {{Severity::Error, {}, {IssueId::Verbatim, {fault.english}}}}};
    return failed(line, kWrongUsage,
                  command + ": " + fault.said + '\n' +
                      said(QT_TRANSLATE_NOOP("CommandLine", "Try '%1 --help'."), {command}),
                  failureJson("wrong-usage", finding));
}

bool isReadLimitsValid()
{
    const char* const given = // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it
        std::getenv(kReadLimitsVariable);
    std::string text = given == nullptr ? "1" : given;
    return wholeFrom(1, 1000)(text).empty();
}

/** The additional output of -v. */
void reportEffort()
{
    rusage used = {};
    if (getrusage(RUSAGE_SELF, &used) != 0)
        return;
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    printMessage(
        said(QT_TRANSLATE_NOOP("CommandLine", "took %1 s of processor time and %2 MB of memory"),
             {fixed(seconds(used.ru_utime) + seconds(used.ru_stime), 2),
              grouped(static_cast<double>(used.ru_maxrss) / 1e3)}));
}

int run(const CommandWords& line, const std::stop_token& stop)
{
    const auto& [program, words] = line;
    CLI::App app{program.about, program.name};
    app.set_version_flag("-V,--version", program.version);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Action action;
    program.addCommands(app, action);
    addCompletion(app, action);
    readDashFromStandardInput(app);
    addExamples(app);
    bool isVerbose = false;
    for (CLI::App* command : app.get_subcommands({})) {
        command->add_flag_callback("-q,--quiet", beQuiet, "No progress, warnings and hints");
        command->add_flag("-v,--verbose", isVerbose, "Report time and memory used");
    }
    if (const std::optional<Sentence> fault = unknownCommand(app, words))
        return wrongUsage(app, line, *fault);
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend())); // from the back
    } catch (const CLI::Success& asked) {
        std::ostringstream text;
        app.exit(asked, text, text);
        if (!program.isSilent)
            print(wrapped(text.str(), terminalWidth()));
        return kDone;
    } catch (const CLI::ParseError& error) {
        return wrongUsage(app, line, unknownWord(app, words).value_or(plainWords(error)));
    }
    if (!isReadLimitsValid())
        return wrongUsage(
            app, line,
            sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is not a whole number from %2 to %3"),
                     {std::string(kReadLimitsVariable), std::int64_t{1}, std::int64_t{1000}}));
    if (const std::string name = emptyOption(app); !name.empty())
        return wrongUsage(app, line,
                          sentence(QT_TRANSLATE_NOOP("CommandLine", "%1 is empty"), {name}));
    try {
        const int exitCode = action(stop);
        if (isVerbose && !program.isSilent)
            reportEffort();
        return exitCode;
    } catch (const UsageError& error) {
        return wrongUsage(app, line, error.message);
    }
}

} // namespace

int runProgram(const Program& program, int argc, char** argv, const std::stop_token& stop)
{
    const std::vector<std::string> words = wordsOf(argc, argv);
    const CommandWords line{.program = program, .words = words};
    try {
        return run(line, stop);
    } catch (const Interrupted&) {
        return failed(line, kInterrupted, "interrupted", sentence(kNothingWritten));
    } catch (const Error& error) {
        const std::string hint = hintOf(error, words.empty() ? std::string() : words.front());
        return failed(line, exitCodeOf(error), said(error) + (hint.empty() ? "" : "\n") + hint,
                      failureJson(error));
    } catch (const std::bad_alloc&) {
        if (!program.isSilent)
            std::fprintf(stderr, "%s\n", said(kNoMemory).data()); // which takes none
        return kFailure;
    } catch (const std::system_error& error) {
        const bool isScarce = error.code() == std::errc::resource_unavailable_try_again;
        return failed(line, kFailure, isScarce ? "no-memory" : "internal-error",
                      isScarce ? sentence(kNoMemory) : sentence(kInternal, {error.what()}));
    } catch (const std::exception& error) {
        return failed(line, kFailure, "internal-error", sentence(kInternal, {error.what()}));
    }
}

void becomeBergwatch(char** argv)
{
    std::string name = "bergwatch";
    std::vector<char*> arguments{name.data()};
    for (char** argument = argv + 1; *argument != nullptr; ++argument)
        arguments.push_back(*argument);
    arguments.push_back(nullptr);
    std::error_code failure;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (!failure) {
        const std::filesystem::path folder = self.parent_path();
        for (const std::filesystem::path& beside :
             {folder / name, folder.parent_path() / name}) // installed, and where both were built
            execv(beside.c_str(), arguments.data());
    }
    execvp(name.c_str(), arguments.data());
}

} // namespace berg::cli
