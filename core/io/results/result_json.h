#pragma once

#include "core/sim/mission.h"
#include "core/study/benchmark.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

// What the command line prints with --json: one JSON document, stable member order.

/** `lowerBound_m2s`: what no flight is below, if it was asked for. */
[[nodiscard]] std::string simulateJson(const Mission& mission, std::optional<double> lowerBound_m2s,
                                       double elapsed_s);

/** What one UAV did in a mission. */
struct UavFigures
{
    std::string id;
    int visits = 0;
    double flown_m = 0; ///< through the air
};
[[nodiscard]] std::vector<UavFigures> uavFigures(const Mission& mission);
/** How often what happened that not every run has (icebergs lost, sorties, ...), by `kEventNames`.
 */
[[nodiscard]] std::vector<std::pair<std::string, int>> worldEvents(const Mission& mission);
/** `elapsed_s`: none for a study that was flown before. */
[[nodiscard]] std::string sweepJson(const Study& study, const StudySummary& summary,
                                    const std::optional<double>& elapsed_s);
[[nodiscard]] std::string benchmarkJson(const std::vector<BenchmarkRow>& rows);

/** Findings about one file. */
struct FileFindings
{
    std::string file;
    std::vector<Issue> issues;
};
[[nodiscard]] std::string findingsJson(const std::vector<FileFindings>& files);

/** `{"error": {"kind", "findings"}}`, the findings as above. */
[[nodiscard]] std::string failureJson(const Error& error);
/** The same of what is no `Error`. */
[[nodiscard]] std::string failureJson(std::string_view kind, const FileFindings& found);

// The same as CSV tables (RFC 4180).
/** A row for each setting; differences are against the reference, in % of its zeta. */
[[nodiscard]] std::string sweepCsv(const StudySummary& summary);
[[nodiscard]] std::string benchmarkCsv(const std::vector<BenchmarkRow>& rows);

} // namespace berg
