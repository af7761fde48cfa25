#pragma once

#include "core/link/logs/telemetry_log.h"
#include "core/link/nmea/nmea_reader.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace berg {

/**
 * Returns true if the start of a file is a log of NMEA 0183 sentences: text with at least one whole
 * sentence, with its checksum, among the first 200 lines.
 */
[[nodiscard]] bool isNmeaLog(std::string_view start);

/**
 * Reads a log of NMEA 0183 sentences piece by piece as frames of one line each, with the time that
 * the log has reached there (`NmeaReader::clock_us`). Lines before the first time have that time.
 * In a log without dates the times of day count from 1970, and in one without any time ten lines
 * are a second. Memory: the lines before the first time, at most 10,000.
 */
class NmeaLogReader
{
public:
    [[nodiscard]] std::vector<LoggedFrame> feed(std::span<const std::uint8_t> bytes);
    /** Ends the log: returns its last lines. */
    [[nodiscard]] std::vector<LoggedFrame> finish();

    /** Returns the number of bytes so far of lines that give nothing (`NmeaFinding`). */
    [[nodiscard]] std::uint64_t skipped_bytes() const { return m_skipped_bytes; }

private:
    void endLine(std::vector<LoggedFrame>& frames);
    void give(std::vector<LoggedFrame>& frames);

    NmeaReader m_reader;
    std::vector<std::uint8_t> m_line;
    std::vector<LoggedFrame> m_waiting; ///< Lines before the first time.
    std::optional<std::int64_t> m_time_us;
    bool m_isTimeless = false; ///< Lines are counted in place of a clock.
    std::uint64_t m_skipped_bytes = 0;
};

} // namespace berg
