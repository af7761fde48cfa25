#pragma once

#include "core/plan/proof/layered_paths.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace berg {

// Allocating, copying or releasing hundreds of megabytes takes tens of milliseconds. The helpers
// below work in pieces with checks for a stop in between, or use another thread.

/**
 * Deleter for smart pointers to objects with `bytes()`: it releases large objects on another
 * thread, so that the caller does not wait.
 */
struct DeferredDeleter
{
    template <class T>
    void operator()(T* object) const
    {
        constexpr std::int64_t kMuch_bytes = 16'000'000; // releasing this takes about a millisecond
        std::unique_ptr<T> owned(object);
        if (owned == nullptr || owned->bytes() < kMuch_bytes)
            return;
        try {
            std::thread([held = std::move(owned)] {}).detach();
        } catch (const std::system_error&) {
            // There are no more threads, so the memory is released here.
        }
    }
};

/** Elements of a piece: up to half a MB, which takes well below a millisecond. */
inline constexpr std::size_t kPieceLength = std::size_t{1} << 16;

/** Replaces the contents of `vector` by `size` copies of `value`. Returns false if stopped. */
template <class Vector>
[[nodiscard]] bool fillInPieces(Vector& vector, std::size_t size, typename Vector::value_type value,
                                const StopCheck& isStopped)
{
    vector.clear();
    vector.reserve(size);
    while (vector.size() < size) {
        if (isStopped && isStopped())
            return false;
        vector.resize(std::min(size, vector.size() + kPieceLength), value);
    }
    return true;
}

/** A list that grows without moving its elements. */
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

    /**
     * Calls `visitor(element)` for each element in order and empties the list. Returns false if
     * stopped; the elements visited so far are then gone, and the list is unusable.
     */
    template <class Visitor>
    [[nodiscard]] bool forEach(const StopCheck& isStopped, const Visitor& visitor)
    {
        for (std::vector<T>& piece : m_pieces) {
            if (isStopped && isStopped())
                return false;
            std::for_each(piece.begin(), piece.end(), visitor);
            piece = {};
        }
        m_pieces.clear();
        return true;
    }

    /**
     * Appends `change(element)` of each element to `target` and empties the list. Returns false if
     * stopped; the elements are then divided between both, and the list is unusable.
     */
    template <class Target, class Change>
    [[nodiscard]] bool moveTo(Target& target, const StopCheck& isStopped, const Change& change)
    {
        target.reserve(target.size() + size());
        return forEach(isStopped, [&](const T& element) { target.push_back(change(element)); });
    }
    /** Moves the elements as they are, like the function above. */
    template <class Target>
    [[nodiscard]] bool moveTo(Target& target, const StopCheck& isStopped)
    {
        return moveTo(target, isStopped, [](const T& element) { return element; });
    }

private:
    std::vector<std::vector<T>> m_pieces;
};

} // namespace berg
