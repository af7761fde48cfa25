#include "core/link/link_session.h"

#include <algorithm>
#include <array>
#include <utility>

namespace berg {

namespace {

constexpr double kOwnHeartbeat_s = 1;
constexpr double kLostAfter_s = 3; ///< MAVSDK uses this time too.
constexpr std::size_t kMostVehicles = 32;
constexpr std::size_t kMostLossSenders = 256;
constexpr std::size_t kLongestText = 1000;
constexpr int kNotAnAutopilot = 8;
constexpr int kGroundStation = 6;
constexpr int kLargestGap = 200; ///< A larger gap means a late or duplicate frame.

/** Telemetry requested from ArduPilot, with its interval; PX4 sends it unasked. */
struct RequestedStream
{
    MessageId id;
    double interval_us;
};

constexpr std::array<RequestedStream, 8> kRequestedStreams{{
    {MessageId::GlobalPositionInt, 250'000},
    {MessageId::Attitude, 250'000},
    {MessageId::VfrHud, 1'000'000},
    {MessageId::Wind, 1'000'000},
    {MessageId::MissionCurrent, 1'000'000},
    {MessageId::BatteryStatus, 1'000'000},
    {MessageId::SysStatus, 1'000'000},
    {MessageId::ExtendedSysState, 1'000'000},
}};

/** Returns true for messages by which a vehicle receives a list, or ends a transfer. */
bool isOfUpload(MessageId id)
{
    return id == MessageId::MissionRequest || id == MessageId::MissionRequestInt ||
           id == MessageId::MissionAck;
}

} // namespace

LinkSession::LinkSession(ByteLink& link, LinkSessionOptions options)
    : m_exchange(link, {.self = options.self,
                        .key = options.key,
                        .limits = options.limits,
                        .log = std::move(options.log)})
{
}

void LinkSession::setSending(bool isOn)
{
    if (isOn == m_isSending)
        return; // running transfers would be dropped
    m_isSending = isOn;
    m_nextHeartbeat_s = 0;
    for (auto& [address, partner] : m_partners) {
        partner.commands = CommandQueue(address, partner.vehicle.autopilot);
        if (partner.sync && partner.sync->isRunning())
            partner.vehicle.sync.reset(); // the items on board are unknown now
        partner.sync.reset();
        partner.isSyncReported = true;
        partner.isTelemetryRequested = false;
        partner.ownCommands.clear();
    }
}

bool LinkSession::isForUs(const LinkMessage& message) const
{
    const LinkAddress self = m_exchange.self();
    const auto matches = [&](const char* field, std::uint8_t own) {
        return !message.has(field) || message.integer(field) == 0 || message.integer(field) == own;
    };
    return matches("target_system", self.system) && matches("target_component", self.component);
}

LinkUpdate LinkSession::advance(LinkTime now)
{
    LinkUpdate update;
    update.frames = m_exchange.receive(now);
    for (const ReceivedFrame& received : update.frames)
        receiveFrame(received, now, update);
    for (auto& [address, partner] : m_partners) {
        LinkVehicle& vehicle = partner.vehicle;
        if (!vehicle.isLost && now.monotonic_s - vehicle.lastHeartbeat_s > kLostAfter_s) {
            vehicle.isLost = true;
            update.events.push_back({.kind = LinkEvent::Kind::VehicleLost, .vehicle = address});
        }
    }
    if (!m_isSending)
        return update;
    if (now.monotonic_s >= m_nextHeartbeat_s) {
        m_nextHeartbeat_s = now.monotonic_s + kOwnHeartbeat_s;
        m_exchange.broadcast(LinkMessage(MessageId::Heartbeat)
                                 .with("type", kGroundStation)
                                 .with("autopilot", kNotAnAutopilot)
                                 .with("system_status", 4)
                                 .with("mavlink_version", 3),
                             now);
    }
    for (auto& [address, partner] : m_partners)
        sendDue(partner, now, update);
    return update;
}

void LinkSession::countSequence(const LinkFrame& frame)
{
    const auto known = m_senders.find(frame.sender);
    if (known == m_senders.end()) {
        if (m_senders.size() < kMostLossSenders)
            m_senders[frame.sender] = {.lastSequence = frame.sequence, .received = 1};
        return;
    }
    SenderLoss& loss = known->second;
    const auto gap = static_cast<std::uint8_t>(frame.sequence - loss.lastSequence - 1);
    ++loss.received;
    if (gap <= kLargestGap) {
        loss.lost += gap;
        loss.lastSequence = frame.sequence;
    }
}

void LinkSession::receiveFrame(const ReceivedFrame& received, LinkTime now, LinkUpdate& update)
{
    const LinkFrame& frame = received.frame;
    countSequence(frame);
    if (frame.message && frame.message->id() == MessageId::Heartbeat)
        receiveHeartbeat(received, now, update);
    const auto found = m_partners.find(frame.sender);
    if (found == m_partners.end())
        return;
    Partner& partner = found->second;
    LinkVehicle& vehicle = partner.vehicle;
    vehicle.peer = received.peer;
    vehicle.lastHeard_s = now.monotonic_s;
    vehicle.signature = received.signature;
    if (const auto loss = m_senders.find(frame.sender); loss != m_senders.end())
        vehicle.loss = loss->second;
    if (!frame.message)
        return;
    const LinkMessage& message = *frame.message;
    if (!isForUs(message)) {
        if (isOfUpload(message.id()))
            vehicle.othersUpload_s = now.monotonic_s;
        return;
    }
    updateState(vehicle.state, message, now.monotonic_s);
    if (message.id() == MessageId::GlobalPositionInt && vehicle.state.position)
        update.places.push_back(
            {.vehicle = vehicle.address, .place = vehicle.state.position->place});
    if (message.id() == MessageId::StatusText)
        receiveText(partner, message, update);
    if (message.id() == MessageId::MissionItemReached)
        update.events.push_back({.kind = LinkEvent::Kind::ItemReached,
                                 .vehicle = vehicle.address,
                                 .value = static_cast<int>(message.integer("seq"))});
    if (!m_isSending)
        return;
    partner.commands.receive(message, now.monotonic_s);
    if (partner.sync)
        for (const LinkMessage& answer : partner.sync->receive(message, now.monotonic_s))
            m_exchange.send(vehicle.peer, answer, now);
}

void LinkSession::receiveHeartbeat(const ReceivedFrame& received, LinkTime now, LinkUpdate& update)
{
    const LinkMessage& message = *received.frame.message;
    const LinkAddress sender = received.frame.sender;
    if (message.integer("type") == kGroundStation && sender.system == m_exchange.self().system &&
        m_isSending) {
        setSending(false); // a vehicle could not distinguish the two
        update.events.push_back({.kind = LinkEvent::Kind::SameIdHeard, .vehicle = sender});
    }
    if (message.integer("autopilot") == kNotAnAutopilot)
        return;
    auto found = m_partners.find(sender);
    const auto mode = static_cast<std::uint32_t>(message.integer("custom_mode"));
    if (found == m_partners.end()) {
        if (m_partners.size() >= kMostVehicles)
            return;
        const AutopilotKind kind = autopilotKind(message.integer("autopilot"));
        Partner partner{.vehicle = {.address = sender, .autopilot = kind, .mode = mode},
                        .commands = CommandQueue(sender, kind)};
        found = m_partners.emplace(sender, std::move(partner)).first;
        update.events.push_back({.kind = LinkEvent::Kind::VehicleAppeared, .vehicle = sender});
    }
    Partner& partner = found->second;
    LinkVehicle& vehicle = partner.vehicle;
    if (vehicle.isLost) {
        vehicle.isLost = false;
        partner.isTelemetryRequested = false; // it may have restarted
        update.events.push_back({.kind = LinkEvent::Kind::VehicleReturned, .vehicle = sender});
    }
    if (vehicle.mode != mode)
        update.events.push_back({.kind = LinkEvent::Kind::ModeChanged,
                                 .vehicle = sender,
                                 .value = static_cast<int>(mode)});
    vehicle.mode = mode;
    vehicle.type = static_cast<int>(message.integer("type"));
    vehicle.baseMode = static_cast<int>(message.integer("base_mode"));
    vehicle.systemStatus = static_cast<int>(message.integer("system_status"));
    vehicle.lastHeartbeat_s = now.monotonic_s;
}

void LinkSession::receiveText(Partner& partner, const LinkMessage& message, LinkUpdate& update)
{
    constexpr std::size_t kChunk = 50;
    const int id = static_cast<int>(message.integer("id"));
    const std::string chunk = message.text("text");
    if (id == 0 || id != partner.textId || message.integer("chunk_seq") == 0)
        partner.text.clear();
    partner.textId = id;
    partner.text += chunk;
    const bool isEnd = id == 0 || chunk.size() < kChunk || partner.text.size() >= kLongestText;
    if (!isEnd)
        return;
    update.events.push_back({.kind = LinkEvent::Kind::Text,
                             .vehicle = partner.vehicle.address,
                             .value = static_cast<int>(message.integer("severity")),
                             .text = std::exchange(partner.text, {})});
}

void LinkSession::requestTelemetry(Partner& partner)
{
    partner.isTelemetryRequested = true;
    const auto add = [&](std::uint16_t command, MessageId id, double second) {
        partner.ownCommands.push_back(partner.commands.add(
            {.command = command, .params = {static_cast<double>(id), second, 0, 0, 0, 0, 0}}));
    };
    if (partner.vehicle.autopilot != AutopilotKind::Px4)
        for (const RequestedStream& stream : kRequestedStreams)
            add(LinkCommandId::kSetMessageInterval, stream.id, stream.interval_us);
    add(LinkCommandId::kRequestMessage, MessageId::HomePosition, 0);
    add(LinkCommandId::kRequestMessage, MessageId::AutopilotVersion, 0);
}

void LinkSession::sendDue(Partner& partner, LinkTime now, LinkUpdate& update)
{
    LinkVehicle& vehicle = partner.vehicle;
    if (!partner.isTelemetryRequested && !vehicle.isLost)
        requestTelemetry(partner);
    // Behind the number of a silent peer there may be another one.
    const bool isReached = now.monotonic_s - vehicle.lastHeard_s < kPeerKept_s;
    for (const LinkMessage& message : partner.commands.advance(now.monotonic_s))
        if (isReached)
            m_exchange.send(vehicle.peer, message, now);
    reportCommands(partner, now, update);
    if (!partner.sync)
        return;
    for (const LinkMessage& message : partner.sync->advance(now.monotonic_s))
        if (isReached)
            m_exchange.send(vehicle.peer, message, now);
    vehicle.sync = partner.sync->status();
    if (!partner.sync->isRunning() && !partner.isSyncReported) {
        partner.isSyncReported = true;
        update.events.push_back({.kind = LinkEvent::Kind::SyncEnded, .vehicle = vehicle.address});
    }
}

void LinkSession::reportCommands(Partner& partner, LinkTime now, LinkUpdate& update)
{
    constexpr int kUnsupported = 3;
    bool needsOldStreams = false;
    for (const CommandResult& result : partner.commands.takeResults()) {
        const auto own =
            std::find(partner.ownCommands.begin(), partner.ownCommands.end(), result.number);
        if (own == partner.ownCommands.end()) {
            update.events.push_back({.kind = LinkEvent::Kind::CommandEnded,
                                     .vehicle = partner.vehicle.address,
                                     .value = result.number,
                                     .command = result});
            continue;
        }
        partner.ownCommands.erase(own);
        needsOldStreams =
            needsOldStreams ||
            (result.command.command == LinkCommandId::kSetMessageInterval &&
             result.command.params[0] == static_cast<double>(MessageId::GlobalPositionInt) &&
             result.result == kUnsupported);
    }
    if (!needsOldStreams) // autopilots before 2019 only know groups of messages
        return;
    for (int stream : {2, 6, 10, 11, 12})
        m_exchange.send(partner.vehicle.peer,
                        LinkMessage(MessageId::RequestDataStream)
                            .with("req_message_rate", 2)
                            .with("target_system", partner.vehicle.address.system)
                            .with("target_component", partner.vehicle.address.component)
                            .with("req_stream_id", stream)
                            .with("start_stop", 1),
                        now);
}

std::vector<LinkVehicle> LinkSession::vehicles() const
{
    std::vector<LinkVehicle> all;
    for (const auto& [address, partner] : m_partners)
        all.push_back(partner.vehicle);
    return all;
}

const LinkVehicle* LinkSession::findVehicle(LinkAddress address) const
{
    const auto found = m_partners.find(address);
    return found != m_partners.end() ? &found->second.vehicle : nullptr;
}

std::optional<int> LinkSession::sendCommand(LinkAddress vehicle, const LinkCommand& command)
{
    const auto found = m_partners.find(vehicle);
    if (!m_isSending || found == m_partners.end() ||
        !isPermitted(command, found->second.vehicle.autopilot))
        return std::nullopt;
    return found->second.commands.add(command);
}

bool LinkSession::startSync(LinkAddress vehicle, std::vector<MissionPart> parts,
                            MissionSync::Task task)
{
    const auto found = m_partners.find(vehicle);
    if (!m_isSending || found == m_partners.end() || parts.empty())
        return false;
    Partner& partner = found->second;
    if (partner.sync && partner.sync->isRunning() &&
        (!partner.sync->status().isRecheck || task == MissionSync::Task::Recheck))
        return false;
    partner.sync.emplace(std::move(parts), task, vehicle, partner.vehicle.autopilot);
    partner.vehicle.sync = partner.sync->status();
    partner.isSyncReported = false;
    return true;
}

std::vector<MissionPart> LinkSession::onBoard(LinkAddress vehicle) const
{
    const auto found = m_partners.find(vehicle);
    return found != m_partners.end() && found->second.sync ? found->second.sync->onBoard()
                                                           : std::vector<MissionPart>{};
}

} // namespace berg
