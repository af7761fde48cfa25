#pragma once

#include "core/base/random.h"
#include "core/link/message/byte_link.h"

#include <cstdint>
#include <deque>

namespace berg {

/** Effect of a bad radio on packets, in each direction. */
struct LinkImpairment
{
    double loss = 0; ///< Share of lost packets, 0 to 1.
    double delay_s = 0;
    std::uint64_t seed = 1; ///< Names the random stream that selects the losses.
};

/**
 * A link with impairments: packets in both directions are lost at random and arrive later, in
 * order. At most 10,000 packets wait in each direction; more are lost. Single-threaded; the caller
 * supplies the time.
 */
class ImpairedLink final : public ByteLink
{
public:
    /** `inner` must outlive this link. */
    ImpairedLink(ByteLink& inner, LinkImpairment impairment);

    /**
     * Advances the clock, sends the packets due and collects the packets that the inner link has
     * received; `receive` returns only packets collected here.
     */
    void setTime(double now_s);
    /** Sets loss and delay of packets from now on, not the seed; a loss of 1 cuts the link. */
    void setImpairment(LinkImpairment impairment) { m_impairment = impairment; }

    [[nodiscard]] bool isDatagram() const override { return m_inner.isDatagram(); }
    [[nodiscard]] std::vector<int> peers() const override { return m_inner.peers(); }
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int peer, std::span<const std::uint8_t> bytes) override;

private:
    struct Waiting
    {
        double due_s = 0;
        LinkPacket packet;
    };

    /** Queues a packet, unless it is lost. */
    void delay(std::deque<Waiting>& queue, LinkPacket packet);

    ByteLink& m_inner;
    LinkImpairment m_impairment;
    Random m_random;
    double m_now_s = 0;
    std::deque<Waiting> m_incoming;
    std::deque<Waiting> m_outgoing;
};

} // namespace berg
