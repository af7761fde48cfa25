#pragma once

#include "core/study/study.h"

#include <functional>

namespace berg::cli {

/** Steps before, during and after the flights of a study; with several processes only the first
 * runs them. */
struct SweepLead
{
    std::function<Study()> prepare;
    /** Reports missions done out of `count`, about once per mission. */
    std::function<void(const Study&, std::size_t done, std::size_t count)> progress;
    /** Stores the outcomes when flying ends, also after a failure or a stop. */
    std::function<void(const Study&)> keep;
    /** Returns the exit code of a sweep that ended without a failure. */
    std::function<int(const Study&, bool complete)> finish;
};

/** Flies in this process; `options.onProgress` is ignored. */
[[nodiscard]] int flyAlone(const SweepLead& lead, StudyOptions options);

/**
 * Flies in all processes of this MPI program, each a part of the shard, with the same result as
 * `flyAlone`. Only the first process calls `lead`. A failure in any process ends all and is thrown
 * in the first. `commandLine` must be equal in all. If `options.threads` is nullopt, each process
 * uses the cores of its computer divided by the number of its processes. Throws
 * `Error{Unsupported}` in builds without MPI.
 */
[[nodiscard]] int flyOnRanks(const SweepLead& lead, const StudyOptions& options,
                             const std::string& commandLine);

} // namespace berg::cli
