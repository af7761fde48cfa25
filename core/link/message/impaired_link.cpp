#include "core/link/message/impaired_link.h"

#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostPacketsDelayed = 10'000;

} // namespace

ImpairedLink::ImpairedLink(ByteLink& inner, LinkImpairment impairment)
    : m_inner(inner), m_impairment(impairment), m_random(impairment.seed)
{
}

void ImpairedLink::delay(std::deque<Waiting>& queue, LinkPacket packet)
{
    const bool isLost = m_random.uniform() < m_impairment.loss;
    if (!isLost && queue.size() < kMostPacketsDelayed)
        queue.push_back({.due_s = m_now_s + m_impairment.delay_s, .packet = std::move(packet)});
}

void ImpairedLink::setTime(double now_s)
{
    m_now_s = now_s;
    while (!m_outgoing.empty() && m_outgoing.front().due_s <= m_now_s) {
        m_inner.send(m_outgoing.front().packet.peer, m_outgoing.front().packet.bytes);
        m_outgoing.pop_front();
    }
    for (int i = 0; i < kPacketsAtOnce; ++i) {
        std::optional<LinkPacket> packet = m_inner.receive();
        if (!packet)
            return;
        delay(m_incoming, std::move(*packet));
    }
}

std::optional<LinkPacket> ImpairedLink::receive()
{
    if (m_incoming.empty() || m_incoming.front().due_s > m_now_s)
        return std::nullopt;
    LinkPacket packet = std::move(m_incoming.front().packet);
    m_incoming.pop_front();
    return packet;
}

void ImpairedLink::send(int peer, std::span<const std::uint8_t> bytes)
{
    delay(m_outgoing, {.peer = peer, .bytes = {bytes.begin(), bytes.end()}});
}

} // namespace berg
