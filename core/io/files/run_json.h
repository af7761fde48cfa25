#pragma once

#include "core/io/text/text_sink.h"
#include "core/sim/mission.h"

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** One re-planning as a run file keeps it. */
struct RecordedPlan
{
    double time_s = 0;
    int uav = 0; ///< index
    int target = -1;
    std::vector<int> order;
    std::vector<std::vector<int>> clusters; ///< of the order, flown to as one point each
    std::vector<AimedLeg> legs;             ///< of a plan with aim points
    bool operator==(const RecordedPlan&) const = default;
};

/** A run: what it was flown with and enough of what happened to check a replay bit for bit. */
struct RunFile
{
    Scenario scenario; ///< as flown, command-line changes applied
    MissionOptions options;
    double flownUntil_s = 0;
    std::vector<Intervention> interventions;
    std::vector<RecordedPlan> plans;
    std::vector<WorldState> keyframes;
    Metrics metrics;
    bool operator==(const RunFile&) const = default;
};

/**
 * The run flown so far. Of very long runs there are keyframes at longer intervals (`Recorder`), so
 * that the file stays readable; the last one is always kept.
 */
[[nodiscard]] RunFile runOf(const Mission& mission);
/** The file in pieces: no more of it is in memory than one of them. */
void writeRun(const RunFile& run, const TextSink& put);
/** Errors as for `scenarioFromJson`. */
[[nodiscard]] RunFile runFromJson(std::string_view text, const std::string& subject,
                                  const std::stop_token& stop = {});
/** Findings about its scenario, and hints about members of interventions that are not known. */
[[nodiscard]] std::vector<Issue> validate(const RunFile& run);
[[nodiscard]] RunFile loadRun(const std::string& path, const std::stop_token& stop = {});
void saveRun(const RunFile& run, const std::string& path);

/**
 * Flies the run again from its scenario and options, applying its interventions at their times,
 * until `flownUntil_s`. Cancelled, the mission returned has flown less than that. Throws as the
 * constructor of `Mission`. With a `sink`, samples are handed on to it and not kept.
 */
[[nodiscard]] Mission replay(const RunFile& run, const std::stop_token& stop = {},
                             const std::function<void(double)>& onProgress = {},
                             SampleSink sink = {});

/**
 * What of a recorded run a replay does not reproduce bit for bit: the first keyframe (with its
 * time and first differing field), the first plan and the first metric that differ; empty when
 * all are equal. A run with a time limit per solve is not bound to repeat; differences then come
 * with a warning that says so.
 */
[[nodiscard]] std::vector<Issue> compareRun(const RunFile& recorded, const RunFile& replayed);

/**
 * Format of a file by its `format` member: "bergwatch-scenario", "bergwatch-problem",
 * "bergwatch-run" or "bergwatch-study". Throws `Error` SyntaxError, FileTooLarge, and WrongFormat
 * for anything else.
 */
[[nodiscard]] std::string formatOf(std::string_view text, const std::string& subject,
                                   const std::stop_token& stop = {});

} // namespace berg
