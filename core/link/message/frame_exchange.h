#pragma once

#include "core/link/message/byte_link.h"
#include "core/link/message/frame_signing.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Limits on data from one peer; data beyond them are dropped and counted. */
struct ReceiveLimits
{
    double rate_bps = 200'000; ///< Bytes per second, ten times a fast radio.
    double burst_bytes = 400'000;
    std::size_t mostPeers = 32; ///< Packets of further peers are dropped.
};

/** A received frame with its peer and the verdict on its signature. */
struct ReceivedFrame
{
    int peer = 0;
    LinkFrame frame;
    SignatureVerdict signature = SignatureVerdict::Unsigned;
};

/** Receives every frame sent or received, for example for a log. */
using FrameLog = std::function<void(LinkTime, std::span<const std::uint8_t>)>;

/** Identity, key and limits of an exchange. */
struct FrameExchangeOptions
{
    LinkAddress self;
    /** With a key, frames without a valid signature are dropped, except RADIO_STATUS. */
    std::optional<SigningKey> key;
    ReceiveLimits limits;
    FrameLog log;             ///< May be empty.
    bool logsReceived = true; ///< False if another exchange on the same link logs these frames.
};

/**
 * Exchanges frames over a byte link. It finds the frames of each peer, checks signatures, enforces
 * limits and logs; frames to send are numbered and signed. The ground station and the vehicle both
 * build on it. Single-threaded.
 */
class FrameExchange
{
public:
    /** `link` must outlive the exchange. */
    FrameExchange(ByteLink& link, FrameExchangeOptions options);

    /**
     * Returns the frames received since the last call, without those dropped for the limits or for
     * their signature. At most 1000 packets are processed; the others follow in the next call.
     */
    [[nodiscard]] std::vector<ReceivedFrame> receive(LinkTime now);
    /** Sends a message to one peer. */
    void send(int peer, const LinkMessage& message, LinkTime now);
    /** Sends a message to every peer that can be reached. */
    void broadcast(const LinkMessage& message, LinkTime now);

    /** Returns true if a peer can be reached. */
    [[nodiscard]] bool hasPeers() const { return !m_link.peers().empty(); }
    [[nodiscard]] LinkAddress self() const { return m_options.self; }
    /** Returns the number of bytes dropped because a peer sent too much or was one too many. */
    [[nodiscard]] std::uint64_t dropped_bytes() const { return m_dropped_bytes; }
    /** Returns the number of frames dropped because of an invalid or missing signature. */
    [[nodiscard]] std::uint64_t unverified() const { return m_unverified; }
    /** Returns the sum of the counts of all peers' parsers. */
    [[nodiscard]] ParserCounts counts() const;

private:
    struct Peer
    {
        FrameParser parser;
        double allowance_bytes = 0;
        double updated_s = 0;
    };

    [[nodiscard]] bool isWithinLimits(const LinkPacket& packet, double now_s);

    ByteLink& m_link;
    FrameExchangeOptions m_options;
    FrameWriter m_writer;
    SignatureChecker m_checker;
    std::map<int, Peer> m_peers;
    std::uint64_t m_dropped_bytes = 0;
    std::uint64_t m_unverified = 0;
};

} // namespace berg
