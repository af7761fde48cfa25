#include "core/link/tracker_list.h"

#include "core/base/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berg {

namespace {

constexpr std::size_t kMostReaders = 64;
constexpr std::size_t kMostTrackers = 32;
constexpr double kTrackerLost_s = 5;    ///< Receivers report once a second.
constexpr double kVelocityKept_s = 5;   ///< A speed that was received is used for this time.
constexpr double kShortestBase_s = 0.9; ///< Between the positions from which a speed is derived.
constexpr double kLongestBase_s = 10;
constexpr double kFastest_mps = 300; ///< A larger speed is a jump of the receiver.

void setVelocity(LinkVehicle& vehicle, double north_mps, double east_mps)
{
    vehicle.state.position->north_mps = north_mps;
    vehicle.state.position->east_mps = east_mps;
    vehicle.state.groundSpeed_mps = std::hypot(north_mps, east_mps);
}

} // namespace

std::optional<LinkPacket> TrackerLink::receive()
{
    std::optional<LinkPacket> packet = m_link.receive();
    if (!packet)
        return packet;
    if (m_readers.size() >= kMostReaders && !m_readers.contains(packet->peer))
        m_readers.clear();
    NmeaReader& reader = m_readers[packet->peer];
    constexpr auto kMost = static_cast<std::size_t>(kPacketsAtOnce);
    for (NmeaFix& fix : reader.feed(packet->bytes))
        if (m_fixes.size() < kMost)
            m_fixes.push_back({.peer = packet->peer, .fix = std::move(fix)});
    static_cast<void>(reader.takeFindings());
    for (NmeaTarget& target : reader.takeTargets())
        if (m_targets.size() < kMost)
            m_targets.push_back(std::move(target));
    return packet;
}

std::vector<NmeaTarget> TrackerLink::takeTargets()
{
    return std::exchange(m_targets, {});
}

std::vector<TrackerFix> TrackerLink::takeFixes()
{
    return std::exchange(m_fixes, {});
}

TrackerList::Tracker* TrackerList::trackerOf(int peer, double now_s)
{
    const auto found =
        std::ranges::find(m_trackers, peer, [](const Tracker& each) { return each.vehicle.peer; });
    if (found != m_trackers.end())
        return &*found;
    Tracker fresh{.vehicle = {.address = {.system = kTrackerSystem}, .peer = peer}};
    fresh.vehicle.lastHeard_s = fresh.vehicle.lastHeartbeat_s = now_s;
    if (m_trackers.size() < kMostTrackers) {
        fresh.vehicle.address.component = static_cast<std::uint8_t>(m_trackers.size() + 1);
        m_events.push_back(
            {.kind = LinkEvent::Kind::VehicleAppeared, .vehicle = fresh.vehicle.address});
        return &m_trackers.emplace_back(std::move(fresh));
    }
    const auto oldest = std::ranges::min_element(
        m_trackers, {}, [](const Tracker& each) { return each.vehicle.lastHeard_s; });
    if (!oldest->vehicle.isLost)
        return nullptr;
    fresh.vehicle.address = oldest->vehicle.address;
    *oldest = std::move(fresh);
    m_events.push_back(
        {.kind = LinkEvent::Kind::VehicleAppeared, .vehicle = oldest->vehicle.address});
    return &*oldest;
}

void TrackerList::receive(const TrackerFix& received, double now_s)
{
    const NmeaFix& fix = received.fix;
    Tracker* const tracker = trackerOf(received.peer, now_s);
    if (tracker == nullptr)
        return;
    LinkVehicle& vehicle = tracker->vehicle;
    vehicle.lastHeard_s = vehicle.lastHeartbeat_s = now_s;
    if (vehicle.isLost)
        m_events.push_back({.kind = LinkEvent::Kind::VehicleReturned, .vehicle = vehicle.address});
    vehicle.isLost = false;
    std::optional<AircraftPosition>& position = vehicle.state.position;
    if (fix.place) {
        if (!position)
            position.emplace();
        position->place = *fix.place;
        position->altitude_m = fix.altitude_m.value_or(position->altitude_m);
        position->received_s = now_s;
    }
    if (!position)
        return; // a speed alone places nothing
    if (fix.speed_mps) {
        const double course_rad = radFromDeg(fix.course_deg.value_or(0)); // none while it stands
        setVelocity(vehicle, *fix.speed_mps * std::cos(course_rad),
                    *fix.speed_mps * std::sin(course_rad));
        tracker->velocity_s = now_s;
    }
    if (!fix.place || (tracker->velocity_s >= 0 && now_s - tracker->velocity_s <= kVelocityKept_s))
        return;
    const double base_s = tracker->from ? now_s - tracker->from->received_s : kLongestBase_s + 1;
    if (base_s < kShortestBase_s)
        return;
    if (base_s <= kLongestBase_s) {
        const Point moved_m = LocalFrame(tracker->from->place).toPlane(position->place);
        if (moved_m.norm() <= kFastest_mps * base_s)
            setVelocity(vehicle, moved_m.y() / base_s, moved_m.x() / base_s);
    }
    tracker->from = position;
}

std::vector<LinkEvent> TrackerList::advance(double now_s)
{
    for (Tracker& tracker : m_trackers) {
        LinkVehicle& vehicle = tracker.vehicle;
        if (vehicle.isLost || now_s - vehicle.lastHeard_s <= kTrackerLost_s)
            continue;
        vehicle.isLost = true;
        m_events.push_back({.kind = LinkEvent::Kind::VehicleLost, .vehicle = vehicle.address});
    }
    return std::exchange(m_events, {});
}

std::vector<LinkVehicle> TrackerList::vehicles() const
{
    std::vector<LinkVehicle> all;
    for (const Tracker& tracker : m_trackers)
        all.push_back(tracker.vehicle);
    return all;
}

} // namespace berg
