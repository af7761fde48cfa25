#pragma once

#include "core/plan/solve/layered_graph.h"

#include <algorithm>
#include <vector>

namespace berg {

/** The (old node, memory) pairs of one level while a graph is refined: open addressing, grown by
 * doubling. */
class LabelTable
{
public:
    struct Label
    {
        NodeSet memory;
        double length = 0;
        int node = 0;
        int number = 0; ///< of all labels
    };

    LabelTable() : m_slots(256, -1) {}
    [[nodiscard]] const std::vector<Label>& labels() const { return m_labels; }
    /** Number of the label, which becomes as long as `length` at most. */
    int offer(const Label& label)
    {
        if (4 * m_labels.size() >= m_slots.size())
            resize(2 * m_slots.size());
        std::size_t slot = slotOf(label);
        for (; m_slots[slot] >= 0; slot = (slot + 1) & (m_slots.size() - 1)) {
            Label& other = m_labels[static_cast<std::size_t>(m_slots[slot])];
            if (other.node == label.node && other.memory == label.memory) {
                other.length = std::min(other.length, label.length);
                return other.number;
            }
        }
        m_slots[slot] = static_cast<int>(m_labels.size());
        m_labels.push_back(label);
        return label.number;
    }
    void clear()
    {
        m_labels.clear();
        resize(m_slots.size());
    }

private:
    [[nodiscard]] std::size_t slotOf(const Label& label) const
    {
        const auto node = static_cast<std::size_t>(label.node);
        const std::size_t mixed = label.memory.hash() + node * 0x9e3779b97f4a7c15U;
        return (mixed ^ (mixed >> 32)) & (m_slots.size() - 1);
    }
    void resize(std::size_t slots)
    {
        m_slots.assign(slots, -1);
        for (std::size_t k = 0; k < m_labels.size(); ++k) {
            std::size_t slot = slotOf(m_labels[k]);
            while (m_slots[slot] >= 0)
                slot = (slot + 1) & (slots - 1);
            m_slots[slot] = static_cast<int>(k);
        }
    }

    std::vector<Label> m_labels;
    std::vector<int> m_slots; ///< a power of two
};

/** The labels of the level being treated and of those that a step may lead to. */
class LabelTables
{
public:
    explicit LabelTables(int longestStep) : m_tables(static_cast<std::size_t>(longestStep) + 1) {}
    [[nodiscard]] LabelTable& at(int level)
    {
        return m_tables[static_cast<std::size_t>(level) % m_tables.size()];
    }
    /** As `LabelTable::offer`; labels are numbered in the order they are made. */
    int offer(int level, LabelTable::Label label)
    {
        label.number = m_made;
        const int number = at(level).offer(label);
        m_made += number == m_made ? 1 : 0;
        return number;
    }

private:
    std::vector<LabelTable> m_tables;
    int m_made = 0;
};

} // namespace berg
