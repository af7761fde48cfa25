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
    m_session = std::make_unique<LinkSession>(*m_link, LinkSessionOptions{});
    m_nextStatus_s = 0;
    pulse();
    m_timer.start();
}

void LinkWorker::close()
{
    m_timer.stop();
    m_session.reset();
    m_link.reset();
    m_ghosts.clear();
    m_onBoard.clear();
    m_traffic = {};
    m_events.clear();
}

void LinkWorker::setSending(bool isOn)
{
    if (m_session)
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
    const LinkTime now = m_clock();
    if (now.monotonic_s - m_pulse_s > kLongestHang_s)
        return; // a window that hangs must look dead to the vehicle
    LinkUpdate update = m_session->advance(now);
    for (const ReceivedFrame& received : update.frames)
        if (received.frame.message)
            m_traffic.receive(*received.frame.message, now.monotonic_s);
    m_traffic.advance(now.monotonic_s);
    for (LinkEvent& event : update.events) {
        if (event.kind == LinkEvent::Kind::SyncEnded)
            m_onBoard[event.vehicle] = m_session->onBoard(event.vehicle);
        if (m_events.size() < kMostEvents)
            m_events.push_back({.time = now, .event = std::move(event)});
    }
    updateGhosts(now.monotonic_s);
    if (now.monotonic_s < m_nextStatus_s)
        return;
    m_nextStatus_s = now.monotonic_s + kStatus_s;
    LinkStatus next = status();
    next.now_s = now.monotonic_s;
    next.events = std::exchange(m_events, {});
    const bool wasEmpty =
        m_statuses.put(std::move(next), [](LinkStatus& waiting, LinkStatus newer) {
            std::ranges::move(newer.events, std::back_inserter(waiting.events));
            newer.events = std::move(waiting.events);
            if (newer.events.size() > kMostEvents)
                newer.events.resize(kMostEvents);
            waiting = std::move(newer);
        });
    if (wasEmpty)
        emit published();
}

void LinkWorker::updateGhosts(double now_s)
{
    for (const LinkVehicle& vehicle : m_session->vehicles()) {
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
            if (data->second.station)
                ghost->second.expected = ghost->second.flight.expectedContact(
                    *data->second.station, data->second.range_m, kHorizon_s);
        }
        if (ghost != m_ghosts.end())
            ghost->second.flight.advance(now_s);
    }
}

LinkStatus LinkWorker::status() const
{
    LinkStatus status{.isListening = true,
                      .condition = m_link->condition(),
                      .isSending = m_session->isSending(),
                      .vehicles = m_session->vehicles(),
                      .traffic = m_traffic.targets(),
                      .onBoard = m_onBoard};
    const double now_s = m_clock().monotonic_s;
    for (const auto& [address, ghost] : m_ghosts)
        status.ghosts.push_back({.address = address,
                                 .readings = ghost.flight.readings(),
                                 .silentFor_s = now_s - ghost.lastPosition_s,
                                 .expected = ghost.expected});
    return status;
}

} // namespace berg
