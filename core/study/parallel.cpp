#include "core/study/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace berg {

std::size_t threadCount(const std::optional<int>& threads)
{
    return threads ? static_cast<std::size_t>(*threads)
                   : std::max(1U, std::thread::hardware_concurrency());
}

bool forEachIndex(std::size_t count, const std::function<void(std::size_t)>& job,
                  const ParallelOptions& options)
{
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    std::mutex mutex;
    std::size_t done = 0;
    std::size_t failedIndex = count;
    std::exception_ptr failure;

    const auto worker = [&] {
        while (!failed && !options.stop.stop_requested()) {
            const std::size_t i = next++;
            if (i >= count)
                return;
            try {
                job(i);
                const std::scoped_lock lock(mutex);
                ++done;
                if (options.onProgress)
                    options.onProgress(done);
            } catch (...) {
                const std::scoped_lock lock(mutex);
                failed = true;
                if (i < failedIndex) {
                    failedIndex = i;
                    failure = std::current_exception();
                }
                return;
            }
        }
    };

    const std::size_t wanted = threadCount(options.threads);
    {
        std::vector<std::jthread> pool;
        for (std::size_t t = 0; t < std::min(wanted, std::max<std::size_t>(1, count)); ++t)
            pool.emplace_back(worker);
    }
    if (failure)
        std::rethrow_exception(failure);
    return done == count;
}

} // namespace berg
