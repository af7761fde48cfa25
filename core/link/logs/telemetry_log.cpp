#include "core/link/logs/telemetry_log.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kTimeBytes = 8;
constexpr std::size_t kLongestRecord = kTimeBytes + 280;
constexpr std::uint64_t kLatestTime_us = 4'102'444'800'000'000; ///< 2100; later times are noise

std::uint64_t bigEndian(std::span<const std::uint8_t> bytes)
{
    std::uint64_t value = 0;
    for (std::uint8_t byte : bytes)
        value = value << 8U | byte;
    return value;
}

} // namespace

std::vector<std::uint8_t> logRecord(std::int64_t unix_us, std::span<const std::uint8_t> frame)
{
    std::vector<std::uint8_t> record(kTimeBytes + frame.size());
    for (std::size_t i = 0; i < kTimeBytes; ++i)
        record[i] = static_cast<std::uint8_t>(
            static_cast<std::uint64_t>(unix_us) >> (8 * (kTimeBytes - 1 - i)) & 0xFFU);
    std::copy(frame.begin(), frame.end(), record.begin() + kTimeBytes);
    return record;
}

std::vector<LoggedFrame> TelemetryLogReader::feed(std::span<const std::uint8_t> bytes)
{
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
    return parse(false);
}

std::vector<LoggedFrame> TelemetryLogReader::finish()
{
    return parse(true);
}

std::vector<LoggedFrame> TelemetryLogReader::parse(bool isAtEnd)
{
    std::vector<LoggedFrame> found;
    std::size_t at = 0;
    while (at < m_buffer.size() && (isAtEnd || m_buffer.size() - at >= kLongestRecord)) {
        const std::span<const std::uint8_t> rest = std::span(m_buffer).subspan(at);
        std::vector<LinkFrame> frames;
        if (rest.size() > kTimeBytes && bigEndian(rest.first(kTimeBytes)) < kLatestTime_us) {
            const std::span<const std::uint8_t> frame = rest.subspan(kTimeBytes);
            const std::size_t length = announcedLength(frame).value_or(0);
            if (length > 0 && length <= frame.size())
                frames = m_parser.feedDatagram(frame.first(length));
            if (frames.size() == 1 && frames.front().bytes.size() == length) {
                found.push_back(
                    {.unix_us = static_cast<std::int64_t>(bigEndian(rest.first(kTimeBytes))),
                     .frame = std::move(frames.front())});
                at += kTimeBytes + length;
                continue;
            }
        }
        ++m_skipped_bytes;
        ++at;
    }
    m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(at));
    return found;
}

} // namespace berg
