#pragma once

#include "core/link/message/byte_link.h"

#include <deque>
#include <memory>
#include <vector>

namespace berg {

/**
 * Shares one link among several users, such as the vehicles of a fleet: each receives every packet
 * and sends to the same peers. Packets of a user that does not read are lost beyond 1000.
 * Single-threaded.
 */
class LinkFanOut
{
public:
    /** `link` must outlive the fan-out. */
    LinkFanOut(ByteLink& link, std::size_t users);

    /** Passes received packets to the users, which see no others. */
    void collect();
    /** Returns the link of a user; it lives as long as the fan-out. */
    [[nodiscard]] ByteLink& user(std::size_t index) { return *m_users.at(index); }

private:
    class User final : public ByteLink
    {
    public:
        explicit User(ByteLink& link) : m_link(link) {}
        [[nodiscard]] bool isDatagram() const override { return m_link.isDatagram(); }
        [[nodiscard]] std::vector<int> peers() const override { return m_link.peers(); }
        [[nodiscard]] std::optional<LinkPacket> receive() override;
        void send(int peer, std::span<const std::uint8_t> bytes) override
        {
            m_link.send(peer, bytes);
        }
        void add(const LinkPacket& packet);

    private:
        ByteLink& m_link;
        std::deque<LinkPacket> m_packets;
    };

    ByteLink& m_link;
    std::vector<std::unique_ptr<User>> m_users;
};

} // namespace berg
