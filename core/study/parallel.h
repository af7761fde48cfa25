#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace berg {

/** How to spread independent jobs over threads. */
struct ParallelOptions
{
    int threads = 0; ///< 0: one per core
    std::stop_token stop;
    std::function<void(std::size_t done)> onProgress; ///< never called by two threads at once
};

/**
 * Calls `job(i)` for i in [0, count), each once, on a pool of threads. Jobs must write to places
 * of their own, so that the result does not depend on the number of threads. When jobs or
 * `onProgress` throw, the rest is abandoned and the exception of the smallest index is thrown here.
 * Returns false when stopped before every job was done.
 */
bool forEachIndex(std::size_t count, const std::function<void(std::size_t)>& job,
                  const ParallelOptions& options);

} // namespace berg
