#pragma once

#include "core/link/message/byte_link.h"
#include "core/link/transport/link_endpoint.h"

#include <memory>
#include <string>

namespace berg {

/** Condition of a link to the outside. */
struct LinkCondition
{
    enum class State
    {
        Opening, ///< A name is resolved or a connection is made.
        Open,
        Broken ///< The next attempt to open it follows after 2 s.
    };
    State state = State::Opening;
    /** Reason of the last failure in the system's words; empty after a success. */
    std::string fault;
    bool operator==(const LinkCondition&) const = default;
};

/**
 * A link over the network or a serial port. It opens by itself, and opens again after a failure,
 * whenever `receive` is called. It is used by one thread, which needs no event loop.
 */
class TransportLink : public ByteLink
{
public:
    [[nodiscard]] virtual LinkCondition condition() const = 0;
    /** Returns the address or device of a peer, such as "127.0.0.1:14551". */
    [[nodiscard]] virtual std::string peerName(int peer) const = 0;
    /** Returns the number of packets ignored because their sender is not accepted. */
    [[nodiscard]] virtual std::uint64_t ignored() const { return 0; }
    /** Returns the sender of the packet ignored last; empty if there was none. */
    [[nodiscard]] virtual std::string lastIgnored() const { return {}; }
};

/**
 * Makes the link to an endpoint and begins to open it.
 *
 * UDP: a datagram has at most 2048 bytes; longer ones are dropped. A listening link remembers up to
 * 32 senders as peers. A further sender takes the place of the one silent for longest, if that has
 * been silent for 10 s; else its datagrams are ignored. Datagrams go only to peers heard in the
 * last minute.
 *
 * TCP and serial port: peer 0 only. Up to 64 KiB wait to be sent; more are dropped.
 */
[[nodiscard]] std::unique_ptr<TransportLink> openLink(const LinkEndpoint& endpoint);

} // namespace berg
