#include "app/cli/commands.h"
#include "core/checks/validate.h"
#include "core/io/files/problem_json.h"
#include "core/io/files/run_json.h"
#include "core/io/files/scenario_json.h"
#include "core/io/files/tsplib.h"
#include "core/io/results/result_json.h"
#include "core/io/study/study_json.h"
#include "core/io/text/atomic_file.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

namespace berg::cli {

namespace {

/** All findings about a file; reading stops at the first level that fails. */
std::vector<Issue> findings(const std::string& file)
{
    try {
        const std::string text = readFile(file);
        if (isTsplib(text, file))
            return problemFromTsplib(text, file).hints;
        const std::string format = formatOf(text, file);
        if (format == "bergwatch-problem")
            return problemFromJson(text, file).hints;
        if (format == "bergwatch-study") {
            const Study study = studyFromJson(text, file);
            return {};
        }
        if (format == "bergwatch-run")
            return validate(runFromJson(text, file));
        return validate(scenarioFromJson(text, file));
    } catch (const Error& error) {
        return error.issues();
    }
}

int validateFiles(const std::vector<std::string>& files, bool json, const std::stop_token& stop)
{
    if (std::ranges::count(files, "/dev/stdin") > 1)
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "%1 excludes %2"), {"-", "-"});
    std::vector<FileFindings> all;
    bool bad = false;
    for (const std::string& file : files) {
        if (stop.stop_requested())
            throw Interrupted{};
        all.push_back({.file = file, .issues = reading([&] { return findings(file); })});
        bad = bad || hasErrors(all.back().issues);
    }
    if (json) {
        print(findingsJson(all));
        return bad ? kBadInput : kDone;
    }
    for (const FileFindings& one : all) {
        printWarnings(one.file, one.issues);
        for (const Issue& issue : one.issues)
            if (issue.severity == Severity::Error)
                printMessage(word(one.file) + ": " + said(issue));
        if (!hasErrors(one.issues))
            print(word(one.file) + ": valid\n");
    }
    return bad ? kBadInput : kDone;
}

} // namespace

void addFileCommands(CLI::App& app, Action& action)
{
    CLI::App* command =
        app.add_subcommand("validate", "Check files and list their faults (the first 100 of each)");
    const auto files = std::make_shared<std::vector<std::string>>();
    const auto json = std::make_shared<bool>(false);
    command->add_option("FILE", *files, "Scenarios, problems, runs and studies")->required();
    command->add_flag("--json", *json, "Print one JSON document");
    command->callback([files, json, &action] {
        action = [files, json](const std::stop_token& stop) {
            return validateFiles(*files, *json, stop);
        };
    });
}

} // namespace berg::cli
