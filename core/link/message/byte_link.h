#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/** Time of an event. The caller supplies it, so that tests and recordings can use their own. */
struct LinkTime
{
    double monotonic_s = 0;   ///< Never decreases; for timeouts.
    std::int64_t unix_us = 0; ///< Microseconds since 1970; for signatures and logs.
    bool operator==(const LinkTime&) const = default;
};

/** Largest number of packets processed at once, so that a flood leaves time for other work. */
inline constexpr int kPacketsAtOnce = 1000;

/** A link may give the number of a peer that has been silent for longer to another one. */
inline constexpr double kPeerKept_s = 10;

/** Bytes received over a link. */
struct LinkPacket
{
    int peer = 0; ///< The other end, as the number that the link gives to its address.
    std::vector<std::uint8_t> bytes;
};

/**
 * A channel for bytes: UDP, TCP, a serial port, or memory in tests. A link with several other ends
 * (UDP) numbers them; other links have peer 0 only. No call blocks.
 */
class ByteLink
{
public:
    virtual ~ByteLink() = default;

    /** Returns true if packets are datagrams rather than pieces of a stream. */
    [[nodiscard]] virtual bool isDatagram() const = 0;
    /** Returns the peers that can be reached now. */
    [[nodiscard]] virtual std::vector<int> peers() const = 0;
    /** Returns the next received packet, or nullopt if there is none. */
    [[nodiscard]] virtual std::optional<LinkPacket> receive() = 0;
    /** Sends bytes to a peer; they may be lost. Bytes to an unknown peer are dropped. */
    virtual void send(int peer, std::span<const std::uint8_t> bytes) = 0;
};

} // namespace berg
