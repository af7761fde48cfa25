#include "core/link/logs/log_replay.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kPiece_bytes = 65536;
constexpr int kPiecesAtOnce = 16; ///< A mebibyte.
/** Programs that write from several threads mix frames within this time. */
constexpr std::int64_t kOutOfOrder_us = 1'000'000;
constexpr std::int64_t kLongestPause_us = 600'000'000;

} // namespace

/** Returns the size of a frame in the file: the time of a record takes 8 bytes. */
std::uint64_t LogReplay::recordSize(std::span<const std::uint8_t> frame) const
{
    return (m_isNmea ? 0 : 8) + frame.size();
}

std::variant<std::unique_ptr<LogReplay>, LogFault> LogReplay::open(const std::string& path)
{
    const auto unreadable = [](const std::error_code& code) {
        return LogFault{.kind = LogFault::Kind::Unreadable, .reason = code.message()};
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (error)
        return unreadable(error);
    if (!std::filesystem::is_regular_file(status))
        return unreadable(std::make_error_code(std::filesystem::is_directory(status)
                                                   ? std::errc::is_a_directory
                                                   : std::errc::not_supported));
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error)
        return unreadable(error);
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return unreadable({errno != 0 ? errno : EIO, std::generic_category()});
    std::unique_ptr<LogReplay> replay(new LogReplay(std::move(file), size));
    replay->read();
    if (replay->m_frames.empty())
        return LogFault{.kind = LogFault::Kind::NotALog};
    return replay;
}

void LogReplay::add(std::vector<LoggedFrame> frames)
{
    for (LoggedFrame& logged : frames) {
        std::int64_t at_us = logged.unix_us - m_zero_us.value_or(logged.unix_us);
        if (m_zero_us && at_us < m_last_us && m_last_us - at_us <= kOutOfOrder_us)
            at_us = m_last_us;
        if (!m_zero_us || at_us < m_last_us || at_us - m_last_us > kLongestPause_us) {
            m_zero_us = logged.unix_us - m_last_us;
            at_us = m_last_us;
        }
        m_last_us = at_us;
        m_waiting_bytes += recordSize(logged.frame.bytes);
        m_frames.push_back(
            {.at_us = at_us, .unix_us = logged.unix_us, .bytes = std::move(logged.frame.bytes)});
    }
}

void LogReplay::read()
{
    std::array<std::uint8_t, kPiece_bytes> piece{};
    for (int i = 0; i < kPiecesAtOnce && m_frames.empty() && !m_isRead; ++i) {
        m_file.read(reinterpret_cast<char*>(piece.data()), kPiece_bytes);
        const auto count = static_cast<std::size_t>(m_file.gcount());
        const std::span<const std::uint8_t> bytes = std::span(piece).first(count);
        if (m_read_bytes == 0)
            m_isNmea = isNmeaLog({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        m_read_bytes += count;
        add(m_isNmea ? m_lines.feed(bytes) : m_reader.feed(bytes));
        if (m_file) // else the end, or a failing disk: what has been read counts
            continue;
        m_isRead = true;
        add(m_isNmea ? m_lines.finish() : m_reader.finish());
    }
}

std::optional<LinkPacket> LogReplay::receive()
{
    if (m_frames.empty() || m_frames.front().at_us > m_clock_us)
        return std::nullopt;
    LinkPacket packet{.bytes = std::move(m_frames.front().bytes)};
    m_waiting_bytes -= recordSize(packet.bytes);
    m_frames.pop_front();
    if (m_frames.empty())
        read();
    return packet;
}

void LogReplay::advance(double step_s)
{
    if (m_frames.empty())
        read();
    m_clock_us += std::llround(1e6 * std::max(0.0, step_s));
    if (m_isRead || m_frames.empty()) // a damaged part that is being skipped costs no time
        m_clock_us = std::min(m_clock_us, m_last_us);
}

LinkTime LogReplay::time() const
{
    return {.monotonic_s = kStart_s + played_s(), .unix_us = m_clock_us + m_zero_us.value_or(0)};
}

double LogReplay::part() const
{
    return isAtEnd() || m_size == 0
               ? 1
               : std::min(1.0, static_cast<double>(m_read_bytes - m_waiting_bytes) /
                                   static_cast<double>(m_size));
}

} // namespace berg
