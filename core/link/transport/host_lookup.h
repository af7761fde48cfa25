#pragma once

// This header is private to core/link.

#include "core/link/transport/link_endpoint.h"

#include <memory>
#include <mutex>
#include <netinet/in.h>
#include <optional>
#include <string>

namespace berg {

/** Finds the IPv4 address of a host without blocking: names are resolved by another thread. */
class HostLookup
{
public:
    /** Begins to look up host and port of `endpoint`. */
    explicit HostLookup(const LinkEndpoint& endpoint);

    /** Returns true if there is a result. */
    [[nodiscard]] bool isDone() const;
    /** Returns the address, or nullopt after a failure; only once `isDone`. */
    [[nodiscard]] std::optional<sockaddr_in> address() const;
    /** Returns the reason of a failure in the system's words; only once `isDone`. */
    [[nodiscard]] std::string fault() const;

private:
    struct Result
    {
        std::mutex mutex;
        bool isDone = false;
        std::optional<sockaddr_in> address;
        std::string fault;
    };

    std::shared_ptr<Result> m_result; ///< Shared with the thread, which may live longer.
};

/**
 * Returns the IPv4 address that the text is, with "localhost" as 127.0.0.1, or nullopt for a name;
 * `port` is in network order.
 */
[[nodiscard]] std::optional<sockaddr_in> numericAddress(const std::string& host, in_port_t port);

/** Returns an address as "127.0.0.1:14550". */
[[nodiscard]] std::string addressText(const sockaddr_in& address);

} // namespace berg
