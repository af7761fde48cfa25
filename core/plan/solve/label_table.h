#pragma once

#include "core/plan/solve/layered_graph.h"
#include "core/plan/solve/number_table.h"

#include <algorithm>
#include <vector>

namespace berg {

/** The (old node, memory) pairs of one level while a graph is refined. */
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

    [[nodiscard]] const std::vector<Label>& labels() const { return m_labels; }
    /** Number of the label, which becomes as long as `length` at most. */
    int offer(const Label& label)
    {
        const auto node = static_cast<std::size_t>(label.node);
        int& place = m_places.entry(label.memory.hash() + node * 0x9e3779b97f4a7c15U, [&](int k) {
            const Label& other = m_labels[static_cast<std::size_t>(k)];
            return other.node == label.node && other.memory == label.memory;
        });
        if (place < 0) {
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
    NumberTable m_places; ///< in `m_labels`
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
