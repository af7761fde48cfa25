#include "core/link/message/memory_link.h"

namespace berg {

namespace {

constexpr std::size_t kMostPacketsWaiting = 10'000; ///< A peer that does not read loses the rest.

} // namespace

std::pair<MemoryLink, MemoryLink> MemoryLink::pair()
{
    const auto there = std::make_shared<Queue>();
    const auto back = std::make_shared<Queue>();
    return {MemoryLink(back, there), MemoryLink(there, back)};
}

std::optional<LinkPacket> MemoryLink::receive()
{
    if (m_in->empty())
        return std::nullopt;
    LinkPacket packet{.peer = 0, .bytes = std::move(m_in->front())};
    m_in->pop_front();
    return packet;
}

void MemoryLink::send(int peer, std::span<const std::uint8_t> bytes)
{
    if (peer == 0 && m_out->size() < kMostPacketsWaiting)
        m_out->emplace_back(bytes.begin(), bytes.end());
}

} // namespace berg
