#pragma once

#include "core/checks/weather_gate.h"
#include "core/mission/mission.h"
#include "core/study/benchmark.h"
#include "core/study/study_summary.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

// JSON output of the command line with --json: one document with a stable member order.

/**
 * Returns the result of a mission; `lowerBound_m2s` is the lower bound on zeta, if it was
 * requested, and `elapsed_s` the time that the computation took. `weather` is left out if it is
 * nullopt.
 */
[[nodiscard]] std::string simulateJson(const Mission& mission, std::optional<double> lowerBound_m2s,
                                       double elapsed_s,
                                       const std::optional<WeatherVerdict>& weather = {});

/** Totals of one UAV in a mission. */
struct UavFigures
{
    std::string id;
    int visits = 0;
    double flown_m = 0; ///< distance through the air
};
/** Returns the totals of every UAV. */
[[nodiscard]] std::vector<UavFigures> uavFigures(const Mission& mission);
/**
 * Counts the events that not every run has (icebergs lost, sorties, ...), named by `kEventNames`;
 * events that did not occur are left out.
 */
[[nodiscard]] std::vector<std::pair<std::string, int>> worldEvents(const Mission& mission);
/** Returns the result of a study; `elapsed_s` is nullopt if it was flown earlier. */
[[nodiscard]] std::string sweepJson(const Study& study, const StudySummary& summary,
                                    const std::optional<double>& elapsed_s);
/** Returns the result of a benchmark, with the times of the paper's Table 2. */
[[nodiscard]] std::string benchmarkJson(const std::vector<BenchmarkRow>& rows);

/** Findings about one file. */
struct FileFindings
{
    std::string file;
    std::vector<Issue> issues;
};
/** Lists the findings of the files; a file without errors gets an entry "valid". */
[[nodiscard]] std::string findingsJson(const std::vector<FileFindings>& files);

/** Returns `{"error": {"kind", "findings"}}` for an error. */
[[nodiscard]] std::string failureJson(const Error& error);
/** Returns the document of the function above for a failure that is not an `Error`. */
[[nodiscard]] std::string failureJson(std::string_view kind, const FileFindings& found);

// CSV tables (RFC 4180) of the same results.
/** Returns one row per setting; differences are relative to the reference, in % of its zeta. */
[[nodiscard]] std::string sweepCsv(const StudySummary& summary);
/** Returns one row per benchmark row, with the times of the paper's Table 2. */
[[nodiscard]] std::string benchmarkCsv(const std::vector<BenchmarkRow>& rows);

} // namespace berg
