#pragma once

#include <string>
#include <string_view>
#include <variant>

namespace berg {

/** The end of a link, as users name it. */
struct LinkEndpoint
{
    enum class Kind
    {
        UdpListen, ///< Receives datagrams and answers to where they came from.
        UdpSend,   ///< Sends datagrams to one address and accepts only its own.
        Tcp,       ///< Connects to a server.
        Serial
    };
    Kind kind = Kind::UdpListen;
    std::string host = "127.0.0.1"; ///< IPv4 address or name; for UdpListen the address that hears.
    int port = 14550;
    std::string device; ///< Path of a serial port.
    int baud = 57600;
    bool operator==(const LinkEndpoint&) const = default;
};

/** Reason why a text is no endpoint. */
enum class EndpointFault
{
    Kind, ///< It begins with no known kind.
    Host,
    Port,
    Device,
    Baud
};

/**
 * Reads an endpoint: `udp:HOST:PORT` or `udpin:HOST:PORT` (listens), `udpout:HOST:PORT`,
 * `tcp:HOST:PORT` or `serial:DEVICE:BAUD`. The host and the number at the end may be missing: they
 * are then 127.0.0.1, 14550 (5760 for TCP) and 57600.
 */
[[nodiscard]] std::variant<LinkEndpoint, EndpointFault> readEndpoint(std::string_view text);

/**
 * Returns the English words of a fault, in which %1 stands for the text read. The command line and
 * the window look up their translation by these words (context IssueText).
 */
[[nodiscard]] std::string_view englishWords(EndpointFault fault);

/** Returns the text that `readEndpoint` reads as this endpoint. */
[[nodiscard]] std::string endpointText(const LinkEndpoint& endpoint);

/** Returns true if the link cannot leave this computer, or is a serial port. */
[[nodiscard]] bool isLocal(const LinkEndpoint& endpoint);

} // namespace berg
