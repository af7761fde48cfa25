#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace berg {

/**
 * Hash table of numbers of objects that are stored elsewhere: open addressing, grown by doubling.
 */
class NumberTable
{
public:
    /** Value of a new entry; an optional would double the size of the table. */
    static constexpr int kNoNumber = -1;

    NumberTable() : m_slots(64) {}

    void clear()
    {
        std::fill(m_slots.begin(), m_slots.end(), Slot{});
        m_count = 0;
    }
    /** Returns the number with that hash for which `matches(number)` holds, if there is one. */
    template <class Matches>
    [[nodiscard]] std::optional<int> find(std::size_t hash, const Matches& matches) const
    {
        const int number = m_slots[place(m_slots, hash, matches)].number;
        return number == kNoNumber ? std::nullopt : std::optional(number);
    }
    /**
     * Returns a reference to the number that `find` would return, or to a new entry of `kNoNumber`
     * that the caller must set at once. The reference is valid until the next call.
     */
    template <class Matches>
    [[nodiscard]] int& entry(std::size_t hash, const Matches& matches)
    {
        if (2 * m_count >= m_slots.size())
            grow();
        Slot& slot = m_slots[place(m_slots, hash, matches)];
        if (slot.number == kNoNumber) {
            slot.hash = hash;
            ++m_count;
        }
        return slot.number;
    }

private:
    struct Slot
    {
        std::size_t hash = 0;
        int number = kNoNumber;
    };

    template <class Matches>
    static std::size_t place(const std::vector<Slot>& table, std::size_t hash,
                             const Matches& matches)
    {
        std::size_t k = (hash ^ (hash >> 32)) & (table.size() - 1);
        while (table[k].number != kNoNumber && !(table[k].hash == hash && matches(table[k].number)))
            k = (k + 1) & (table.size() - 1);
        return k;
    }
    void grow()
    {
        std::vector<Slot> larger(2 * m_slots.size());
        for (const Slot& slot : m_slots)
            if (slot.number != kNoNumber)
                larger[place(larger, slot.hash, [](int) { return false; })] = slot;
        m_slots = std::move(larger);
    }

    std::vector<Slot> m_slots; ///< a power of two
    std::size_t m_count = 0;
};

} // namespace berg
