#pragma once

#include "core/study/study_summary.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace berg::cli {

/** What becomes of the results of a study. */
struct StudyOutput
{
    std::string tableFile;  ///< CSV
    std::string reportFile; ///< HTML
    std::string reference;  ///< POLICY[:TAU]; empty: the usual one
    bool json = false;
    [[nodiscard]] bool writesFiles() const { return !tableFile.empty() || !reportFile.empty(); }
};

/** The options that fill it. */
void addStudyOutput(CLI::App& command, StudyOutput& output);

/** Throws `UsageError` when the reference asked for is no setting of the study. */
[[nodiscard]] std::size_t referenceOf(const StudySpec& spec, const StudyOutput& output);

/** Writes the files asked for, then prints; `elapsed_s`: none for a study flown before. */
void writeResults(const Study& study, const StudyOutput& output,
                  const std::optional<double>& elapsed_s = {});

} // namespace berg::cli
