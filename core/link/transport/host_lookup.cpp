#include "core/link/transport/host_lookup.h"

#include <arpa/inet.h>
#include <array>
#include <cstring>
#include <netdb.h>
#include <thread>
#include <utility>

namespace berg {

std::optional<sockaddr_in> numericAddress(const std::string& host, in_port_t port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = port;
    const char* const text = host == "localhost" ? "127.0.0.1" : host.c_str();
    return inet_pton(AF_INET, text, &address.sin_addr) == 1 ? std::optional(address) : std::nullopt;
}

HostLookup::HostLookup(const LinkEndpoint& endpoint) : m_result(std::make_shared<Result>())
{
    const in_port_t port = htons(static_cast<std::uint16_t>(endpoint.port));
    m_result->address = numericAddress(endpoint.host, port);
    m_result->isDone = m_result->address.has_value();
    if (m_result->isDone)
        return;
    // The thread is detached because the resolver cannot be interrupted.
    std::thread([result = m_result, host = endpoint.host, port] {
        addrinfo hints{};
        hints.ai_family = AF_INET;
        addrinfo* found = nullptr;
        const int error = getaddrinfo(host.c_str(), nullptr, &hints, &found);
        const std::scoped_lock lock(result->mutex);
        if (error != 0) {
            result->fault = gai_strerror(error);
        } else {
            sockaddr_in address{};
            std::memcpy(&address, found->ai_addr, sizeof address);
            address.sin_port = port;
            result->address = address;
            freeaddrinfo(found);
        }
        result->isDone = true;
    }).detach();
}

bool HostLookup::isDone() const
{
    const std::scoped_lock lock(m_result->mutex);
    return m_result->isDone;
}

std::optional<sockaddr_in> HostLookup::address() const
{
    const std::scoped_lock lock(m_result->mutex);
    return m_result->address;
}

std::string HostLookup::fault() const
{
    const std::scoped_lock lock(m_result->mutex);
    return m_result->fault;
}

std::string addressText(const sockaddr_in& address)
{
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
    return std::string(text.data()) + ':' + std::to_string(ntohs(address.sin_port));
}

} // namespace berg
