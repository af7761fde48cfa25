#include "core/link/message/frame_exchange.h"

#include <algorithm>
#include <utility>

namespace berg {

FrameExchange::FrameExchange(ByteLink& link, FrameExchangeOptions options)
    : m_link(link)
    , m_options(std::move(options))
    , m_writer(m_options.self, m_options.key)
    , m_checker(m_options.key)
{
}

bool FrameExchange::isWithinLimits(const LinkPacket& packet, double now_s)
{
    const ReceiveLimits& limits = m_options.limits;
    const auto known = m_peers.find(packet.peer);
    if (known == m_peers.end()) {
        if (m_peers.size() >= limits.mostPeers)
            return false;
        m_peers[packet.peer] = {.allowance_bytes = limits.burst_bytes, .updated_s = now_s};
    }
    Peer& peer = m_peers[packet.peer];
    peer.allowance_bytes = std::min(
        limits.burst_bytes, peer.allowance_bytes + limits.rate_bps * (now_s - peer.updated_s));
    peer.updated_s = now_s;
    const auto size = static_cast<double>(packet.bytes.size());
    if (size > peer.allowance_bytes)
        return false;
    peer.allowance_bytes -= size;
    return true;
}

std::vector<ReceivedFrame> FrameExchange::receive(LinkTime now)
{
    std::vector<ReceivedFrame> received;
    for (int i = 0; i < kPacketsAtOnce; ++i) {
        const std::optional<LinkPacket> packet = m_link.receive();
        if (!packet)
            break;
        if (!isWithinLimits(*packet, now.monotonic_s)) {
            m_dropped_bytes += packet->bytes.size();
            continue;
        }
        FrameParser& parser = m_peers[packet->peer].parser;
        for (LinkFrame& frame : m_link.isDatagram() ? parser.feedDatagram(packet->bytes)
                                                    : parser.feed(packet->bytes)) {
            if (m_options.log && m_options.logsReceived)
                m_options.log(now, frame.bytes);
            const SignatureVerdict verdict = m_checker.check(frame);
            // The local radio modem cannot sign its status.
            const bool isOfModem =
                frame.messageId == static_cast<std::uint32_t>(MessageId::RadioStatus);
            if (m_options.key && verdict != SignatureVerdict::Valid && !isOfModem) {
                ++m_unverified;
                continue;
            }
            received.push_back(
                {.peer = packet->peer, .frame = std::move(frame), .signature = verdict});
        }
    }
    return received;
}

void FrameExchange::send(int peer, const LinkMessage& message, LinkTime now)
{
    const std::vector<std::uint8_t> bytes = m_writer.write(message, now.unix_us);
    if (m_options.log)
        m_options.log(now, bytes);
    m_link.send(peer, bytes);
}

void FrameExchange::broadcast(const LinkMessage& message, LinkTime now)
{
    const std::vector<std::uint8_t> bytes = m_writer.write(message, now.unix_us);
    if (m_options.log)
        m_options.log(now, bytes);
    for (int peer : m_link.peers())
        m_link.send(peer, bytes);
}

ParserCounts FrameExchange::counts() const
{
    ParserCounts sum;
    for (const auto& [number, peer] : m_peers) {
        const ParserCounts& counts = peer.parser.counts();
        sum.frames += counts.frames;
        sum.unknown += counts.unknown;
        sum.badChecksums += counts.badChecksums;
        sum.unknownFlags += counts.unknownFlags;
        sum.noise_bytes += counts.noise_bytes;
    }
    return sum;
}

} // namespace berg
