#pragma once

#include "core/plan/proof/layered_graph.h"
#include "core/plan/proof/number_table.h"

#include <algorithm>
#include <vector>

namespace berg {

/** The (old node, memory) pairs of one level while a graph is refined. */
class LabelTable
{
public:
    /** A node of the old graph with a memory, and the least length to it. */
    struct Label
    {
        NodeSet memory;
        double length = 0;
        int node = 0;
        int number = 0; ///< number among all labels
    };

    [[nodiscard]] const std::vector<Label>& labels() const { return m_labels; }
    /** Returns the number of the label, and lowers its length to `length` if that is smaller. */
    int offer(const Label& label)
    {
        const auto node = static_cast<std::size_t>(label.node);
        int& place = m_places.entry(label.memory.hash() + node * 0x9e3779b97f4a7c15U, [&](int k) {
            const Label& other = m_labels[static_cast<std::size_t>(k)];
            return other.node == label.node && other.memory == label.memory;
        });
        if (place == NumberTable::kNoNumber) {
            place = static_cast<int>(m_labels.size());
            m_labels.push_back(label);
            return label.number;
        }
        Label& known = m_labels[static_cast<std::size_t>(place)];
        known.length = std::min(known.length, label.length);
        return known.number;
    }
    void clear()
    {
        m_labels.clear();
        m_places.clear();
    }

private:
    std::vector<Label> m_labels;
    NumberTable m_places; ///< indices in `m_labels`
};

/** The labels of the present level and of those that one step may reach. */
class LabelTables
{
public:
    explicit LabelTables(int longestStep) : m_tables(static_cast<std::size_t>(longestStep) + 1) {}
    /** Returns the table of a level. */
    [[nodiscard]] LabelTable& at(int level)
    {
        return m_tables[static_cast<std::size_t>(level) % m_tables.size()];
    }
    /**
     * Offers a label at a level (`LabelTable::offer`); labels are numbered in the order of their
     * creation.
     */
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
