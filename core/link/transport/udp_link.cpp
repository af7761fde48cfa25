#include "core/link/transport/udp_link.h"

#include "core/link/transport/link_clock.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <system_error>

namespace berg {

namespace {

constexpr std::size_t kLongestDatagram = 2048;
constexpr std::size_t kMostPeers = 32;
constexpr double kPeerReached_s = 60;

bool isSame(const sockaddr_in& a, const sockaddr_in& b)
{
    return a.sin_addr.s_addr == b.sin_addr.s_addr && a.sin_port == b.sin_port;
}

/** Returns the address as the functions of sockets take it. */
const sockaddr* generic(const sockaddr_in& address)
{
    return reinterpret_cast<const sockaddr*>(&address);
}

} // namespace

void UdpLink::breakDown(const std::string& fault)
{
    m_socket.reset();
    m_condition = {.state = LinkCondition::State::Broken, .fault = fault};
    m_retry_s = monotonicNow_s() + kReopen_s;
    m_lookup = HostLookup(m_endpoint);
}

void UdpLink::open()
{
    if (m_socket || monotonicNow_s() < m_retry_s)
        return;
    if (!m_lookup.isDone()) {
        m_condition.state = LinkCondition::State::Opening;
        return;
    }
    const std::optional<sockaddr_in> address = m_lookup.address();
    if (!address) {
        breakDown(m_lookup.fault());
        return;
    }
    m_socket.emplace(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    const bool isListening = m_endpoint.kind == LinkEndpoint::Kind::UdpListen;
    if (!m_socket->isOpen() ||
        (isListening && ::bind(m_socket->get(), generic(*address), sizeof *address) != 0)) {
        breakDown(std::generic_category().message(errno));
        return;
    }
    if (!isListening)
        m_peers.assign(1, {.address = *address});
    m_condition = {.state = LinkCondition::State::Open};
}

std::optional<int> UdpLink::numberOf(const sockaddr_in& sender)
{
    const double now_s = monotonicNow_s();
    auto peer = std::find_if(m_peers.begin(), m_peers.end(),
                             [&](const Peer& each) { return isSame(each.address, sender); });
    if (peer == m_peers.end() && m_endpoint.kind == LinkEndpoint::Kind::UdpListen) {
        if (m_peers.size() < kMostPeers)
            peer = m_peers.insert(m_peers.end(), Peer{});
        else
            peer =
                std::min_element(m_peers.begin(), m_peers.end(), [](const Peer& a, const Peer& b) {
                    return a.heard_s < b.heard_s;
                });
        if (peer->heard_s > 0 && now_s - peer->heard_s < kPeerKept_s)
            return std::nullopt;
        peer->address = sender;
    }
    if (peer == m_peers.end())
        return std::nullopt;
    peer->heard_s = now_s;
    return static_cast<int>(peer - m_peers.begin());
}

std::optional<LinkPacket> UdpLink::receive()
{
    open();
    for (int i = 0; m_socket && i < kPacketsAtOnce; ++i) { // a flood must not keep the caller here
        std::array<std::uint8_t, kLongestDatagram> buffer{};
        sockaddr_in sender{};
        socklen_t size = sizeof sender;
        const ssize_t length = ::recvfrom(m_socket->get(), buffer.data(), buffer.size(), MSG_TRUNC,
                                          reinterpret_cast<sockaddr*>(&sender), &size);
        if (length < 0) {
            // ECONNREFUSED reports that nobody listens at a peer's port yet.
            if (errno == EINTR || errno == ECONNREFUSED)
                continue;
            if (errno != EAGAIN)
                breakDown(std::generic_category().message(errno));
            return std::nullopt;
        }
        if (static_cast<std::size_t>(length) > buffer.size())
            continue;
        if (const std::optional<int> peer = numberOf(sender))
            return LinkPacket{.peer = *peer, .bytes = {buffer.begin(), buffer.begin() + length}};
        ++m_ignored;
        m_lastIgnored = addressText(sender);
    }
    return std::nullopt;
}

bool UdpLink::isReached(const Peer& peer) const
{
    return m_endpoint.kind != LinkEndpoint::Kind::UdpListen ||
           peer.heard_s >= monotonicNow_s() - kPeerReached_s;
}

std::vector<int> UdpLink::peers() const
{
    std::vector<int> reached;
    for (std::size_t i = 0; i < m_peers.size(); ++i)
        if (isReached(m_peers[i]))
            reached.push_back(static_cast<int>(i));
    return reached;
}

void UdpLink::send(int peer, std::span<const std::uint8_t> bytes)
{
    if (!m_socket || peer < 0 || static_cast<std::size_t>(peer) >= m_peers.size())
        return;
    const Peer& to = m_peers[static_cast<std::size_t>(peer)];
    if (!isReached(to))
        return;
    const sockaddr_in& address = to.address;
    // A datagram that cannot be sent is lost, as any other may be.
    (void)::sendto(m_socket->get(), bytes.data(), bytes.size(), MSG_NOSIGNAL, generic(address),
                   sizeof address);
}

std::string UdpLink::peerName(int peer) const
{
    return peer >= 0 && static_cast<std::size_t>(peer) < m_peers.size()
               ? addressText(m_peers[static_cast<std::size_t>(peer)].address)
               : std::string();
}

} // namespace berg
