#pragma once

#include "core/link/link_session.h"
#include "core/link/nmea/nmea_reader.h"

#include <map>
#include <vector>

namespace berg {

/** System of the address of a tracker; ids on a MAVLink link begin with 1. */
inline constexpr std::uint8_t kTrackerSystem = 0;

/** Returns true for the address of an NMEA tracker in a `TrackerList`. */
[[nodiscard]] constexpr bool isTracker(LinkAddress address)
{
    return address.system == kTrackerSystem;
}

/** A fix with the peer of the link that sent it. */
struct TrackerFix
{
    int peer = 0;
    NmeaFix fix;
};

/** Passes a link on and reads the NMEA sentences in it. Memory: a reader for each of 64 peers. */
class TrackerLink final : public ByteLink
{
public:
    /** `link` must outlive it. */
    explicit TrackerLink(ByteLink& link) : m_link(link) {}

    [[nodiscard]] bool isDatagram() const override { return m_link.isDatagram(); }
    [[nodiscard]] std::vector<int> peers() const override { return m_link.peers(); }
    [[nodiscard]] std::optional<LinkPacket> receive() override;
    void send(int peer, std::span<const std::uint8_t> bytes) override { m_link.send(peer, bytes); }

    /** Returns the fixes since the last call, at most 1000; further ones are dropped. */
    [[nodiscard]] std::vector<TrackerFix> takeFixes();
    /**
     * Returns what the peers' radars and AIS receivers have reported since the last call, at most
     * 1000 targets; further ones are dropped. Bearings are placed by fixes of the same peer.
     */
    [[nodiscard]] std::vector<NmeaTarget> takeTargets();

private:
    ByteLink& m_link;
    std::map<int, NmeaReader> m_readers;
    std::vector<TrackerFix> m_fixes;
    std::vector<NmeaTarget> m_targets;
};

/**
 * Trackers that report their position by NMEA 0183, as vehicles that can only be listened to: each
 * peer of the link is one. Their address has the system `kTrackerSystem` and a number from 1. A
 * speed that a tracker does not send is derived from its positions. At most 32 are followed; a
 * further one takes the place of the one that has been silent for longest, if that is lost.
 */
class TrackerList
{
public:
    /** Processes a position received at `now_s` of the receiver's clock. */
    void receive(const TrackerFix& received, double now_s);
    /**
     * Marks trackers that have been silent for 5 s as lost, and returns the events since the last
     * call: appeared, lost, returned.
     */
    [[nodiscard]] std::vector<LinkEvent> advance(double now_s);
    /** Returns the trackers in the order of their addresses. */
    [[nodiscard]] std::vector<LinkVehicle> vehicles() const;

private:
    struct Tracker
    {
        LinkVehicle vehicle;
        double velocity_s = -1; ///< When its speed was received last; negative for never.
        /** Position from which the speed is derived. */
        std::optional<AircraftPosition> from;
    };

    [[nodiscard]] Tracker* trackerOf(int peer, double now_s);

    std::vector<Tracker> m_trackers;
    std::vector<LinkEvent> m_events;
};

} // namespace berg
