#pragma once

#include "core/sim/visits.h"

#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <vector>

namespace berg {

class Spool;

/**
 * Where a UAV was or is to be, by time. Of a long flight most of it is in a temporary file, so that
 * memory does not grow with it; copies share it. Throws as `Spool`.
 */
class TrackPoints
{
public:
    class Iterator;

    TrackPoints();
    TrackPoints(const std::vector<TrackPoint>& points); // NOLINT(google-explicit-constructor)

    /** Not while there are copies. */
    void append(const TrackPoint& point);
    void clear();

    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    /** There must be one. */
    [[nodiscard]] const TrackPoint& front() const { return m_front; }
    [[nodiscard]] const TrackPoint& back() const { return m_back; }
    [[nodiscard]] Iterator begin() const;
    [[nodiscard]] static std::default_sentinel_t end() { return {}; }
    /** All of them in memory. */
    [[nodiscard]] std::vector<TrackPoint> all() const;

private:
    std::shared_ptr<Spool> m_spool;
    std::size_t m_size = 0;
    TrackPoint m_front;
    TrackPoint m_back;
};

/** Reads some hundred points at a time. */
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

    std::shared_ptr<const Spool> m_spool;
    std::size_t m_next = 0; ///< to be read
    std::vector<TrackPoint> m_read;
    std::size_t m_at = 0;
};

} // namespace berg
