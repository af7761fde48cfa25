#pragma once

#include "core/link/link_session.h"
#include "core/link/message/impaired_link.h"
#include "core/link/message/memory_link.h"
#include "core/link/vehicle/vehicle_side.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace berg::test {

/** A link that drops messages chosen by the test, in the direction of the inner link. */
class FilteredLink final : public ByteLink
{
public:
    using Filter = std::function<bool(const LinkMessage&)>; ///< returns true to pass the message on

    explicit FilteredLink(ByteLink& inner) : m_inner(inner) {}
    void setFilter(Filter filter) { m_filter = std::move(filter); }
    [[nodiscard]] int sent() const { return m_sent; }

    [[nodiscard]] bool isDatagram() const override { return m_inner.isDatagram(); }
    [[nodiscard]] std::vector<int> peers() const override { return m_inner.peers(); }
    [[nodiscard]] std::optional<LinkPacket> receive() override { return m_inner.receive(); }
    void send(int peer, std::span<const std::uint8_t> bytes) override
    {
        ++m_sent;
        FrameParser parser;
        for (const LinkFrame& frame : parser.feedDatagram(bytes))
            if (!m_filter || !frame.message || m_filter(*frame.message))
                m_inner.send(peer, bytes);
    }

private:
    ByteLink& m_inner;
    Filter m_filter;
    int m_sent = 0;
};

/** Several links as one, each a peer: a vehicle with several ground stations, or the reverse. */
class HubLink final : public ByteLink
{
public:
    /** Adds a peer and returns its end. */
    [[nodiscard]] std::unique_ptr<MemoryLink> addPeer()
    {
        auto [near, far] = MemoryLink::pair();
        m_links.push_back(std::move(near));
        return std::make_unique<MemoryLink>(std::move(far));
    }

    [[nodiscard]] bool isDatagram() const override { return true; }
    [[nodiscard]] std::vector<int> peers() const override
    {
        std::vector<int> all;
        for (std::size_t i = 0; i < m_links.size(); ++i)
            all.push_back(static_cast<int>(i));
        return all;
    }
    [[nodiscard]] std::optional<LinkPacket> receive() override
    {
        for (std::size_t i = 0; i < m_links.size(); ++i)
            if (std::optional<LinkPacket> packet = m_links[i].receive()) {
                packet->peer = static_cast<int>(i);
                return packet;
            }
        return std::nullopt;
    }
    void send(int peer, std::span<const std::uint8_t> bytes) override
    {
        m_links.at(static_cast<std::size_t>(peer)).send(0, bytes);
    }

private:
    std::vector<MemoryLink> m_links;
};

inline LinkTime linkTime(double time_s)
{
    return {.monotonic_s = time_s, .unix_us = 1'790'000'000'000'000 + std::llround(1e6 * time_s)};
}

/** Readings of a fixed wing in the air near the Grand Banks. */
inline VehicleReadings flyingReadings()
{
    return {.place = {.latitude_deg = 47.0053, .longitude_deg = -47.9912},
            .altitude_m = 121.5,
            .home = {.latitude_deg = 47, .longitude_deg = -48},
            .homeAltitude_m = 1.5,
            .north_mps = 16,
            .east_mps = -15,
            .heading_rad = 5.5,
            .airspeed_mps = 22,
            .windNorth_mps = 3,
            .windEast_mps = -4,
            .battery = 0.72,
            .current_a = 12.5,
            .timeRemaining_s = 3600,
            .mode = 10,
            .isArmed = true,
            .isFlying = true,
            .item = 1};
}

/** A ground station and a vehicle over a link that may be bad; time passes in steps of 50 ms. */
struct LinkScene
{
    explicit LinkScene(AutopilotKind kind, LinkImpairment impairment = {})
        : station(hub.addPeer())
        , impaired(*station, impairment)
        , filtered(impaired)
        , session(filtered, {})
        , vehicleFilter(hub)
        , vehicle(vehicleFilter, {.autopilot = kind})
    {
    }

    /** Lets time pass until `isDone` or for `most_s`; returns whether it was done. */
    bool runUntil(const std::function<bool()>& isDone, double most_s)
    {
        for (const double end_s = time_s + most_s; time_s < end_s;) {
            step();
            if (isDone())
                return true;
        }
        return false;
    }

    void run(double duration_s)
    {
        runUntil([] { return false; }, duration_s);
    }

    void step()
    {
        time_s += 0.05;
        const LinkTime now = linkTime(time_s);
        if (eachStep)
            eachStep();
        for (const VehicleOrder& order : vehicle.advance(now, readings))
            orders.push_back(order);
        impaired.setTime(time_s);
        LinkUpdate news = session.advance(now);
        events.insert(events.end(), news.events.begin(), news.events.end());
        impaired.setTime(time_s);
    }

    [[nodiscard]] int count(LinkEvent::Kind kind) const
    {
        int found = 0;
        for (const LinkEvent& event : events)
            found += event.kind == kind ? 1 : 0;
        return found;
    }

    /** Switches sending on and waits for the vehicle. */
    bool meet()
    {
        session.setSending(true);
        return runUntil([&] { return session.findVehicle(address) != nullptr; }, 30);
    }

    /** Uploads and compares; returns how it has ended. */
    SyncStatus sync(std::vector<MissionPart> parts,
                    MissionSync::Task task = MissionSync::Task::UploadAndCompare)
    {
        if (!session.startSync(address, std::move(parts), task))
            return {.phase = SyncPhase::Failed};
        const int before = count(LinkEvent::Kind::SyncEnded);
        runUntil([&] { return count(LinkEvent::Kind::SyncEnded) > before; }, 600);
        return session.findVehicle(address)->sync.value_or(SyncStatus{});
    }

    static constexpr LinkAddress address{.system = 1, .component = 1};
    double time_s = 0;
    VehicleReadings readings = flyingReadings();
    HubLink hub;
    std::unique_ptr<MemoryLink> station;
    ImpairedLink impaired;
    FilteredLink filtered; ///< messages of the ground station
    LinkSession session;
    FilteredLink vehicleFilter; ///< messages of the vehicle
    VehicleSide vehicle;
    std::vector<VehicleOrder> orders;
    std::vector<LinkEvent> events;
    std::function<void()> eachStep; ///< may be empty
};

/** A mission of `count` items with a jump and a change of speed. */
inline std::vector<LinkMissionItem> someMission(int count, int shift = 0)
{
    std::vector<LinkMissionItem> items;
    for (int i = 0; i < count; ++i)
        items.push_back({.params = {0, 25, 0, std::nanf("")},
                         .x = 470'000'000 + 1000 * (i + shift),
                         .y = -480'000'000 + 700 * i,
                         .z = 120});
    if (count > 3) {
        items[1] = {.command = LinkCommandId::kChangeSpeed,
                    .frame = static_cast<std::uint8_t>(ItemFrame::NoPosition),
                    .params = {0, 22, -1, 0}};
        items.back() = {.command = LinkCommandId::kJump,
                        .frame = static_cast<std::uint8_t>(ItemFrame::NoPosition),
                        .params = {2, 3, 0, 0}};
    }
    return items;
}

/** A fence of a polygon and a circle. */
inline std::vector<LinkMissionItem> someFence()
{
    std::vector<LinkMissionItem> items;
    for (int i = 0; i < 4; ++i)
        items.push_back({.command = 5001,
                         .frame = 0,
                         .params = {4, 0, 0, 0},
                         .x = 470'000'000 + 100'000 * (i / 2),
                         .y = -480'000'000 + 100'000 * ((i + 1) / 2 % 2)});
    items.push_back({.command = 5004,
                     .frame = 0,
                     .params = {250, 0, 0, 0},
                     .x = 470'050'000,
                     .y = -479'950'000});
    return items;
}

inline std::vector<LinkMissionItem> someRally()
{
    return {
        {.command = 5100, .params = {0, 0, 0, 0}, .x = 470'010'000, .y = -479'990'000, .z = 100}};
}

} // namespace berg::test
