#include "core/link/transport/transport_link.h"

#include "core/link/transport/stream_link.h"
#include "core/link/transport/udp_link.h"

namespace berg {

std::unique_ptr<TransportLink> openLink(const LinkEndpoint& endpoint)
{
    if (endpoint.kind == LinkEndpoint::Kind::Tcp || endpoint.kind == LinkEndpoint::Kind::Serial)
        return std::make_unique<StreamLink>(endpoint);
    return std::make_unique<UdpLink>(endpoint);
}

} // namespace berg
