#pragma once

// This header is private to core/link; `openLink` makes the link.

#include "core/base/descriptor.h"
#include "core/link/transport/host_lookup.h"
#include "core/link/transport/transport_link.h"

#include <optional>
#include <vector>

namespace berg {

/** A stream of bytes over TCP or a serial port; see `openLink`. */
class StreamLink final : public TransportLink
{
public:
    explicit StreamLink(const LinkEndpoint& endpoint);

    [[nodiscard]] bool isDatagram() const override { return false; }
    [[nodiscard]] std::vector<int> peers() const override;
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int peer, std::span<const std::uint8_t> bytes) override;

    [[nodiscard]] LinkCondition condition() const override { return m_condition; }
    [[nodiscard]] std::string peerName(int peer) const override;

private:
    [[nodiscard]] bool isOpen() const { return m_condition.state == LinkCondition::State::Open; }
    void open();
    void openSerial();
    void connectToServer();
    void finishConnection();
    void breakDown(const std::string& fault);
    /** Writes waiting bytes as far as the system accepts them. */
    void flush();

    LinkEndpoint m_endpoint;
    std::optional<HostLookup> m_lookup; ///< Nullopt for a serial port.
    std::optional<Descriptor> m_file;
    LinkCondition m_condition;
    double m_retry_s = 0;
    double m_started_s = 0;
    std::vector<std::uint8_t> m_unsent;
};

} // namespace berg
