#pragma once

#include "core/sim/rehearsal_vehicle.h"
#include "tests/support/flight/link_scene.h"
#include "widgets/aircraft/link_worker.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace berg::test {

/** A link inside the program in place of one to the outside. */
class InnerTransport final : public TransportLink
{
public:
    explicit InnerTransport(ByteLink& inner) : m_inner(inner) {}

    [[nodiscard]] bool isDatagram() const override { return m_inner.isDatagram(); }
    [[nodiscard]] std::vector<int> peers() const override { return m_inner.peers(); }
    [[nodiscard]] std::optional<LinkPacket> receive() override { return m_inner.receive(); }
    void send(int peer, std::span<const std::uint8_t> bytes) override { m_inner.send(peer, bytes); }
    [[nodiscard]] LinkCondition condition() const override
    {
        return {.state = LinkCondition::State::Open};
    }
    [[nodiscard]] std::string peerName(int peer) const override { return std::to_string(peer); }

private:
    ByteLink& m_inner;
};

/** The window's ends of the links to several aircraft as one link, each a peer. */
class FanLink final : public ByteLink
{
public:
    void add(ByteLink& link) { m_links.push_back(&link); }

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
            if (std::optional<LinkPacket> packet = m_links[i]->receive()) {
                packet->peer = static_cast<int>(i);
                return packet;
            }
        return std::nullopt;
    }
    void send(int peer, std::span<const std::uint8_t> bytes) override
    {
        m_links.at(static_cast<std::size_t>(peer))->send(0, bytes);
    }

private:
    std::vector<ByteLink*> m_links;
};

/** An end that counts what its owner receives. */
class CountingLink final : public ByteLink
{
public:
    explicit CountingLink(ByteLink& inner) : m_inner(inner) {}
    [[nodiscard]] int received() const { return m_received; }

    [[nodiscard]] bool isDatagram() const override { return m_inner.isDatagram(); }
    [[nodiscard]] std::vector<int> peers() const override { return m_inner.peers(); }
    [[nodiscard]] std::optional<LinkPacket> receive() override
    {
        std::optional<LinkPacket> packet = m_inner.receive();
        m_received += packet ? 1 : 0;
        return packet;
    }
    void send(int peer, std::span<const std::uint8_t> bytes) override { m_inner.send(peer, bytes); }

private:
    ByteLink& m_inner;
    int m_received = 0;
};

/**
 * The window's session as it runs on the link thread, with simulated aircraft whose system ids
 * begin with 1. Time passes in steps of 50 ms and stands still in between.
 */
struct LinkWorkerScene
{
    /** One aircraft. Its first peer is the window; tests may add other ground stations. */
    struct Aircraft
    {
        Aircraft(const RehearsalOptions& options, const LinkImpairment& impairment)
            : window(stations.addPeer())
            , radio(*window, impairment)
            , filter(stations)
            , link(filter)
            , vehicle(link, options)
        {
        }
        HubLink stations;
        std::unique_ptr<MemoryLink> window;
        ImpairedLink radio;  ///< to the window
        FilteredLink filter; ///< messages of the aircraft
        CountingLink link;
        RehearsalVehicle vehicle;
    };

    explicit LinkWorkerScene(const std::vector<AutopilotKind>& kinds,
                             LinkImpairment impairment = {})
        : sent(fan), worker(statuses, [this] { return linkTime(time_s); })
    {
        for (const AutopilotKind kind : kinds) {
            RehearsalOptions options{.home = {.latitude_deg = 47, .longitude_deg = -48}};
            options.side.self.system = static_cast<std::uint8_t>(aircraft.size() + 1);
            options.side.autopilot = kind;
            ++impairment.seed;
            aircraft.push_back(std::make_unique<Aircraft>(options, impairment));
            fan.add(aircraft.back()->radio);
        }
        worker.open([this] { return std::make_unique<InnerTransport>(sent); });
    }

    void step()
    {
        time_s += 0.05;
        const LinkTime now = linkTime(time_s);
        if (eachStep)
            eachStep();
        for (const auto& each : aircraft) {
            each->vehicle.advance(now);
            each->radio.setTime(time_s);
        }
        if (isWindowAlive)
            worker.pulse();
        worker.advance();
        for (const auto& each : aircraft)
            each->radio.setTime(time_s);
        if (std::optional<LinkStatus> next = statuses.take()) {
            status = std::move(*next);
            for (const TimedLinkEvent& each : status.events)
                events.push_back(each.event);
        }
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

    [[nodiscard]] static LinkAddress address(std::size_t i)
    {
        return {.system = static_cast<std::uint8_t>(i + 1), .component = 1};
    }

    [[nodiscard]] const LinkVehicle* vehicle(std::size_t i = 0) const
    {
        for (const LinkVehicle& each : status.vehicles)
            if (each.address == address(i))
                return &each;
        return nullptr;
    }

    [[nodiscard]] int count(LinkEvent::Kind kind, std::size_t i = 0) const
    {
        int found = 0;
        for (const LinkEvent& event : events)
            found += event.kind == kind && event.vehicle == address(i) ? 1 : 0;
        return found;
    }

    /** Switches sending on and waits for the positions of all aircraft. */
    bool meet()
    {
        worker.setSending(true);
        return runUntil(
            [&] {
                for (std::size_t i = 0; i < aircraft.size(); ++i)
                    if (vehicle(i) == nullptr || !vehicle(i)->state.position)
                        return false;
                return true;
            },
            60);
    }

    /** Uploads and compares; returns how it has ended. */
    SyncStatus sync(const std::vector<MissionPart>& parts,
                    MissionSync::Task task = MissionSync::Task::UploadAndCompare)
    {
        const int before = count(LinkEvent::Kind::SyncEnded);
        worker.startSync(address(0), parts, task);
        if (!runUntil([&] { return count(LinkEvent::Kind::SyncEnded) > before; }, 600))
            return {.phase = SyncPhase::Failed};
        return vehicle()->sync.value_or(SyncStatus{});
    }

    /** Returns the items that the aircraft has, as they are in the plan. */
    [[nodiscard]] std::vector<LinkMissionItem> onBoard(MissionType type, std::size_t i = 0) const
    {
        return aircraft[i]->vehicle.side().missions().items(type);
    }

    double time_s = 0;
    bool isWindowAlive = true;
    std::vector<std::unique_ptr<Aircraft>> aircraft;
    FanLink fan;
    FilteredLink sent; ///< messages of the window
    Mailbox<LinkStatus> statuses;
    LinkWorker worker;
    LinkStatus status; ///< the newest one
    std::vector<LinkEvent> events;
    std::function<void()> eachStep; ///< may be empty
};

} // namespace berg::test
