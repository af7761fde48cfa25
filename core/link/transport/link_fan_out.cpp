#include "core/link/transport/link_fan_out.h"

#include <utility>

namespace berg {

LinkFanOut::LinkFanOut(ByteLink& link, std::size_t users) : m_link(link)
{
    for (std::size_t i = 0; i < users; ++i)
        m_users.push_back(std::make_unique<User>(link));
}

void LinkFanOut::collect()
{
    for (int i = 0; i < kPacketsAtOnce; ++i) {
        const std::optional<LinkPacket> packet = m_link.receive();
        if (!packet)
            return;
        for (const std::unique_ptr<User>& user : m_users)
            user->add(*packet);
    }
}

std::optional<LinkPacket> LinkFanOut::User::receive()
{
    if (m_packets.empty())
        return std::nullopt;
    LinkPacket packet = std::move(m_packets.front());
    m_packets.pop_front();
    return packet;
}

void LinkFanOut::User::add(const LinkPacket& packet)
{
    if (m_packets.size() < kPacketsAtOnce)
        m_packets.push_back(packet);
}

} // namespace berg
