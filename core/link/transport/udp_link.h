#pragma once

// This header is private to core/link; `openLink` makes the link.

#include "core/base/descriptor.h"
#include "core/link/transport/host_lookup.h"
#include "core/link/transport/transport_link.h"

#include <array>
#include <optional>
#include <vector>

namespace berg {

/** Datagrams over IPv4; see `openLink`. */
class UdpLink final : public TransportLink
{
public:
    explicit UdpLink(const LinkEndpoint& endpoint) : m_endpoint(endpoint), m_lookup(endpoint) {}

    [[nodiscard]] bool isDatagram() const override { return true; }
    [[nodiscard]] std::vector<int> peers() const override;
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int peer, std::span<const std::uint8_t> bytes) override;

    [[nodiscard]] LinkCondition condition() const override { return m_condition; }
    [[nodiscard]] std::string peerName(int peer) const override;
    [[nodiscard]] std::uint64_t ignored() const override { return m_ignored; }
    [[nodiscard]] std::string lastIgnored() const override { return m_lastIgnored; }

private:
    struct Peer
    {
        sockaddr_in address{};
        double heard_s = 0;
    };

    /** Returns true if datagrams may go to the peer. */
    [[nodiscard]] bool isReached(const Peer& peer) const;
    void open();
    void breakDown(const std::string& fault);
    /** Returns the number of the sender, or nullopt if it is not accepted. */
    [[nodiscard]] std::optional<int> numberOf(const sockaddr_in& sender);

    LinkEndpoint m_endpoint;
    HostLookup m_lookup;
    std::optional<Descriptor> m_socket;
    LinkCondition m_condition;
    double m_retry_s = 0;
    std::vector<Peer> m_peers; ///< By number.
    std::uint64_t m_ignored = 0;
    std::string m_lastIgnored;
};

} // namespace berg
