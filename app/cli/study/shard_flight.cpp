#include "app/cli/study/shard_flight.h"

#include <utility>

namespace berg::cli {

ShardFlight::ShardFlight(Study study, StudyOptions options)
    : m_study(std::move(study))
    , m_taken(missionCount(m_study.spec))
    , m_interrupted(options.stop, [this] { m_stop.request_stop(); })
{
    for (std::size_t i = 0; i < m_study.outcomes.size(); ++i)
        m_taken.at(i) = m_study.outcomes[i].has_value();
    options.stop = m_stop.get_token();
    options.onProgress = [this](const Study& now, std::size_t /*done*/, std::size_t /*count*/) {
        collectSometimes(now);
    };
    m_thread = std::jthread([this, options] { run(options); });
}

std::vector<SentOutcome> ShardFlight::take()
{
    if (m_ended)
        collect(m_study);
    const std::scoped_lock lock(m_mutex);
    return std::exchange(m_collected, {});
}

void ShardFlight::run(const StudyOptions& options)
{
    try {
        fly(m_study, options);
    } catch (...) {
        m_failure = std::current_exception();
    }
    m_ended = true;
}

void ShardFlight::collectSometimes(const Study& study)
{
    constexpr double kInterval_s = 0.2;
    if (m_watch.elapsed_s() - m_last_s < kInterval_s)
        return;
    m_last_s = m_watch.elapsed_s();
    collect(study);
}

void ShardFlight::collect(const Study& study)
{
    const std::scoped_lock lock(m_mutex);
    for (std::size_t i = 0; i < study.outcomes.size(); ++i)
        if (study.outcomes[i] && !m_taken[i]) {
            m_taken[i] = true;
            m_collected.push_back({.place = i, .outcome = *study.outcomes[i]});
        }
}

} // namespace berg::cli
