#pragma once

#include "app/cli/commands.h"
#include "core/link/message/frame_exchange.h"
#include "core/link/transport/transport_link.h"

#include <fstream>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace berg::cli {

/** Largest telemetry log that is written or read, bytes. */
inline constexpr std::size_t kLargestLog = std::size_t{1} << 30U;

/** Options of commands that use a live link. */
struct LinkArguments
{
    std::string link; ///< as `readEndpoint` reads it
    std::string tlog;
    std::optional<double> duration_s;
    bool force = false;
};

/** Adds --link, --tlog, --duration and --force. */
void addLinkOptions(CLI::App& command, LinkArguments& arguments);

/** Opens the link; throws `UsageError` for a wrong --link. Notes a link that leaves the computer.
 */
[[nodiscard]] std::unique_ptr<TransportLink> linkOf(const LinkArguments& arguments);

/**
 * A telemetry log that is written while the link runs. Without a path nothing is written. It ends
 * at 1 GiB, with a note.
 */
class TelemetryFile
{
public:
    /** Throws `Error{FileUnwritable}` if the file cannot be created. */
    explicit TelemetryFile(const std::string& path);
    void add(LinkTime now, std::span<const std::uint8_t> frame);
    /** Passes the content to the system; throws `Error{FileUnwritable}` on failure. */
    void flush();

private:
    std::string m_path;
    std::ofstream m_file;
    std::size_t m_bytes = 0;
    bool m_isFull = false;
};

/** Reports changes of a link's condition and the first stranger that it ignores. */
class LinkReporter
{
public:
    void report(const TransportLink& link);

private:
    LinkCondition m_last;
    bool m_isStrangerReported = false;
};

/**
 * Calls `step` 20 times a second, and `everySecond` once, until a stop is requested or the duration
 * is over. Lateness is not caught up.
 */
void runLink(const std::optional<double>& duration_s, const std::stop_token& stop,
             const std::function<void(LinkTime)>& step, const std::function<void()>& everySecond);

} // namespace berg::cli
