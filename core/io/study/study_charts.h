#pragma once

#include "core/io/text/report_words.h"
#include "core/study/study_summary.h"

#include <string>
#include <vector>

namespace berg {

// Drawings of a study for its report. All are of the complete cases; empty where there is nothing
// to draw.

/** "τ = 0.5", or the name of the policy. */
[[nodiscard]] std::string settingName(const StudySetting& setting);

/**
 * zeta against tau: mean, median, middle half and 10-90 % of the cases, other policies as lines
 * across. One case is a curve. Empty with fewer than two values of tau.
 */
[[nodiscard]] std::string zetaChart(const StudySummary& summary, const ReportWords& words);

/** Settings that `differenceChart` has room for: of many values of tau every k-th. */
[[nodiscard]] std::vector<std::size_t> drawnDifferences(const StudySummary& summary);
/**
 * Relative differences to the reference with 95 % intervals, a row for each setting. Empty with
 * fewer than two cases or settings.
 */
[[nodiscard]] std::string differenceChart(const StudySummary& summary, const ReportWords& words);

/** In how many cases each tau is the best. Empty with fewer than two cases. */
[[nodiscard]] std::string bestTauChart(const StudySummary& summary, const ReportWords& words);

} // namespace berg
