#include "app/cli/link_options.h"

#include "app/cli/options.h"
#include "app/cli/output_gate.h"
#include "core/link/logs/telemetry_log.h"
#include "core/link/transport/link_clock.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

namespace berg::cli {

namespace {

constexpr double kStep_s = 0.05;

} // namespace

void addLinkOptions(CLI::App& command, LinkArguments& arguments)
{
    command.add_option("--link", arguments.link,
                       "udp:HOST:PORT (listens), udpout:HOST:PORT, tcp:HOST:PORT or "
                       "serial:DEVICE:BAUD");
    addOutputFile(command, "--tlog", arguments.tlog, "Telemetry log for all frames");
    command.add_option("--duration", arguments.duration_s, "Seconds until the end (Ctrl-C)")
        ->check(numberFrom(0.1, 604800.0));
    addForce(command, arguments.force);
}

std::unique_ptr<TransportLink> linkOf(const LinkArguments& arguments)
{
    const auto reading = readEndpoint(arguments.link);
    if (const auto* const fault = std::get_if<EndpointFault>(&reading)) {
        const Sentence reason = sentence(englishWords(*fault), {word(arguments.link)});
        throw UsageError(
            Sentence{.english = "--link: " + reason.english, .said = "--link: " + reason.said});
    }
    const auto& endpoint = std::get<LinkEndpoint>(reading);
    if (!isLocal(endpoint))
        printNote(said(QT_TRANSLATE_NOOP("CommandLine",
                                         "%1 can be reached from the network; MAVLink is neither "
                                         "encrypted nor signed"),
                       {endpointText(endpoint)}));
    return openLink(endpoint);
}

TelemetryFile::TelemetryFile(const std::string& path) : m_path(path)
{
    if (path.empty())
        return;
    m_file.open(path, std::ios::binary | std::ios::trunc);
    if (!m_file)
        throw Error(ErrorCode::FileUnwritable, path,
                    {IssueId::CannotMakeIt, {std::generic_category().message(errno)}});
}

void TelemetryFile::add(LinkTime now, std::span<const std::uint8_t> frame)
{
    if (!m_file.is_open() || m_isFull)
        return;
    const std::vector<std::uint8_t> record = logRecord(now.unix_us, frame);
    m_isFull = m_bytes + record.size() > kLargestLog;
    if (m_isFull) {
        printMessage(
            said(QT_TRANSLATE_NOOP("CommandLine", "%1 ends here: it has 1 GiB"), {word(m_path)}));
        return;
    }
    m_file.write(reinterpret_cast<const char*>(record.data()),
                 static_cast<std::streamsize>(record.size()));
    m_bytes += record.size();
}

void TelemetryFile::flush()
{
    if (m_file.is_open() && !m_file.flush())
        throw Error(ErrorCode::FileUnwritable, m_path, {IssueId::StreamUnwritable});
}

void LinkReporter::report(const TransportLink& link)
{
    const LinkCondition now = link.condition();
    if (now.state == LinkCondition::State::Broken && now != m_last)
        printMessage(said(QT_TRANSLATE_NOOP("CommandLine", "the link is broken: %1"), {now.fault}));
    if (now.state == LinkCondition::State::Open && m_last.state == LinkCondition::State::Broken)
        printNote(said(QT_TRANSLATE_NOOP("CommandLine", "the link is open again"), {}));
    if (now.state != LinkCondition::State::Opening) // an attempt to open it is no news
        m_last = now;
    if (link.ignored() > 0 && !m_isStrangerReported) {
        m_isStrangerReported = true;
        printNote(said(QT_TRANSLATE_NOOP("CommandLine",
                                         "packets from %1, which is not part of the link, are "
                                         "ignored"),
                       {link.lastIgnored()}));
    }
}

void runLink(const std::optional<double>& duration_s, const std::stop_token& stop,
             const std::function<void(LinkTime)>& step, const std::function<void()>& everySecond)
{
    const double start_s = monotonicNow_s();
    double nextSecond_s = start_s + 1;
    while (!stop.stop_requested()) {
        const LinkTime now = linkTimeNow();
        if (duration_s && now.monotonic_s - start_s >= *duration_s)
            return;
        step(now);
        if (now.monotonic_s >= nextSecond_s) {
            nextSecond_s = std::max(nextSecond_s + 1, now.monotonic_s);
            everySecond();
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(kStep_s));
    }
}

} // namespace berg::cli
