#pragma once

#include "core/link/logs/nmea_log.h"
#include "core/link/logs/telemetry_log.h"
#include "core/link/message/byte_link.h"

#include <cstdint>
#include <deque>
#include <fstream>
#include <memory>
#include <string>
#include <variant>

namespace berg {

/** Reason why a log cannot be played. */
struct LogFault
{
    enum class Kind
    {
        Unreadable, ///< `reason` has the system's words.
        NotALog     ///< Its first mebibyte contains neither a record nor a sentence.
    };
    Kind kind = Kind::Unreadable;
    std::string reason;
};

/**
 * A telemetry log, or a log of NMEA 0183 sentences (`isNmeaLog`), as a link: each frame or line is
 * received at its time, by a clock that `advance` moves.
 * Bytes sent are dropped. Times that jump back by more than a second or ahead by more than ten
 * minutes are taken as a change of the recording clock and cost no time. The file is read in
 * pieces, so that its size does not matter; memory: some pieces. Damaged parts are skipped. Used by
 * one thread.
 */
class LogReplay final : public ByteLink
{
public:
    /** Opens a log; only a regular file is accepted, because others may block. */
    [[nodiscard]] static std::variant<std::unique_ptr<LogReplay>, LogFault>
    open(const std::string& path);

    [[nodiscard]] bool isDatagram() const override { return true; }
    [[nodiscard]] std::vector<int> peers() const override { return {}; }
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int /*peer*/, std::span<const std::uint8_t> /*bytes*/) override {}

    /** Moves the clock on, but not beyond the last frame. */
    void advance(double step_s);
    /** Returns the time of the log; its monotonic clock begins with `kStart_s`. */
    [[nodiscard]] LinkTime time() const;
    /** Returns the time played, without jumps, s. */
    [[nodiscard]] double played_s() const { return static_cast<double>(m_clock_us) / 1e6; }
    /** Returns the part of the file that has been played, 0 to 1. */
    [[nodiscard]] double part() const;
    [[nodiscard]] bool isAtEnd() const { return m_isRead && m_frames.empty(); }
    /** Returns the number of bytes so far that belong to no record or whole sentence. */
    [[nodiscard]] std::uint64_t skipped_bytes() const
    {
        return m_reader.skipped_bytes() + m_lines.skipped_bytes();
    }

    static constexpr double kStart_s = 1;

private:
    /** A frame that has been read and not yet received. */
    struct Waiting
    {
        std::int64_t at_us = 0; ///< by the clock of the replay
        std::int64_t unix_us = 0;
        std::vector<std::uint8_t> bytes;
    };

    LogReplay(std::ifstream file, std::uint64_t size) : m_file(std::move(file)), m_size(size) {}

    /** Reads on until frames wait, at most some pieces at once. */
    void read();
    [[nodiscard]] std::uint64_t recordSize(std::span<const std::uint8_t> frame) const;
    void add(std::vector<LoggedFrame> frames);

    std::ifstream m_file;
    std::uint64_t m_size;
    std::uint64_t m_read_bytes = 0;
    std::uint64_t m_waiting_bytes = 0; ///< of `m_frames` in the file
    bool m_isRead = false;
    bool m_isNmea = false;
    TelemetryLogReader m_reader;
    NmeaLogReader m_lines; ///< in place of `m_reader`
    std::deque<Waiting> m_frames;
    std::int64_t m_clock_us = 0;
    std::int64_t m_last_us = 0; ///< of the frame added last
    /** Time of the log at which the clock would be 0; set by the first frame. */
    std::optional<std::int64_t> m_zero_us;
};

} // namespace berg
