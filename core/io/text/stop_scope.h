#pragma once

#include <stop_token>
#include <utility>

namespace berg {

/**
 * Lets a stop cancel child processes that writers of exports run on this thread while the scope
 * exists: the writers are called through tables whose functions take no token. Must be destroyed on
 * the thread that created it.
 */
class StopScope
{
public:
    explicit StopScope(std::stop_token stop) : m_outer(std::exchange(s_current, std::move(stop))) {}
    ~StopScope() { s_current = std::move(m_outer); }
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

    /** Returns the token of the innermost scope of this thread, or one that never stops. */
    [[nodiscard]] static const std::stop_token& current() { return s_current; }

private:
    std::stop_token m_outer;

    inline static thread_local std::stop_token s_current;
};

} // namespace berg
