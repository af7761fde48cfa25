#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace berg {

/** Numbers of things by hash: open addressing, grown by doubling. The things are kept elsewhere. */
class NumberTable
{
public:
    NumberTable() : m_slots(64) {}

    void clear()
    {
        std::fill(m_slots.begin(), m_slots.end(), Slot{});
        m_count = 0;
    }
    /** The number of that hash for which `isIt(number)` holds; -1 when there is none. */
    template <class IsIt>
    [[nodiscard]] int find(std::size_t hash, const IsIt& isIt) const
    {
        return m_slots[place(m_slots, hash, isIt)].number;
    }
    /** The same, to be entered at once when there is none. */
    template <class IsIt>
    [[nodiscard]] int& entry(std::size_t hash, const IsIt& isIt)
    {
        if (2 * m_count >= m_slots.size())
            grow();
        Slot& slot = m_slots[place(m_slots, hash, isIt)];
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

    template <class IsIt>
    static std::size_t place(const std::vector<Slot>& table, std::size_t hash, const IsIt& isIt)
    {
        std::size_t k = (hash ^ (hash >> 32)) & (table.size() - 1);
        while (table[k].number >= 0 && !(table[k].hash == hash && isIt(table[k].number)))
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
