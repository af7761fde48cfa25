#include "core/io/export/content/track_points.h"

#include "core/base/error.h"
#include "core/io/text/file_backed_buffer.h"

#include <array>
#include <cstring>

namespace berg {

namespace {

using Numbers = std::array<double, 6>;

constexpr std::size_t kReadAtOnce = 512;

Numbers numbersOf(const TrackPoint& point)
{
    return {
        point.time_s,  point.state.position_m.x(), point.state.position_m.y(), point.state.psi_rad,
        point.u_radps, point.crossTrack_m};
}

TrackPoint pointOf(const Numbers& numbers)
{
    return {.time_s = numbers[0],
            .state = {.position_m = {numbers[1], numbers[2]}, .psi_rad = numbers[3]},
            .u_radps = numbers[4],
            .crossTrack_m = numbers[5]};
}

} // namespace

TrackPoints::TrackPoints() : m_buffer(std::make_shared<FileBackedBuffer>()) {}

TrackPoints::TrackPoints(const std::vector<TrackPoint>& points) : TrackPoints()
{
    for (const TrackPoint& point : points)
        append(point);
}

void TrackPoints::append(const TrackPoint& point)
{
    require(m_buffer.use_count() == 1, "TrackPoints::append: others read them");
    const Numbers numbers = numbersOf(point);
    std::array<char, sizeof numbers> bytes{};
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    m_buffer->append({bytes.data(), bytes.size()});
    if (m_size++ == 0)
        m_front = point;
    m_back = point;
}

void TrackPoints::clear()
{
    m_buffer->clear();
    m_size = 0;
}

TrackPoints::Iterator TrackPoints::begin() const
{
    return Iterator(*this);
}

std::vector<TrackPoint> TrackPoints::all() const
{
    std::vector<TrackPoint> points;
    points.reserve(m_size);
    for (const TrackPoint& point : *this)
        points.push_back(point);
    return points;
}

TrackPoints::Iterator::Iterator(const TrackPoints& points) : m_buffer(points.m_buffer)
{
    read();
}

TrackPoints::Iterator& TrackPoints::Iterator::operator++()
{
    if (++m_at == m_read.size())
        read();
    return *this;
}

void TrackPoints::Iterator::read()
{
    std::array<char, kReadAtOnce * sizeof(Numbers)> bytes{};
    const std::size_t got = m_buffer->read(m_next, bytes);
    m_next += got;
    m_at = 0;
    m_read.clear();
    for (std::size_t at = 0; at < got; at += sizeof(Numbers)) {
        Numbers numbers{};
        std::memcpy(numbers.data(), bytes.data() + at, sizeof numbers);
        m_read.push_back(pointOf(numbers));
    }
}

} // namespace berg
