#pragma once

#include "core/link/message/byte_link.h"

#include <deque>
#include <memory>
#include <utility>

namespace berg {

/**
 * One end of a link inside the program; created in pairs. At most 10,000 packets wait for each end;
 * more are lost. Single-threaded.
 */
class MemoryLink final : public ByteLink
{
public:
    /** Returns two ends: each receives the packets that the other sends. */
    [[nodiscard]] static std::pair<MemoryLink, MemoryLink> pair();

    [[nodiscard]] bool isDatagram() const override { return true; }
    [[nodiscard]] std::vector<int> peers() const override { return {0}; }
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int peer, std::span<const std::uint8_t> bytes) override;

private:
    using Queue = std::deque<std::vector<std::uint8_t>>;

    MemoryLink(std::shared_ptr<Queue> in, std::shared_ptr<Queue> out)
        : m_in(std::move(in)), m_out(std::move(out))
    {
    }

    std::shared_ptr<Queue> m_in; ///< Shared with the other end, which may be destroyed first.
    std::shared_ptr<Queue> m_out;
};

} // namespace berg
