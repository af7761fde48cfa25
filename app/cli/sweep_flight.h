#pragma once

#include "core/study/study.h"

#include <functional>
#include <optional>

namespace berg::cli {

/** What surrounds the flying of a study; with several processes the first one does it for all. */
struct SweepLead
{
    std::function<Study()> prepare;
    /** Missions flown, of how many; called about as often as something is done. */
    std::function<void(const Study&, std::size_t done, std::size_t count)> progress;
    /** What has been flown when the flying ends in whatever way. */
    std::function<void(const Study&)> keep;
    /** Exit code of a sweep that ended without a failure. */
    std::function<int(const Study&, bool complete)> finish;
};

/** Flies in this process; `options.onProgress` is not read. */
[[nodiscard]] int flyAlone(const SweepLead& lead, StudyOptions options);

/** Number of this process among those of an MPI program, none when it was started by itself. */
[[nodiscard]] std::optional<int> mpiRank();

/**
 * Flies in all processes of the MPI program this one belongs to: each a part of the shard, with
 * the same result as `flyAlone`. Only the first one calls `lead`; a failure of any ends all and is
 * thrown there. `commandLine` must be the same in all. `options.threads` 0: the cores of each
 * computer divided by its processes. Throws `Error{Unsupported}` in builds without MPI.
 */
[[nodiscard]] int flyOnRanks(const SweepLead& lead, const StudyOptions& options,
                             const std::string& commandLine);

} // namespace berg::cli
