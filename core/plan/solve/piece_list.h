#pragma once

#include "core/plan/solve/layered_paths.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace berg {

// Memory by the hundred megabytes takes tens of milliseconds to come, to be copied and to go: these
// do it a piece at a time and look at the clock in between, or leave it to another thread.

/** For smart pointers to what knows its `bytes()`: much memory is given back on another thread, so
 * that nobody waits for that. */
struct FreeElsewhere
{
    template <class T>
    void operator()(T* thing) const
    {
        constexpr std::int64_t kMuch_bytes = 16'000'000; // takes about a millisecond
        std::unique_ptr<T> owned(thing);
        if (owned == nullptr || owned->bytes() < kMuch_bytes)
            return;
        try {
            std::thread([held = std::move(owned)] {}).detach();
        } catch (const std::system_error&) {
            // No more threads: freed here and now.
        }
    }
};

/** Elements of a piece: up to half a MB, well below a millisecond. */
inline constexpr std::size_t kPieceLength = std::size_t{1} << 16;

/** `vector` emptied and filled with so many of `value`; false when cut. */
template <class Vector>
[[nodiscard]] bool fillInPieces(Vector& vector, std::size_t size, typename Vector::value_type value,
                                const CutQuestion& cut)
{
    vector.clear();
    vector.reserve(size);
    while (vector.size() < size) {
        if (cut && cut())
            return false;
        vector.resize(std::min(size, vector.size() + kPieceLength), value);
    }
    return true;
}

/** Grows without moving what it holds. */
template <class T>
class PieceList
{
public:
    [[nodiscard]] std::size_t size() const
    {
        return m_pieces.empty() ? 0 : (m_pieces.size() - 1) * kPieceLength + m_pieces.back().size();
    }

    [[nodiscard]] std::int64_t bytes() const
    {
        return static_cast<std::int64_t>(size() * sizeof(T));
    }

    void push_back(T value)
    {
        if (m_pieces.empty() || m_pieces.back().size() == kPieceLength)
            m_pieces.emplace_back().reserve(kPieceLength);
        m_pieces.back().push_back(value);
    }

    /** Calls `take(element)` for each in turn, once: the list is used up. False when cut. */
    template <class Take>
    [[nodiscard]] bool forEach(const CutQuestion& cut, const Take& take)
    {
        for (std::vector<T>& piece : m_pieces) {
            if (cut && cut())
                return false;
            std::for_each(piece.begin(), piece.end(), take);
            piece = {};
        }
        m_pieces.clear();
        return true;
    }

    /** Appends `change` of each element to `target`, once: the list is used up. False when cut. */
    template <class Target, class Change>
    [[nodiscard]] bool moveTo(Target& target, const CutQuestion& cut, const Change& change)
    {
        target.reserve(target.size() + size());
        return forEach(cut, [&](const T& element) { target.push_back(change(element)); });
    }
    template <class Target>
    [[nodiscard]] bool moveTo(Target& target, const CutQuestion& cut)
    {
        return moveTo(target, cut, [](const T& element) { return element; });
    }

private:
    std::vector<std::vector<T>> m_pieces;
};

} // namespace berg
