#pragma once

#include "core/io/words/report_words.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Origin of a report: program, machine, time and language. */
struct ReportOrigin
{
    std::string program;             ///< name and version
    std::string machine;             ///< `systemInfo()`; left out if empty
    std::string madeUtc;             ///< ISO 8601 with Z
    std::optional<double> elapsed_s; ///< nullopt if flown earlier
    ReportWords words = {};          ///< language of the page
};

/**
 * Returns a study as one self-contained page: HTML that is well-formed XML, charts as SVG, tables
 * of the same numbers, the setup, and the whole study file, so that the page can be made again
 * (`studyOfReport`). It runs no scripts.
 */
[[nodiscard]] std::string studyReportHtml(const Study& study, const StudySummary& summary,
                                          const ReportOrigin& origin);

/** Returns true if a file with this content is a web page and not JSON: it begins with `<`. */
[[nodiscard]] bool isReport(std::string_view text);

/**
 * Returns the study file (JSON) within a report. Throws `Error{WrongFormat}` with `subject` if
 * there is none.
 */
[[nodiscard]] std::string studyOfReport(std::string_view html, const std::string& subject);

} // namespace berg
