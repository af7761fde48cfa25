#pragma once

#include "app/cli/output_gate.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>

namespace berg::cli {

/** What becomes of the results of a study. */
struct StudyOutput
{
    std::string tableFile;  ///< CSV
    std::string reportFile; ///< HTML
    std::string reference;  ///< POLICY[:TAU]; empty: the usual one
    std::string studyFile;  ///< that is carried on
    bool replaceStudy = false;
    bool force = false;
    bool json = false;
    [[nodiscard]] bool writesFiles() const { return !tableFile.empty() || !reportFile.empty(); }
};

/** What a command with these inputs writes, for `checkFiles`. Throws `UsageError`. */
[[nodiscard]] CommandFiles filesOf(const StudyOutput& output, std::vector<std::string> inputs);

/** The options that fill it; `study`: what the file of `--study` is for. */
void addStudyOutput(CLI::App& command, StudyOutput& output, const std::string& study);

/** Throws `UsageError` when the reference asked for is no setting of the study. */
[[nodiscard]] std::size_t referenceOf(const StudySpec& spec, const StudyOutput& output);

/**
 * Saves the study with `save`, writes the files asked for and prints, as `deliver`; `elapsed_s`:
 * none for a study flown before.
 */
void writeResults(const Study& study, const StudyOutput& output, const std::function<void()>& save,
                  const std::optional<double>& elapsed_s = {});

} // namespace berg::cli
