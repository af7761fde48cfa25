#pragma once

#include "core/link/message/link_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace berg {

/**
 * Returns a record of a telemetry log (tlog) in the format of QGroundControl, Mission Planner and
 * MAVProxy: microseconds since 1970 in 8 bytes, big-endian, then the frame.
 */
[[nodiscard]] std::vector<std::uint8_t> logRecord(std::int64_t unix_us,
                                                  std::span<const std::uint8_t> frame);

/** A frame of a telemetry log with the time when it was sent or received. */
struct LoggedFrame
{
    std::int64_t unix_us = 0;
    LinkFrame frame;
};

/**
 * Reads a telemetry log piece by piece. Bytes outside records are skipped one by one, so reading
 * continues behind damage. Memory: one record more than the bytes fed at a time.
 */
class TelemetryLogReader
{
public:
    /**
     * Processes bytes of the log and returns the frames found so far. A record is examined only
     * when 288 bytes from its start have arrived, so the last frames come from `finish`.
     */
    [[nodiscard]] std::vector<LoggedFrame> feed(std::span<const std::uint8_t> bytes);
    /** Ends the log: returns its last frames; bytes of an incomplete record count as skipped. */
    [[nodiscard]] std::vector<LoggedFrame> finish();

    /** Returns the number of bytes so far that belong to no record. */
    [[nodiscard]] std::uint64_t skipped_bytes() const { return m_skipped_bytes; }

private:
    [[nodiscard]] std::vector<LoggedFrame> parse(bool isAtEnd);

    FrameParser m_parser;
    std::vector<std::uint8_t> m_buffer;
    std::uint64_t m_skipped_bytes = 0;
};

} // namespace berg
