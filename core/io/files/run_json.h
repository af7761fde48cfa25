#pragma once

#include "core/io/text/text_sink.h"
#include "core/mission/mission.h"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace berg {

/** A recorded run: its inputs, and enough of its course to check a replay bit for bit. */
struct RunFile
{
    Scenario scenario; ///< as flown, with the changes of the command line applied
    MissionOptions options;
    double flownUntil_s = 0;
    std::vector<Intervention> interventions;
    std::vector<PoseFix> fixes; ///< poses of real aircraft, as `PoseTracks::until`
    /** Only what `writeRun` writes of them counts. A plan read from a file is for one UAV. */
    std::vector<PlanPointer> plans;
    std::vector<WorldState> keyframes;
    Metrics metrics;

    /** Returns whether both are written as the same file. */
    [[nodiscard]] bool operator==(const RunFile& other) const;
};

/**
 * Returns the run flown so far. Very long runs have keyframes at longer intervals (`Recorder`), so
 * that the file stays readable; the last keyframe is always included.
 */
[[nodiscard]] RunFile runOf(const Mission& mission);
/**
 * Passes the text of the run file to `put` piece by piece, so that only one piece is in memory. A
 * plan has a line for each UAV: time, target, order, clusters and legs.
 */
void writeRun(const RunFile& run, const TextSink& put);
/** Reads a run file. Throws as `scenarioFromJson`. */
[[nodiscard]] RunFile runFromJson(std::string_view text, const std::string& subject,
                                  const std::stop_token& stop = {});
/**
 * Returns the findings about the run's scenario and hints about unknown members of interventions.
 */
[[nodiscard]] std::vector<Issue> validate(const RunFile& run);
/** Reads a run file from `path`; throws as `readFile` and `runFromJson`. */
[[nodiscard]] RunFile loadRun(const std::string& path, const std::stop_token& stop = {});
/** Writes a run file to `path`; throws as `FileSet::write`. */
void saveRun(const RunFile& run, const std::string& path);

/**
 * Flies the run again from its scenario and options until `flownUntil_s`, applying its
 * interventions at their times. If a stop is requested, the returned mission has flown less.
 * `onProgress` gets the simulated time in s. With a `sink`, samples are passed to it and not
 * stored. Throws as the constructor of `Mission`, and `Error` for an intervention that cannot be
 * applied.
 */
[[nodiscard]] Mission replay(const RunFile& run, const std::stop_token& stop = {},
                             const std::function<void(double)>& onProgress = {},
                             SampleSink sink = {});

/**
 * Compares a recorded run with its replay, bit for bit. Returns the first keyframe (with its time
 * and first differing field), the first plan and the metrics that differ, or an empty list if all
 * are equal. If the replay dropped keyframes (`Recorder`), recorded ones at other times are not
 * compared. A run with a time limit per solve need not repeat; its differences come with a warning
 * that says so.
 */
[[nodiscard]] std::vector<Issue> compareRun(const RunFile& recorded, const RunFile& replayed);

/**
 * Returns the format of a file from its `format` member: "bergwatch-scenario", "bergwatch-problem",
 * "bergwatch-run" or "bergwatch-study"; the text behind that member is not read. Throws `Error`
 * SyntaxError, FileTooLarge, and WrongFormat for any other format or none; `Stopped` if a stop is
 * requested.
 */
[[nodiscard]] std::string formatOf(std::string_view text, const std::string& subject,
                                   const std::stop_token& stop = {});

} // namespace berg
