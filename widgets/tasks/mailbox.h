#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace berg {

/**
 * A slot between two threads that holds at most one value: the writer replaces or amends the
 * waiting value, the reader takes it. A slow reader gets fewer, newer values and never a queue.
 */
template <class T>
class Mailbox
{
public:
    /**
     * Stores `value`, or joins it to the waiting value by `amend(waiting, value)`. Returns true if
     * the box was empty, i.e. if the reader must be notified.
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

    /** Stores `value` in place of a waiting one. Returns true if the box was empty. */
    bool put(T value)
    {
        return put(std::move(value), [](T& waiting, T next) { waiting = std::move(next); });
    }

    /** Removes and returns the value, or returns nullopt if the box is empty. */
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
