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

/** One outcome on its way to another process; plain bytes, both run the same program. */
struct SentOutcome
{
    std::uint64_t place = 0; ///< among `Study::outcomes`
    MissionOutcome outcome;
};
static_assert(std::is_trivially_copyable_v<SentOutcome>);

/** A shard being flown by a thread of its own, its outcomes handed over bit by bit. */
class ShardFlight
{
public:
    /** Starts. It also ends when `options.stop` is requested; `options.onProgress` is not read. */
    ShardFlight(Study study, StudyOptions options);

    void stop() { m_stop.request_stop(); }
    /** Then `take` gives the rest. */
    [[nodiscard]] bool hasEnded() const { return m_ended; }
    /** Why it ended, null without a failure; to be asked when it has ended. */
    [[nodiscard]] std::exception_ptr failure() const { return m_failure; }
    /** What has been flown since the last call. */
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
    std::mutex m_mutex; ///< of what has been collected and taken
    std::vector<SentOutcome> m_collected;
    std::exception_ptr m_failure;
    std::atomic<bool> m_ended{false};
    std::jthread m_thread; ///< the last member: it ends before the others
};

} // namespace berg::cli
