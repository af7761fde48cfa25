#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>

namespace berg {

/** Distribution of independent jobs over threads. */
struct ParallelOptions
{
    std::optional<int> threads = {}; ///< at least 1; nullopt means one per core
    std::stop_token stop;
    std::function<void(std::size_t done)> onProgress; ///< never called by two threads at once
};

/** Returns the number of threads of a pool: as given, or the number of cores. */
[[nodiscard]] std::size_t threadCount(const std::optional<int>& threads);

/**
 * Calls `job(i)` once for each i in [0, count) on a pool of threads. Jobs must write to separate
 * places, so that the result does not depend on the number of threads. If jobs or `onProgress`
 * throw, the remaining jobs are abandoned and the exception of the smallest index is thrown here.
 * Returns false if stopped before every job was done.
 */
bool forEachIndex(std::size_t count, const std::function<void(std::size_t)>& job,
                  const ParallelOptions& options);

} // namespace berg
