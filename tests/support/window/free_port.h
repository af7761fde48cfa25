#pragma once

#include <QtGlobal>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace berg::test {

/** Returns a UDP port of this computer that no socket uses now. */
inline int freeUdpPort()
{
    const int handle = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const raw = reinterpret_cast<sockaddr*>(&address);
    if (bind(handle, raw, size) != 0 || getsockname(handle, raw, &size) != 0)
        qFatal("no free port");
    close(handle);
    return ntohs(address.sin_port);
}

} // namespace berg::test
