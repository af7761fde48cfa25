#pragma once

#include "core/mission/visits.h"

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <vector>

namespace berg {

class FileBackedBuffer;

/**
 * Positions of a UAV by time. Most of a long flight is in a temporary file, so that memory does not
 * grow with it; copies share the file. Throws as `FileBackedBuffer`.
 */
class TrackPoints
{
public:
    class Iterator;

    TrackPoints();
    TrackPoints(const std::vector<TrackPoint>& points); // NOLINT(google-explicit-constructor)

    /** Adds a point. Throws `std::logic_error` if there are copies of this object. */
    void append(const TrackPoint& point);
    /**
     * Removes all points. There must be no copies of this object, whose points are lost as well.
     */
    void clear();

    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    /** Returns the first point; the track must not be empty. */
    [[nodiscard]] const TrackPoint& front() const { return m_front; }
    /** Returns the last point; the track must not be empty. */
    [[nodiscard]] const TrackPoint& back() const { return m_back; }
    [[nodiscard]] Iterator begin() const;
    [[nodiscard]] static std::default_sentinel_t end() { return {}; }
    /** Returns all points in memory. */
    [[nodiscard]] std::vector<TrackPoint> all() const;

private:
    std::shared_ptr<FileBackedBuffer> m_buffer;
    std::size_t m_size = 0;
    TrackPoint m_front;
    TrackPoint m_back;
};

/** Input iterator that reads some hundred points at a time. */
class TrackPoints::Iterator
{
public:
    using value_type = TrackPoint;
    using difference_type = std::ptrdiff_t;

    explicit Iterator(const TrackPoints& points);

    const TrackPoint& operator*() const { return m_read[m_at]; }
    Iterator& operator++();
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t /*end*/) const { return m_at == m_read.size(); }

private:
    void read();

    std::shared_ptr<const FileBackedBuffer> m_buffer;
    std::size_t m_next = 0; ///< position of the next read in the buffer, bytes
    std::vector<TrackPoint> m_read;
    std::size_t m_at = 0;
};

} // namespace berg
