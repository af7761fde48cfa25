#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace berg {

/**
 * A slot between two threads that holds at most one value: a writer replaces or amends what waits,
 * the reader takes it. A slow reader so gets fewer, newer values and never a queue.
 */
template <class T>
class Mailbox
{
public:
    /**
     * Leaves `value`; when one waits, `amend(waiting, value)` joins the two. True when the box was
     * empty, i.e. when the reader must be told.
     */
    template <class Amend>
    bool put(T value, const Amend& amend)
    {
        const std::scoped_lock lock(m_mutex);
        if (m_value) {
            amend(*m_value, std::move(value));
            return false;
        }
        m_value = std::move(value);
        return true;
    }

    /** Leaves `value` in place of what waits. */
    bool put(T value)
    {
        return put(std::move(value), [](T& waiting, T next) { waiting = std::move(next); });
    }

    [[nodiscard]] std::optional<T> take()
    {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_value, std::nullopt);
    }

private:
    std::mutex m_mutex;
    std::optional<T> m_value;
};

} // namespace berg
