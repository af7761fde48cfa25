#pragma once

// Private to core/io: the parts of a study's report, as HTML.

#include "core/io/study/study_report.h"

#include <string>

namespace berg {

/** Returns the study's name, or a description of its scenarios. The text is not escaped. */
[[nodiscard]] std::string titleOf(const StudySpec& spec, const ReportWords& words);

/**
 * Returns the section with the number of missions and cases flown, and the main results of the
 * complete cases in one sentence each.
 */
[[nodiscard]] std::string reportFindings(const Study& study, const StudySummary& summary,
                                         const ReportWords& words);

/**
 * Returns the section with the tables of settings, differences and best tau, or an empty text
 * without a complete case.
 */
[[nodiscard]] std::string reportTables(const StudySummary& summary, const ReportWords& words);

/** Returns the section with the setup: scenarios, seeds, settings, program, machine. */
[[nodiscard]] std::string reportFacts(const Study& study, const ReportOrigin& origin);

/**
 * Returns the section with the command that makes the page again and, if the command line can set
 * the random fields of the study, the command that flies it again.
 */
[[nodiscard]] std::string reportRecipe(const StudySpec& spec, const ReportWords& words);

} // namespace berg
