#include "core/link/vehicle/vehicle_side.h"

#include "core/link/vehicle/vehicle_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace berg {

namespace {

constexpr double kHeartbeat_s = 1;
constexpr double kShortestInterval_s = 0.02;
constexpr std::size_t kMostGroundStations = 16;

// Values of MAV_RESULT.
constexpr int kResultAccepted = 0;
constexpr int kResultDenied = 2;
constexpr int kResultUnsupported = 3;
constexpr int kResultFailed = 4;
constexpr int kResultOnlyCommandInt = 8;

// Commands that only a vehicle receives.
constexpr std::uint16_t kArmDisarm = 400;
constexpr std::uint16_t kGetHome = 410;
constexpr std::uint16_t kRequestCapabilities = 520;

/** Telemetry that PX4 sends unasked and ArduPilot in requested streams. */
struct StreamRow
{
    MessageId id;
    double interval_s; ///< Interval of PX4.
    int stream;        ///< MAV_DATA_STREAM of ArduPilot that contains it.
};

constexpr std::array<StreamRow, 12> kStreamRows{{
    {MessageId::SysStatus, 1, 2},
    {MessageId::GpsRawInt, 1, 2},
    {MessageId::MissionCurrent, 1, 2},
    {MessageId::GlobalPositionInt, 0.2, 6},
    {MessageId::Attitude, 0.2, 10},
    {MessageId::VfrHud, 0.5, 11},
    {MessageId::BatteryStatus, 1, 12},
    {MessageId::Wind, 0, 12},
    {MessageId::WindCov, 1, 0},
    {MessageId::ExtendedSysState, 1, 12},
    {MessageId::SystemTime, 1, 12},
    {MessageId::HomePosition, 5, 0},
}};

bool isFor(const LinkMessage& message, LinkAddress self)
{
    const auto matches = [&](const char* field, std::uint8_t own) {
        return !message.has(field) || message.integer(field) == 0 || message.integer(field) == own;
    };
    return matches("target_system", self.system) && matches("target_component", self.component);
}

LatLon placeOfUnits(double x, double y)
{
    return {.latitude_deg = x / 1e7, .longitude_deg = y / 1e7};
}

/** Returns true if the autopilot of a fixed wing has this mode. */
bool hasMode(AutopilotKind kind, std::uint32_t mode)
{
    if (kind != AutopilotKind::Px4)
        return mode <= 26 && mode != 9 && mode != 16; // ArduPlane's numbers; 16 is "initialising"
    const std::uint32_t main = mode >> 16U & 0xFFU;
    const std::uint32_t sub = mode >> 24U;
    return (mode & 0xFFFFU) == 0 && main >= 1 && main <= 8 && (main == 4) == (sub != 0);
}

long wholeNumber(double value)
{
    return std::abs(value) < 1e9 ? std::lround(value) : 0L;
}

} // namespace

VehicleSide::VehicleSide(ByteLink& link, VehicleSideOptions options)
    : m_exchange(link, {.self = options.self,
                        .key = options.key,
                        .log = options.log,
                        .logsReceived = options.logsReceived})
    , m_options(std::move(options))
    , m_missions(m_options.autopilot)
{
}

int VehicleSide::itemOffset() const
{
    return m_options.autopilot == AutopilotKind::Px4 ? 0 : 1;
}

void VehicleSide::setInterval(MessageId id, double interval_s, double now_s)
{
    if (interval_s <= 0)
        m_streams.erase(id);
    else
        m_streams[id] = {.interval_s = std::max(interval_s, kShortestInterval_s), .next_s = now_s};
}

void VehicleSide::setDefaultStreams(double now_s)
{
    m_streams.clear();
    for (const StreamRow& row : kStreamRows)
        if (m_options.autopilot == AutopilotKind::Px4)
            setInterval(row.id, row.interval_s, now_s);
}

std::vector<VehicleOrder> VehicleSide::advance(LinkTime now, const VehicleReadings& readings)
{
    std::vector<VehicleOrder> orders;
    const std::vector<ReceivedFrame> frames = m_exchange.receive(now);
    if (m_offUntil_s && now.monotonic_s < *m_offUntil_s)
        return orders;
    if (!m_hasStarted || m_offUntil_s) {
        m_hasStarted = true;
        m_offUntil_s.reset();
        m_bootedAt_s = now.monotonic_s;
        m_nextHeartbeat_s = now.monotonic_s;
        setDefaultStreams(now.monotonic_s);
    }
    LinkMissionItem home{.frame = static_cast<std::uint8_t>(ItemFrame::Global)};
    home.params[3] = 0;
    home.x = static_cast<std::int32_t>(std::lround(1e7 * readings.home.latitude_deg));
    home.y = static_cast<std::int32_t>(std::lround(1e7 * readings.home.longitude_deg));
    home.z = static_cast<float>(readings.homeAltitude_m);
    m_missions.setHome(home);
    const int revision = m_missions.revision(MissionType::Mission);

    for (const ReceivedFrame& received : frames)
        if (received.frame.message && isFor(*received.frame.message, m_options.self))
            answer(received, now, readings, orders);
    for (const AddressedMessage& each : m_missions.advance(now.monotonic_s))
        sendAddressed({each}, m_peerOf.contains(each.target) ? m_peerOf[each.target] : 0, now);
    if (m_missions.revision(MissionType::Mission) != revision)
        orders.push_back({.kind = VehicleOrder::Kind::MissionChanged});

    if (!m_exchange.hasPeers() && !m_options.log)
        return orders; // nobody would receive the telemetry, as of a predicted flight
    if (now.monotonic_s >= m_nextHeartbeat_s) {
        m_nextHeartbeat_s = now.monotonic_s + kHeartbeat_s;
        m_exchange.broadcast(heartbeatOf(readings, m_options), now);
    }
    for (auto& [id, stream] : m_streams) {
        if (now.monotonic_s < stream.next_s)
            continue;
        stream.next_s = now.monotonic_s + stream.interval_s;
        if (const std::optional<LinkMessage> message = telemetry(id, now, readings))
            m_exchange.broadcast(*message, now);
    }
    return orders;
}

std::optional<LinkMessage> VehicleSide::telemetry(MessageId id, LinkTime now,
                                                  const VehicleReadings& readings) const
{
    const double sinceBoot_s = now.monotonic_s - m_bootedAt_s;
    if (id == MessageId::SystemTime)
        return LinkMessage(id)
            .with("time_unix_usec", now.unix_us)
            .with("time_boot_ms", std::llround(1000 * sinceBoot_s));
    if (id != MessageId::MissionCurrent)
        return readingsMessage(id, readings, m_options.autopilot, sinceBoot_s);
    const std::size_t total = m_missions.items(MissionType::Mission).size();
    return LinkMessage(id)
        .with("seq", readings.item + (total > 0 ? itemOffset() : 0))
        .with("total", static_cast<std::int64_t>(total))
        .with("mission_state", total == 0          ? 1
                               : readings.isFlying ? 3
                                                   : 2)
        .with("mission_id", m_missions.opaqueId(MissionType::Mission))
        .with("fence_id", m_missions.opaqueId(MissionType::Fence))
        .with("rally_points_id", m_missions.opaqueId(MissionType::Rally));
}

void VehicleSide::sendAddressed(const std::vector<AddressedMessage>& messages, int peer,
                                LinkTime now)
{
    for (const AddressedMessage& each : messages) {
        if (each.target == LinkAddress{})
            m_exchange.broadcast(each.message, now);
        else
            m_exchange.send(peer, each.message, now);
    }
}

void VehicleSide::answer(const ReceivedFrame& received, LinkTime now,
                         const VehicleReadings& readings, std::vector<VehicleOrder>& orders)
{
    const LinkMessage& message = *received.frame.message;
    const LinkAddress sender = received.frame.sender;
    if (m_peerOf.contains(sender) || m_peerOf.size() < kMostGroundStations)
        m_peerOf[sender] = received.peer;
    const bool isItem =
        message.id() == MessageId::MissionItem || message.id() == MessageId::MissionItemInt;
    if (isItem && m_options.autopilot != AutopilotKind::Px4 && message.integer("current") == 2) {
        answerGuidedItem(received, now, readings, orders);
        return;
    }
    switch (message.id()) {
    case MessageId::CommandLong:
    case MessageId::CommandInt: {
        const int result = execute(message, received.peer, now, readings, orders);
        m_exchange.send(received.peer,
                        LinkMessage(MessageId::CommandAck)
                            .with("command", message.integer("command"))
                            .with("result", result)
                            .with("target_system", sender.system)
                            .with("target_component", sender.component),
                        now);
        return;
    }
    case MessageId::SetMode:
        m_exchange.send(
            received.peer,
            LinkMessage(MessageId::CommandAck)
                .with("command", static_cast<std::int64_t>(MessageId::SetMode))
                .with("result",
                      setMode(static_cast<int>(message.integer("base_mode")),
                              static_cast<std::uint32_t>(message.integer("custom_mode")), orders)),
            now);
        return;
    case MessageId::MissionSetCurrent:
        static_cast<void>(setItem(message.integer("seq"), now, readings, orders));
        return;
    case MessageId::RequestDataStream:
        answerDataStream(message, now.monotonic_s);
        return;
    case MessageId::ParamRequestList:
    case MessageId::ParamRequestRead:
    case MessageId::ParamSet:
        answerParameters(message, received.peer, now);
        return;
    case MessageId::Timesync:
        if (message.integer("tc1") == 0)
            m_exchange.send(received.peer,
                            LinkMessage(MessageId::Timesync)
                                .with("tc1", std::llround(1e9 * now.monotonic_s))
                                .with("ts1", message.integer("ts1")),
                            now);
        return;
    case MessageId::Ping:
        if (message.integer("target_system") == 0)
            m_exchange.send(received.peer,
                            LinkMessage(message)
                                .with("target_system", sender.system)
                                .with("target_component", sender.component),
                            now);
        return;
    default:
        sendAddressed(m_missions.receive(message, sender, now.monotonic_s), received.peer, now);
    }
}

int VehicleSide::execute(const LinkMessage& command, int peer, LinkTime now,
                         const VehicleReadings& readings, std::vector<VehicleOrder>& orders)
{
    const double first = command.real("param1");
    const double second = command.real("param2");
    const auto sendOnce = [&](MessageId id) {
        const std::optional<LinkMessage> message = telemetry(id, now, readings);
        if (message)
            m_exchange.send(peer, *message, now);
        return message ? kResultAccepted : kResultUnsupported;
    };
    switch (command.integer("command")) {
    case LinkCommandId::kSetMode: {
        const bool isPx4 = m_options.autopilot == AutopilotKind::Px4;
        const long main = wholeNumber(second) & 0xFF;
        const long sub = wholeNumber(command.real("param3")) & 0xFF;
        return setMode(
            static_cast<int>(wholeNumber(first)),
            static_cast<std::uint32_t>(isPx4 ? (sub << 24) + (main << 16) : wholeNumber(second)),
            orders);
    }
    case LinkCommandId::kSetCurrentItem:
        return setItem(wholeNumber(first), now, readings, orders);
    case LinkCommandId::kReposition:
        return reposition(command, readings, orders);
    case LinkCommandId::kChangeSpeed:
        if (!(second > 0))
            return kResultDenied;
        orders.push_back({.kind = VehicleOrder::Kind::ChangeSpeed, .speed_mps = second});
        return kResultAccepted;
    case LinkCommandId::kSetMessageInterval:
        return setMessageInterval(static_cast<MessageId>(wholeNumber(first)), second,
                                  now.monotonic_s);
    case LinkCommandId::kRequestMessage:
        return sendOnce(static_cast<MessageId>(wholeNumber(first)));
    case kRequestCapabilities:
        return sendOnce(MessageId::AutopilotVersion);
    case kGetHome:
        return sendOnce(MessageId::HomePosition);
    case kArmDisarm:
    case LinkCommandId::kTakeOff:
    case LinkCommandId::kLand:
    case LinkCommandId::kMissionStart:
        return kResultDenied; // the pilot decides
    default:
        return kResultUnsupported;
    }
}

int VehicleSide::setMode(int baseMode, std::uint32_t mode, std::vector<VehicleOrder>& orders) const
{
    constexpr int kHasCustomMode = 1;
    if ((baseMode & kHasCustomMode) == 0)
        return kResultDenied;
    if (!hasMode(m_options.autopilot, mode))
        return kResultFailed;
    orders.push_back({.kind = VehicleOrder::Kind::SetMode, .mode = mode});
    return kResultAccepted;
}

int VehicleSide::setItem(std::int64_t seq, LinkTime now, const VehicleReadings& readings,
                         std::vector<VehicleOrder>& orders)
{
    const auto count = static_cast<std::int64_t>(m_missions.items(MissionType::Mission).size());
    if (seq < 0 || count == 0 || seq >= count + itemOffset())
        return kResultFailed;
    orders.push_back({.kind = VehicleOrder::Kind::SetItem,
                      .item = std::max(0, static_cast<int>(seq) - itemOffset())});
    // Stations take this number as the acknowledgement of MISSION_SET_CURRENT, even 0 for home.
    if (std::optional<LinkMessage> current = telemetry(MessageId::MissionCurrent, now, readings))
        m_exchange.broadcast(current->with("seq", seq), now);
    return kResultAccepted;
}

int VehicleSide::reposition(const LinkMessage& command, const VehicleReadings& readings,
                            std::vector<VehicleOrder>& orders) const
{
    constexpr std::uint32_t kPlaneGuided = 15;
    constexpr long kChangesMode = 1;
    if (command.id() != MessageId::CommandInt)
        return kResultOnlyCommandInt;
    const bool isPx4 = m_options.autopilot == AutopilotKind::Px4;
    const LatLon place = placeOfUnits(command.real("x"), command.real("y"));
    const bool mayChangeMode = (wholeNumber(command.real("param2")) & kChangesMode) != 0;
    if (std::abs(place.latitude_deg) > 90 || std::abs(place.longitude_deg) > 180 ||
        (!isPx4 && readings.mode != kPlaneGuided && !mayChangeMode))
        return kResultDenied;
    const double radius_m = command.real("param3");
    orders.push_back(
        {.kind = VehicleOrder::Kind::Reposition,
         .place = place,
         .altitude_m = command.real("z"),
         // PX4 takes every altitude as above mean sea level.
         .frame = isPx4 ? ItemFrame::Global : static_cast<ItemFrame>(command.integer("frame")),
         .radius_m = std::isfinite(radius_m) ? radius_m : 0});
    return kResultAccepted;
}

void VehicleSide::answerGuidedItem(const ReceivedFrame& received, LinkTime now,
                                   const VehicleReadings& readings,
                                   std::vector<VehicleOrder>& orders)
{
    const LinkMissionItem item = itemOf(*received.frame.message);
    LinkMessage command(MessageId::CommandInt);
    command.with("x", item.x)
        .with("y", item.y)
        .withReal("z", static_cast<double>(item.z))
        .with("frame", item.frame);
    const bool isWaypoint = item.command == LinkCommandId::kWaypoint;
    const bool isAccepted = isWaypoint && reposition(command, readings, orders) == kResultAccepted;
    m_exchange.send(received.peer,
                    LinkMessage(MessageId::MissionAck)
                        .with("target_system", received.frame.sender.system)
                        .with("target_component", received.frame.sender.component)
                        .with("type", isAccepted ? 0 : 1), // accepted, or an error
                    now);
}

int VehicleSide::setMessageInterval(MessageId id, double interval_us, double now_s)
{
    const auto* const row = std::find_if(kStreamRows.begin(), kStreamRows.end(),
                                         [&](const StreamRow& each) { return each.id == id; });
    if (row == kStreamRows.end())
        return kResultUnsupported;
    const bool isDefault = interval_us == 0 && m_options.autopilot == AutopilotKind::Px4;
    setInterval(id, isDefault ? row->interval_s : interval_us / 1e6, now_s);
    return kResultAccepted;
}

void VehicleSide::answerDataStream(const LinkMessage& request, double now_s)
{
    const std::int64_t rate_hz = request.integer("req_message_rate");
    const bool isOn = request.integer("start_stop") != 0 && rate_hz > 0;
    const std::int64_t stream = request.integer("req_stream_id");
    for (const StreamRow& row : kStreamRows)
        if (row.stream != 0 && (stream == 0 || stream == row.stream))
            setInterval(row.id, isOn ? 1.0 / static_cast<double>(rate_hz) : 0, now_s);
}

void VehicleSide::answerParameters(const LinkMessage& request, int peer, LinkTime now)
{
    const auto& parameters = m_options.parameters;
    const auto send = [&](std::size_t index) {
        m_exchange.send(peer,
                        LinkMessage(MessageId::ParamValue)
                            .withText("param_id", parameters[index].first)
                            .withReal("param_value", parameters[index].second)
                            .with("param_type", 9) // MAV_PARAM_TYPE of a float
                            .with("param_count", static_cast<std::int64_t>(parameters.size()))
                            .with("param_index", static_cast<std::int64_t>(index)),
                        now);
    };
    const bool isByIndex = request.has("param_index") && request.integer("param_index") >= 0;
    const std::string name = request.has("param_id") ? request.text("param_id") : std::string();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool isRequested = request.id() == MessageId::ParamRequestList ||
                                 (isByIndex ? request.integer("param_index") == static_cast<int>(i)
                                            : parameters[i].first == name);
        if (isRequested)
            send(i);
    }
}

void VehicleSide::reportReached(int item, LinkTime now)
{
    m_exchange.broadcast(
        LinkMessage(MessageId::MissionItemReached).with("seq", item + itemOffset()), now);
}

void VehicleSide::reportText(int severity, const std::string& text, LinkTime now)
{
    m_exchange.broadcast(
        LinkMessage(MessageId::StatusText).with("severity", severity).withText("text", text), now);
}

void VehicleSide::reboot(LinkTime now, double off_s)
{
    m_offUntil_s = now.monotonic_s + off_s;
    m_missions.reboot();
    m_streams.clear();
}

} // namespace berg
