#include "app/cli/study/study_output.h"

#include "app/cli/console.h"
#include "core/base/version.h"
#include "core/io/results/result_json.h"
#include "core/io/study/study_report.h"
#include "core/io/text/system_info.h"
#include "core/plan/policy/policy.h"
#include "core/scenario/utc_time.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace berg::cli {

namespace {

std::string settingText(const StudySetting& setting)
{
    const std::string policy = nameOf(kPolicyNames, setting.policy);
    return setting.tau ? policy + " at tau " + fixed(*setting.tau, 2) : policy;
}

/** "-15.8 %", with the sign of a difference; what is less than is shown has none. */
std::string percent(double share)
{
    const double value = std::round(1000 * share) / 10;
    return (value > 0 ? "+" : "") + fixed(value == 0 ? 0 : value, 1) + " %";
}

std::string intervalText(const MeanInterval& relative)
{
    return percent(relative.low) + " .. " + percent(relative.high);
}

std::vector<std::string> rowOf(const SettingSummary& row, const PairedDifference& difference)
{
    const Summary& s = row.zeta_m2s;
    std::string policy = nameOf(kPolicyNames, row.setting.policy);
    policy.resize(12, ' '); // flush left
    return {policy,
            row.setting.tau ? fixed(*row.setting.tau, 2) : "-",
            std::to_string(s.n),
            grouped(s.mean),
            grouped(s.standardError),
            grouped(s.median),
            grouped(s.quartile1),
            grouped(s.quartile3),
            fixed(100 * row.stuckShare, 1) + " %",
            percent(difference.relative.mean),
            intervalText(difference.relative),
            fixed(100 * difference.lowerShare, 1) + " %",
            percent(difference.worst)};
}

std::string bestTauText(const BestTau& best)
{
    return "best tau of each case in hindsight: " + fixed(best.tau.decile1, 2) + " / " +
           fixed(best.tau.median, 2) + " / " + fixed(best.tau.decile9, 2) +
           " (10 / 50 / 90 %), mean zeta " + grouped(best.zeta_m2s.mean) + ", difference " +
           percent(best.relative.mean) + " (" + intervalText(best.relative) + ")\n";
}

/** Names of the settings that may be the best, the first few of many. */
std::string contendersText(const StudySummary& summary)
{
    constexpr std::size_t kMost = 4;
    const std::vector<std::size_t>& settings = summary.recommendation->contenders;
    std::string names;
    for (std::size_t i = 0; i < std::min(kMost, settings.size()); ++i)
        names += (i > 0 ? ", " : "") + settingText(summary.settings[settings[i]].setting);
    if (settings.size() > kMost)
        names += " and " + std::to_string(settings.size() - kMost) + " more";
    return names;
}

std::string recommendedText(const StudySummary& summary)
{
    const Recommendation& found = *summary.recommendation;
    if (summary.settings.size() == 1 || summary.cases.size() == 1)
        return {};
    if (!found.best)
        return "no clear winner; may be the best: " + contendersText(summary) + "\n";
    return "recommended: " + settingText(summary.settings[*found.best].setting) + ", " +
           percent(found.relative.mean) + " (" + intervalText(found.relative) + ") vs " +
           settingText(summary.settings[*found.next].setting) + ", the closest other setting\n";
}

std::string tableText(const StudySummary& summary)
{
    std::vector<std::vector<std::string>> rows{{"policy      ", "tau", "n", "mean", "+-", "median",
                                                "25 %", "75 %", "stuck", "difference",
                                                "95 % interval", "lower", "worst"}};
    for (std::size_t i = 0; i < summary.settings.size(); ++i)
        rows.push_back(rowOf(summary.settings[i], summary.differences.at(i)));
    std::string text = tableLines(rows, rows.front().size());
    text += "zeta in m2 s; stuck: two icebergs at most in the last half of the run\n";
    if (summary.reference < summary.settings.size())
        text += "difference: case by case vs " +
                settingText(summary.settings[summary.reference].setting) +
                "; lower: share of cases below it; worst: the largest difference of a case\n";
    if (summary.bestTau)
        text += bestTauText(*summary.bestTau);
    if (summary.recommendation)
        text += recommendedText(summary);
    return text;
}

ReportOrigin originNow(const std::optional<double>& elapsed_s)
{
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    return {.program = programName(),
            .machine = systemInfo(),
            .madeUtc = utcText(now, 0),
            .elapsed_s = elapsed_s,
            .words = reportLanguage()};
}

void sayWhenIncomplete(const Study& study)
{
    const std::size_t flown = flownCount(study);
    if (const std::size_t count = missionCount(study.spec); flown < count)
        printMessage(
            said(QT_TRANSLATE_NOOP("CommandLine", "incomplete: %1 of %2 missions are flown; the "
                                                  "results use only cases with all settings"),
                 {grouped(static_cast<double>(flown)), grouped(static_cast<double>(count))}));
}

} // namespace

CommandFiles filesOf(const StudyOutput& output, std::vector<std::string> inputs)
{
    if (output.replaceStudy && output.studyFile.empty())
        throw UsageError(QT_TRANSLATE_NOOP("CommandLine", "--replace-study needs --study FILE"));
    if (output.studyFile == "-")
        throw UsageError(kNoStream, {"--study"});
    return {.inputs = std::move(inputs),
            .outputs = {{.option = "--study", .path = output.studyFile, .mayExist = true},
                        {.option = "--output", .path = output.tableFile},
                        {.option = "--report", .path = output.reportFile}},
            .force = output.force,
            .json = output.json};
}

void addStudyOutput(CLI::App& command, StudyOutput& output, const std::string& study)
{
    command.add_option("--study", output.studyFile, study);
    command.add_flag("--replace-study", output.replaceStudy,
                     "Replace a --study file of another study");
    command.add_option("--reference", output.reference,
                       "POLICY[:TAU], reference for differences (tau = 1)");
    addOutputFile(command, "-o,--output", output.tableFile, "CSV file for the table");
    addOutputFile(command, "--report", output.reportFile,
                  "Web page with charts, tables and the whole study");
    addForce(command, output.force);
    command.add_flag("--json", output.json, "Print one JSON document");
}

std::size_t referenceOf(const StudySpec& spec, const StudyOutput& output)
{
    constexpr double kSameTau = 1e-9; // what is typed against first + k * step
    if (output.reference.empty())
        return usualReference(spec);
    const std::vector<std::string> parts = split(output.reference, ':');
    const auto policy = valueOf(kPolicyNames, parts.front());
    if (!policy || parts.size() > 2)
        throw UsageError(
            QT_TRANSLATE_NOOP("CommandLine", "--reference: %1 is not POLICY[:TAU] with one of %2"),
            {output.reference, allowedNames(kPolicyNames)});
    const bool hasTau = parts.size() == 2;
    const double tau = hasTau ? numberOf("--reference", parts[1]) : 0;
    const std::vector<StudySetting> settings = settingsOf(spec);
    for (std::size_t i = 0; i < settings.size(); ++i)
        if (settings[i].policy == *policy && settings[i].tau.has_value() == hasTau &&
            std::abs(settings[i].tau.value_or(tau) - tau) < kSameTau)
            return i;
    throw UsageError(
        QT_TRANSLATE_NOOP("CommandLine", "--reference: this study does not contain %1"),
        {output.reference});
}

void writeResults(const Study& study, const StudyOutput& output, const std::function<void()>& save,
                  const std::optional<double>& elapsed_s)
{
    const StudySummary summary = summarise(study, referenceOf(study.spec, output));
    sayWhenIncomplete(study);
    std::vector<NewFile> files;
    if (!output.tableFile.empty())
        files.push_back({.path = output.tableFile, .content = sweepCsv(summary)});
    if (!output.reportFile.empty())
        files.push_back({.path = output.reportFile,
                         .content = studyReportHtml(study, summary, originNow(elapsed_s))});
    deliver(files, output.json ? sweepJson(study, summary, elapsed_s) : tableText(summary), save);
}

} // namespace berg::cli
