#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <vector>

namespace berg {

/**
 * The number, from 0, of one iceberg, UAV or place of a map. It converts neither to an `int` nor to
 * the number of another kind, so an iceberg cannot be taken for a UAV, for a node of a planning
 * problem or for a row. Only constants convert to it; other numbers need `of`. It costs what an
 * `int` costs.
 */
template <class Kind>
class Index
{
public:
    constexpr Index() = default;
    consteval Index(int constant) : m_number(constant) {} // NOLINT(google-explicit-constructor)
    [[nodiscard]] static constexpr Index of(std::integral auto number)
    {
        Index index;
        index.m_number = static_cast<int>(number);
        return index;
    }
    [[nodiscard]] constexpr int number() const { return m_number; }
    constexpr Index& operator++()
    {
        ++m_number;
        return *this;
    }
    auto operator<=>(const Index&) const = default; // NOLINT(modernize-use-nullptr)

private:
    int m_number = 0;
};

/** Numbers of one kind that follow one another, for loops. */
template <class Kind>
class IndexRange
{
public:
    /** The numbers 0 .. count - 1. */
    constexpr explicit IndexRange(std::integral auto count) : m_end(Index<Kind>::of(count)) {}
    /** The numbers begin .. end - 1. */
    constexpr IndexRange(Index<Kind> begin, Index<Kind> end) : m_begin(begin), m_end(end) {}

    class Iterator
    {
    public:
        constexpr explicit Iterator(Index<Kind> at) : m_at(at) {}
        constexpr Index<Kind> operator*() const { return m_at; }
        constexpr Iterator& operator++()
        {
            ++m_at;
            return *this;
        }
        constexpr bool operator==(const Iterator&) const = default;

    private:
        Index<Kind> m_at;
    };
    [[nodiscard]] constexpr Iterator begin() const { return Iterator(m_begin); }
    [[nodiscard]] constexpr Iterator end() const { return Iterator(m_end); }

private:
    Index<Kind> m_begin;
    Index<Kind> m_end;
};

/** An iceberg of a mission: those of the scenario in its order, then those added in flight. */
using IcebergIndex = Index<class IcebergKind>;
/** All icebergs up to a count. */
using IcebergRange = IndexRange<class IcebergKind>;
/** Icebergs in an order, such as that of their visits. */
using IcebergList = std::vector<IcebergIndex>;

/** A node of a planning problem: 0 is the UAV, the others are its icebergs. */
using NodeIndex = Index<class NodeKind>;
/** Nodes that follow one another. */
using NodeRange = IndexRange<class NodeKind>;

/** Returns the place of an iceberg or node in a container that has one entry for each. */
template <class Kind>
[[nodiscard]] constexpr std::size_t toIndex(Index<Kind> i)
{
    return static_cast<std::size_t>(i.number());
}
/** Converts the index of a UAV, at least 0, for use with containers. */
[[nodiscard]] constexpr std::size_t toIndex(int i)
{
    return static_cast<std::size_t>(i);
}

} // namespace berg
