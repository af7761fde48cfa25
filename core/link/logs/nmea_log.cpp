#include "core/link/logs/nmea_log.h"

#include "core/link/nmea/nmea_fields.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostUntimed = 10'000;
constexpr std::size_t kLongestNmeaLine = 4096; ///< A line without an end is divided.
constexpr std::int64_t kLine_us = 100'000;

} // namespace

bool isNmeaLog(std::string_view start)
{
    constexpr int kMostLines = 200;
    for (int i = 0; i < kMostLines && !start.empty(); ++i) {
        const std::size_t end = start.find('\n');
        std::string_view line = start.substr(0, end);
        start.remove_prefix(end == std::string_view::npos ? start.size() : end + 1);
        if (line.find('\0') != std::string_view::npos)
            return false;
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        const std::size_t first = line.find_last_of("$!");
        if (first == std::string_view::npos || line.size() < first + 9)
            continue;
        const std::string_view content = line.substr(first + 1, line.size() - first - 4);
        if (content[5] == ',' && hasNmeaChecksum(line.substr(first), content))
            return true;
    }
    return false;
}

std::vector<LoggedFrame> NmeaLogReader::feed(std::span<const std::uint8_t> bytes)
{
    std::vector<LoggedFrame> frames;
    for (const std::uint8_t byte : bytes) {
        m_line.push_back(byte);
        if (byte == '\n' || m_line.size() >= kLongestNmeaLine)
            endLine(frames);
    }
    return frames;
}

std::vector<LoggedFrame> NmeaLogReader::finish()
{
    std::vector<LoggedFrame> frames;
    if (!m_line.empty())
        endLine(frames);
    m_isTimeless = m_isTimeless || !m_time_us;
    give(frames);
    return frames;
}

void NmeaLogReader::endLine(std::vector<LoggedFrame>& frames)
{
    std::vector<std::uint8_t> line = std::exchange(m_line, {});
    const std::vector<NmeaFix> fixes = m_reader.feed(line);
    static_cast<void>(m_reader.takeTargets());
    if (!m_reader.takeFindings().empty())
        m_skipped_bytes += line.size();
    if (!m_isTimeless && m_reader.clock_us())
        m_time_us = m_reader.clock_us();
    else if (!m_isTimeless && !fixes.empty() && fixes.back().timeOfDay_s)
        m_time_us = std::llround(1e6 * *fixes.back().timeOfDay_s);
    m_waiting.push_back({.frame = {.bytes = std::move(line)}});
    m_isTimeless = m_isTimeless || (!m_time_us && m_waiting.size() >= kMostUntimed);
    if (m_time_us || m_isTimeless)
        give(frames);
}

void NmeaLogReader::give(std::vector<LoggedFrame>& frames)
{
    for (LoggedFrame& frame : m_waiting) {
        if (m_isTimeless)
            m_time_us = m_time_us.value_or(0) + kLine_us;
        frame.unix_us = m_time_us.value_or(0);
    }
    std::ranges::move(m_waiting, std::back_inserter(frames));
    m_waiting.clear();
}

} // namespace berg
