#pragma once

#include "core/plan/solve/solver.h"
#include "core/study/study.h"

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace berg::cli {

/** One outcome for another process of the same program, as plain bytes. */
struct SentOutcome
{
    std::uint64_t place = 0; ///< among `Study::outcomes`
    MissionOutcome outcome;
};
static_assert(std::is_trivially_copyable_v<SentOutcome>);

/** Flies a shard in its own thread and returns its outcomes in portions. */
class ShardFlight
{
public:
    /** Starts flying. A stop request of `options.stop` ends it; `options.onProgress` is ignored. */
    ShardFlight(Study study, StudyOptions options);

    void stop() { m_stop.request_stop(); }
    /** Returns true after the flight has ended; `take` then returns the rest. */
    [[nodiscard]] bool hasEnded() const { return m_ended; }
    /** Returns the exception that ended the flight, or null. Valid after `hasEnded()`. */
    [[nodiscard]] std::exception_ptr failure() const { return m_failure; }
    /** Returns the outcomes since the last call. */
    [[nodiscard]] std::vector<SentOutcome> take();

private:
    void run(const StudyOptions& options);
    void collectSometimes(const Study& study);
    void collect(const Study& study);

    Study m_study;
    std::vector<bool> m_taken; ///< by place
    std::stop_source m_stop;
    std::stop_callback<std::function<void()>> m_interrupted;
    Stopwatch m_watch;
    double m_last_s = 0;
    std::mutex m_mutex; ///< protects the collected outcomes
    std::vector<SentOutcome> m_collected;
    std::exception_ptr m_failure;
    std::atomic<bool> m_ended{false};
    std::jthread m_thread; ///< the last member: it ends before the others
};

} // namespace berg::cli
