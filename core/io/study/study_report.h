#pragma once

#include "core/io/text/report_words.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>
#include <string_view>

namespace berg {

/** Where a report comes from. */
struct ReportOrigin
{
    std::string program;             ///< name and version
    std::string machine;             ///< `machineText()`; empty: not told
    std::string madeUtc;             ///< ISO 8601 with Z
    std::optional<double> elapsed_s; ///< that the flying took; none: flown before
    ReportWords words = {};          ///< what the page is written in
};

/**
 * A study as one page that needs nothing else: HTML that is well-formed XML, charts as SVG, tables
 * of the same numbers, what was flown, and the whole study file, so that the page can be made again
 * (`studyOfReport`). No scripts run in it.
 */
[[nodiscard]] std::string studyReportHtml(const Study& study, const StudySummary& summary,
                                          const ReportOrigin& origin);

/** Whether a file with this content is a web page rather than JSON. */
[[nodiscard]] bool isReport(std::string_view text);

/**
 * The study file (JSON) within a report. Throws `Error{WrongFormat}` with `subject` when there is
 * none.
 */
[[nodiscard]] std::string studyOfReport(std::string_view html, const std::string& subject);

} // namespace berg
