#include "widgets/aircraft/link_worker.h"

#include "widgets/tasks/work_failure.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace berg {

namespace {

constexpr int kPeriod_ms = 50;
constexpr double kStatus_s = 0.1;
constexpr double kLongestHang_s = 3; ///< Then a ground station counts as lost, too.
constexpr double kSilent_s = 2.5;    ///< Positions come at 1 Hz at least.
constexpr double kHorizon_s = 4 * 3600;
constexpr std::size_t kMostEvents = 1000;
constexpr double kReplayStep_s = 0.25;
constexpr double kReplayWork_s = 0.04; ///< In each period; a faster replay takes its time.
constexpr double kUnlimited = 1e15;

} // namespace

LinkWorker::LinkWorker(Mailbox<LinkStatus>& statuses, LinkClock clock)
    : m_statuses(statuses), m_clock(std::move(clock)), m_timer(this)
{
    m_timer.setInterval(kPeriod_ms);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        const auto failure = failureOf([this] { advance(); });
        if (!failure)
            return;
        close();
        m_statuses.put({.condition = {.state = LinkCondition::State::Broken,
                                      .fault = failure->report.toStdString()}});
        emit published();
    });
}

void LinkWorker::open(const LinkOpener& opener)
{
    close();
    m_link = opener();
    begin(*m_link, {}, LinkSessionOptions{}.self);
}

void LinkWorker::replay(const ReplayOrder& order)
{
    close();
    m_replay = order;
    m_advanced_s = m_clock().monotonic_s;
    // The log contains what a ground station with our own id has sent.
    begin(*order.log, {.rate_bps = kUnlimited, .burst_bytes = kUnlimited}, {});
}

void LinkWorker::begin(ByteLink& link, ReceiveLimits limits, LinkAddress self)
{
    m_received = std::make_unique<TrackerLink>(link);
    m_session = std::make_unique<LinkSession>(
        *m_received,
        LinkSessionOptions{
            .self = self,
            .limits = limits,
            .log = [this](LinkTime now, std::span<const std::uint8_t> frame) { log(now, frame); }});
    setLogFolder(m_logFolder);
    m_nextStatus_s = 0;
    pulse();
    m_timer.start();
}

void LinkWorker::setLogFolder(const QString& folder)
{
    if (folder == m_logFolder && m_log)
        return; // it goes on
    m_logFolder = folder;
    m_log.reset();
    if (!folder.isEmpty() && m_session && !m_replay.log)
        m_log = std::make_unique<LinkLog>(LinkLog::newPathIn(folder));
}

void LinkWorker::log(LinkTime now, std::span<const std::uint8_t> frame)
{
    if (m_log)
        m_log->add(now, frame);
}

void LinkWorker::close()
{
    m_timer.stop();
    m_session.reset();
    m_received.reset();
    m_link.reset();
    m_replay = {};
    m_log.reset();
    m_trackers = {};
    m_ghosts.clear();
    m_onBoard.clear();
    m_traffic = {};
    m_events.clear();
    m_places.clear();
}

void LinkWorker::setSending(bool isOn)
{
    if (m_session && !m_replay.log)
        m_session->setSending(isOn);
}

void LinkWorker::startSync(LinkAddress vehicle, const std::vector<MissionPart>& parts,
                           MissionSync::Task task)
{
    if (m_session)
        static_cast<void>(m_session->startSync(vehicle, parts, task));
}

void LinkWorker::sendCommand(LinkAddress vehicle, const LinkCommand& command)
{
    if (m_session)
        static_cast<void>(m_session->sendCommand(vehicle, command));
}

void LinkWorker::pulse()
{
    m_pulse_s = m_clock().monotonic_s;
}

void LinkWorker::advance()
{
    const double now_s = m_clock().monotonic_s;
    if (now_s - m_pulse_s > kLongestHang_s)
        return; // a window that hangs must look dead to the vehicle
    if (m_replay.log)
        advanceReplay();
    else
        receiveUntil(m_clock());
    if (now_s >= m_nextStatus_s) {
        m_nextStatus_s = now_s + kStatus_s;
        publish();
    }
}

/** In short steps, so that nothing counts as lost between them. */
void LinkWorker::advanceReplay()
{
    const double before_s = std::exchange(m_advanced_s, m_clock().monotonic_s);
    double left_s = m_replay.speed * (m_advanced_s - before_s);
    while (left_s > 0 && m_clock().monotonic_s - m_advanced_s < kReplayWork_s) {
        m_replay.log->advance(std::min(left_s, kReplayStep_s));
        left_s -= kReplayStep_s;
        receiveUntil(m_replay.log->time());
    }
}

void LinkWorker::receiveUntil(LinkTime now)
{
    LinkUpdate update = m_session->advance(now);
    for (const ReceivedFrame& received : update.frames)
        if (received.frame.message)
            m_traffic.receive(*received.frame.message, now.monotonic_s);
    m_traffic.advance(now.monotonic_s);
    for (const VehiclePlace& place : update.places)
        m_places[place.vehicle].push_back(place.place);
    for (const TrackerFix& fix : m_received->takeFixes())
        m_trackers.receive(fix, now.monotonic_s);
    for (const NmeaTarget& target : m_received->takeTargets())
        m_traffic.receive(target, now.monotonic_s);
    std::ranges::move(m_trackers.advance(now.monotonic_s), std::back_inserter(update.events));
    for (LinkEvent& event : update.events) {
        if (event.kind == LinkEvent::Kind::SyncEnded)
            keepOnBoard(event.vehicle);
        if (m_events.size() < kMostEvents)
            m_events.push_back({.time = now, .event = std::move(event)});
    }
    updateGhosts(now.monotonic_s);
}

/** A recheck may have read some of the lists only. */
void LinkWorker::keepOnBoard(LinkAddress vehicle)
{
    std::vector<MissionPart>& kept = m_onBoard[vehicle];
    for (MissionPart& read : m_session->onBoard(vehicle)) {
        const auto old = std::ranges::find(kept, read.type, &MissionPart::type);
        if (old == kept.end())
            kept.push_back(std::move(read));
        else
            *old = std::move(read);
    }
}

void LinkWorker::publish()
{
    for (const LinkVehicle& tracker : m_trackers.vehicles())
        if (tracker.state.position)
            m_places[tracker.address].push_back(tracker.state.position->place);
    if (m_log)
        m_log->flush();
    LinkStatus next = status();
    next.events = std::exchange(m_events, {});
    next.places = std::exchange(m_places, {});
    const bool wasEmpty =
        m_statuses.put(std::move(next), [](LinkStatus& waiting, LinkStatus newer) {
            std::ranges::move(newer.events, std::back_inserter(waiting.events));
            newer.events = std::move(waiting.events);
            if (newer.events.size() > kMostEvents)
                newer.events.resize(kMostEvents);
            for (auto& [address, places] : newer.places) {
                std::vector<LatLon>& all = waiting.places[address];
                std::ranges::move(places, std::back_inserter(all));
            }
            newer.places = std::move(waiting.places);
            waiting = std::move(newer);
        });
    if (wasEmpty)
        emit published();
}

std::vector<LinkVehicle> LinkWorker::vehicles() const
{
    std::vector<LinkVehicle> all = m_session->vehicles();
    std::ranges::move(m_trackers.vehicles(), std::back_inserter(all));
    return all;
}

void LinkWorker::updateGhosts(double now_s)
{
    for (const LinkVehicle& vehicle : vehicles()) {
        const std::optional<AircraftPosition>& position = vehicle.state.position;
        if (!position || now_s - position->received_s < kSilent_s) {
            m_ghosts.erase(vehicle.address);
            continue;
        }
        const auto data = m_data.find(vehicle.address);
        auto ghost = m_ghosts.find(vehicle.address);
        if (ghost == m_ghosts.end() && data != m_data.end()) {
            LastContact last{
                .vehicle = vehicle, .uav = data->second.uav, .wind_mps = data->second.wind_mps};
            if (const auto& wind = vehicle.state.wind)
                last.wind_mps = Point(wind->meanEast_mps, wind->meanNorth_mps);
            if (const auto onBoard = m_onBoard.find(vehicle.address); onBoard != m_onBoard.end())
                for (const MissionPart& part : onBoard->second)
                    if (part.type == MissionType::Mission)
                        last.onBoard = part.items;
            ghost = m_ghosts
                        .emplace(vehicle.address, Ghost{.flight = GhostAircraft(last),
                                                        .lastPosition_s = position->received_s})
                        .first;
        }
        if (ghost != m_ghosts.end())
            ghost->second.flight.advance(now_s);
    }
    predictContact();
}

/** Predicts one aircraft at a time, because hours of flight are simulated for it. */
void LinkWorker::predictContact()
{
    for (auto& [address, ghost] : m_ghosts) {
        const auto data = m_data.find(address);
        if (ghost.isPredicted || data == m_data.end() || !data->second.station)
            continue;
        ghost.isPredicted = true;
        ghost.expected =
            ghost.flight.expectedContact(*data->second.station, data->second.range_m, kHorizon_s);
        return;
    }
}

LinkStatus LinkWorker::status() const
{
    const double now_s = now().monotonic_s;
    LinkStatus status{.isListening = true,
                      .condition = {.state = LinkCondition::State::Open},
                      .isSending = m_session->isSending(),
                      .now_s = now_s,
                      .vehicles = vehicles(),
                      .traffic = m_traffic.targets(),
                      .onBoard = m_onBoard};
    if (m_link)
        status.condition = m_link->condition();
    if (m_log)
        status.log = m_log->report();
    if (m_replay.log)
        status.replay = ReplayReport{.path = m_replay.path,
                                     .played_s = m_replay.log->played_s(),
                                     .part = m_replay.log->part(),
                                     .speed = m_replay.speed,
                                     .isAtEnd = m_replay.log->isAtEnd(),
                                     .skipped_bytes = m_replay.log->skipped_bytes()};
    for (const auto& [address, ghost] : m_ghosts)
        status.ghosts.push_back({.address = address,
                                 .readings = ghost.flight.readings(),
                                 .silentFor_s = now_s - ghost.lastPosition_s,
                                 .expected = ghost.expected});
    return status;
}

} // namespace berg
