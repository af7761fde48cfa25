#pragma once

// Private to core/io: the parts of a study's report, as HTML.

#include "core/io/study/study_report.h"

#include <string>

namespace berg {

/** The study's name, or what it is of. Not escaped. */
[[nodiscard]] std::string titleOf(const StudySpec& spec, const ReportWords& words);

/** How many missions and cases are done, and what stands out in one sentence each. */
[[nodiscard]] std::string reportFindings(const Study& study, const StudySummary& summary,
                                         const ReportWords& words);

/** The tables of settings, differences and best tau. */
[[nodiscard]] std::string reportTables(const StudySummary& summary, const ReportWords& words);

/** What was flown, and by what: scenarios, seeds, settings, program, machine. */
[[nodiscard]] std::string reportFacts(const Study& study, const ReportOrigin& origin);

/** How to make the page, and its flights, again. */
[[nodiscard]] std::string reportRecipe(const StudySpec& spec, const ReportWords& words);

} // namespace berg
