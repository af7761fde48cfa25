#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace berg {

/**
 * Hash table of numbers of objects that are stored elsewhere: open addressing, grown by doubling.
 */
class NumberTable
{
public:
    NumberTable() : m_slots(64) {}

    void clear()
    {
        std::fill(m_slots.begin(), m_slots.end(), Slot{});
        m_count = 0;
    }
    /** Returns the number with that hash for which `matches(number)` holds; -1 if there is none. */
    template <class Matches>
    [[nodiscard]] int find(std::size_t hash, const Matches& matches) const
    {
        return m_slots[place(m_slots, hash, matches)].number;
    }
    /**
     * Returns a reference to the number that `find` would return, or to a new entry of -1 that the
     * caller must set at once. The reference is valid until the next call.
     */
    template <class Matches>
    [[nodiscard]] int& entry(std::size_t hash, const Matches& matches)
    {
        if (2 * m_count >= m_slots.size())
            grow();
        Slot& slot = m_slots[place(m_slots, hash, matches)];
        if (slot.number < 0) {
            slot.hash = hash;
            ++m_count;
        }
        return slot.number;
    }

private:
    struct Slot
    {
        std::size_t hash = 0;
        int number = -1;
    };

    template <class Matches>
    static std::size_t place(const std::vector<Slot>& table, std::size_t hash,
                             const Matches& matches)
    {
        std::size_t k = (hash ^ (hash >> 32)) & (table.size() - 1);
        while (table[k].number >= 0 && !(table[k].hash == hash && matches(table[k].number)))
            k = (k + 1) & (table.size() - 1);
        return k;
    }
    void grow()
    {
        std::vector<Slot> larger(2 * m_slots.size());
        for (const Slot& slot : m_slots)
            if (slot.number >= 0)
                larger[place(larger, slot.hash, [](int) { return false; })] = slot;
        m_slots = std::move(larger);
    }

    std::vector<Slot> m_slots; ///< a power of two
    std::size_t m_count = 0;
};

} // namespace berg
