#pragma once

#include "app/cli/output_gate.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>

namespace berg::cli {

/** Destinations of a study's results. */
struct StudyOutput
{
    std::string tableFile;  ///< CSV
    std::string reportFile; ///< HTML
    std::string reference;  ///< POLICY[:TAU]; empty for the default one
    std::string studyFile;  ///< study file to continue
    bool replaceStudy = false;
    bool force = false;
    bool json = false;
    [[nodiscard]] bool writesFiles() const { return !tableFile.empty() || !reportFile.empty(); }
};

/** Returns the inputs and outputs for `checkFiles`. Throws `UsageError` for contradictory options.
 */
[[nodiscard]] CommandFiles filesOf(const StudyOutput& output, std::vector<std::string> inputs);

/** Adds the options that fill `output`; `study` is the help text of `--study`. */
void addStudyOutput(CLI::App& command, StudyOutput& output, const std::string& study);

/** Returns the index of the reference setting. Throws `UsageError` if the study does not have it.
 */
[[nodiscard]] std::size_t referenceOf(const StudySpec& spec, const StudyOutput& output);

/**
 * Saves the study with `save`, writes the requested files and prints the results, as `deliver`
 * does. `elapsed_s` is nullopt for a study flown before.
 */
void writeResults(const Study& study, const StudyOutput& output, const std::function<void()>& save,
                  const std::optional<double>& elapsed_s = {});

} // namespace berg::cli
