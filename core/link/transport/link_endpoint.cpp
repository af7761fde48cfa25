#include "core/link/transport/link_endpoint.h"

#include "core/base/translate_noop.h"
#include "core/link/transport/host_lookup.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace berg {

namespace {

constexpr std::array<std::string_view, 5> kEndpointFaults{
    QT_TRANSLATE_NOOP("IssueText",
                      "%1 is no link: write udp:HOST:PORT to listen, udpout:HOST:PORT, "
                      "tcp:HOST:PORT or serial:DEVICE:BAUD"),
    QT_TRANSLATE_NOOP("IssueText", "%1 has no host: write an IPv4 address or a name"),
    QT_TRANSLATE_NOOP("IssueText", "%1 has no port from 1 to 65535"),
    QT_TRANSLATE_NOOP("IssueText", "%1 has no device: write a path such as /dev/ttyUSB0"),
    QT_TRANSLATE_NOOP("IssueText", "%1 has no baud rate of a serial port, such as 57600 or 115200"),
};

struct KindRow
{
    std::string_view name;
    LinkEndpoint::Kind kind;
};

/** The first name of a kind is the one written. */
constexpr std::array<KindRow, 5> kKindRows{{
    {"udp", LinkEndpoint::Kind::UdpListen},
    {"udpin", LinkEndpoint::Kind::UdpListen},
    {"udpout", LinkEndpoint::Kind::UdpSend},
    {"tcp", LinkEndpoint::Kind::Tcp},
    {"serial", LinkEndpoint::Kind::Serial},
}};

constexpr std::array kBaudRates{4800,   9600,   19200,  38400,  57600,  115200,
                                230400, 460800, 500000, 921600, 1000000};
constexpr int kTcpPort = 5760;
constexpr std::size_t kLongestHost = 253; ///< This is the limit of DNS.

/** Returns the number if the text consists of digits only. */
std::optional<int> wholeNumber(std::string_view text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isNumber = error == std::errc() && end == text.data() + text.size() && value >= 0;
    return isNumber ? std::optional(value) : std::nullopt;
}

bool isHostName(std::string_view text)
{
    return !text.empty() && text.size() <= kLongestHost &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '.';
           });
}

std::variant<LinkEndpoint, EndpointFault> readSerial(std::string_view rest)
{
    LinkEndpoint endpoint{.kind = LinkEndpoint::Kind::Serial};
    // Paths of ports may contain colons, such as those in /dev/serial/by-path.
    if (const std::size_t colon = rest.rfind(':'); colon != std::string_view::npos) {
        const std::optional<int> baud = wholeNumber(rest.substr(colon + 1));
        if (!baud || std::find(kBaudRates.begin(), kBaudRates.end(), *baud) == kBaudRates.end())
            return EndpointFault::Baud;
        endpoint.baud = *baud;
        rest = rest.substr(0, colon);
    }
    if (!rest.starts_with('/') || rest.find('\0') != std::string_view::npos)
        return EndpointFault::Device;
    endpoint.device = rest;
    return endpoint;
}

} // namespace

std::variant<LinkEndpoint, EndpointFault> readEndpoint(std::string_view text)
{
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto row = std::find_if(kKindRows.begin(), kKindRows.end(), [&](const KindRow& each) {
        return each.name == text.substr(0, colon);
    });
    if (row == kKindRows.end())
        return EndpointFault::Kind;
    std::string_view rest = text.substr(std::min(colon + 1, text.size()));
    if (row->kind == LinkEndpoint::Kind::Serial)
        return readSerial(rest);

    LinkEndpoint endpoint{.kind = row->kind};
    if (row->kind == LinkEndpoint::Kind::Tcp)
        endpoint.port = kTcpPort;
    const std::size_t last = rest.rfind(':');
    const std::string_view end = last == std::string_view::npos ? rest : rest.substr(last + 1);
    const std::optional<int> port = wholeNumber(end);
    if (port || last != std::string_view::npos) {
        if (!port || *port < 1 || *port > 65535)
            return EndpointFault::Port;
        endpoint.port = *port;
        rest = rest.substr(0, last == std::string_view::npos ? 0 : last);
        if (rest.empty() && last != std::string_view::npos)
            return EndpointFault::Host;
    }
    if (!rest.empty()) {
        if (!isHostName(rest))
            return EndpointFault::Host;
        endpoint.host = rest;
    }
    return endpoint;
}

std::string_view englishWords(EndpointFault fault)
{
    return kEndpointFaults.at(static_cast<std::size_t>(fault));
}

std::string endpointText(const LinkEndpoint& endpoint)
{
    const auto row = std::find_if(kKindRows.begin(), kKindRows.end(),
                                  [&](const KindRow& each) { return each.kind == endpoint.kind; });
    const std::string kind(row->name);
    if (endpoint.kind == LinkEndpoint::Kind::Serial)
        return kind + ':' + endpoint.device + ':' + std::to_string(endpoint.baud);
    return kind + ':' + endpoint.host + ':' + std::to_string(endpoint.port);
}

bool isLocal(const LinkEndpoint& endpoint)
{
    constexpr unsigned kLoopback = 127; // first number of the addresses of this computer
    const std::optional<sockaddr_in> address = numericAddress(endpoint.host, 0);
    return endpoint.kind == LinkEndpoint::Kind::Serial ||
           (address && ntohl(address->sin_addr.s_addr) >> 24U == kLoopback);
}

} // namespace berg
