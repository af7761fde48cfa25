#pragma once

#include "core/io/words/report_words.h"
#include "core/study/study_summary.h"

#include <string>
#include <vector>

namespace berg {

// Charts of a study for its report, as SVG. They show the complete cases only and are empty if
// there is nothing to draw.

/** Returns the name of a setting: "τ = 0.5" (six decimals at most), or the name of the policy. */
[[nodiscard]] std::string settingName(const StudySetting& setting);

/**
 * Returns the chart of zeta against tau: mean, median, middle half and 10-90 % of the cases, with
 * other policies as horizontal lines. One case is a single curve. Returns an empty text with fewer
 * than two values of tau or without a complete case.
 */
[[nodiscard]] std::string zetaChart(const StudySummary& summary, const ReportWords& words);

/**
 * Returns the indices of the settings for which `differenceChart` has room: every policy without
 * tau, the reference, and of more than 42 values of tau only every k-th.
 */
[[nodiscard]] std::vector<std::size_t> drawnDifferences(const StudySummary& summary);
/**
 * Returns the chart of relative differences to the reference with 95 % intervals, one row for each
 * of `drawnDifferences`. Returns an empty text with fewer than two complete cases or settings.
 */
[[nodiscard]] std::string differenceChart(const StudySummary& summary, const ReportWords& words);

/**
 * Returns the chart of the number of cases for which each tau is the best. Returns an empty text
 * with fewer than two complete cases or values of tau.
 */
[[nodiscard]] std::string bestTauChart(const StudySummary& summary, const ReportWords& words);

} // namespace berg
