#include "core/link/mission/vehicle_missions.h"

#include "core/base/random.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace berg {

namespace {

// Times, limits and answers follow ArduPilot's MissionItemProtocol and PX4's MavlinkMissionManager.
constexpr double kArduPilotRetry_s = 1.0;
constexpr double kArduPilotTimeout_s = 8;
constexpr double kPx4Retry_s = 0.5;
constexpr double kPx4Timeout_s = 5;
constexpr int kMostRepeats = 3; ///< Then PX4's requests change to the old message.
constexpr std::array<int, 3> kMostItems{718, 70, 10}; ///< Mission, fence, rally.

// Values of MAV_MISSION_RESULT.
constexpr int kMissionAccepted = 0;
constexpr int kMissionError = 1;
constexpr int kMissionFrameUnsupported = 2;
constexpr int kMissionTypeUnsupported = 3;
constexpr int kMissionNoSpace = 4;
constexpr int kMissionInvalidX = 10;
constexpr int kMissionInvalidY = 11;
constexpr int kMissionInvalidSequence = 13;
constexpr int kMissionDenied = 14;
constexpr int kMissionCancelled = 15;
constexpr std::int64_t kAllTypes = 255;

std::optional<MissionType> typeOf(const LinkMessage& message)
{
    const std::int64_t type = message.integer("mission_type");
    return type >= 0 && type <= 2 ? std::optional(static_cast<MissionType>(type)) : std::nullopt;
}

int mostItems(MissionType type)
{
    return kMostItems.at(static_cast<std::size_t>(type));
}

LinkMessage statusText(int severity, std::string_view text)
{
    return LinkMessage(MessageId::StatusText).with("severity", severity).withText("text", text);
}

/** Returns the reason why a vehicle refuses the item, or kMissionAccepted. */
int verdictOn(const LinkMissionItem& item, MissionType type, AutopilotKind kind)
{
    constexpr std::array<int, 7> kFrames{0, 2, 3, 5, 6, 10, 11};
    if (std::find(kFrames.begin(), kFrames.end(), item.frame) == kFrames.end())
        return kMissionFrameUnsupported;
    const bool isOfFence = item.command >= 5000 && item.command <= 5004;
    const bool isOfRally = item.command == 5100;
    const bool isOfMission = !isOfFence && !isOfRally;
    const bool belongs = type == MissionType::Fence   ? isOfFence
                         : type == MissionType::Rally ? isOfRally
                                                      : isOfMission;
    if (!belongs)
        return kind == AutopilotKind::Px4 ? kMissionError : kMissionTypeUnsupported;
    if (item.frame != 2 && std::abs(std::int64_t{item.x}) > 900'000'000)
        return kMissionInvalidX;
    if (item.frame != 2 && std::abs(std::int64_t{item.y}) > 1'800'000'000)
        return kMissionInvalidY;
    return kMissionAccepted;
}

/** Returns the message with floats that answers MISSION_REQUEST. */
LinkMessage floatItem(const LinkMessage& item)
{
    LinkMessage message(MessageId::MissionItem);
    const double scale = item.integer("frame") != 2 ? 1e-7 : 1;
    for (const MessageField& field : item.spec().fields) {
        if (field.name == "x" || field.name == "y")
            message.withReal(field.name, scale * item.real(field.name));
        else if (field.type == FieldType::F32)
            message.withReal(field.name, item.real(field.name));
        else
            message.with(field.name, item.integer(field.name));
    }
    return message;
}

} // namespace

VehicleMissions::VehicleMissions(AutopilotKind kind) : m_kind(kind) {}

const VehicleMissions::List& VehicleMissions::listOf(MissionType type) const
{
    return m_lists.at(static_cast<std::size_t>(type));
}

VehicleMissions::List& VehicleMissions::listOf(MissionType type)
{
    return m_lists.at(static_cast<std::size_t>(type));
}

void VehicleMissions::setHome(const LinkMissionItem& home)
{
    m_home = home;
    std::vector<LinkMissionItem>& mission = listOf(MissionType::Mission).items;
    if (isArduPilot() && !mission.empty())
        mission.front() = home;
}

void VehicleMissions::load(MissionType type, std::span<const LinkMissionItem> items)
{
    listOf(type).items =
        itemsToSend(items, type, isArduPilot() ? AutopilotKind::ArduPilot : AutopilotKind::Px4);
    ++listOf(type).revision;
}

std::vector<LinkMissionItem> VehicleMissions::items(MissionType type) const
{
    return itemsReadBack(listOf(type).items, type,
                         isArduPilot() ? AutopilotKind::ArduPilot : AutopilotKind::Px4);
}

std::uint32_t VehicleMissions::opaqueId(MissionType type) const
{
    if (isArduPilot() || listOf(type).items.empty())
        return 0;
    std::string bytes;
    for (const LinkMissionItem& item : listOf(type).items) {
        const LinkMessage message = itemMessage(item, {}); // must outlive the loop over its bytes
        for (const std::uint8_t byte : message.payload())
            bytes.push_back(static_cast<char>(byte));
    }
    return static_cast<std::uint32_t>(stableHash(bytes)) | 1U; // 0 means "not supported"
}

AddressedMessage VehicleMissions::ack(LinkAddress target, MissionType type, int result) const
{
    LinkMessage message(MessageId::MissionAck);
    message.with("target_system", target.system)
        .with("target_component", target.component)
        .with("type", result)
        .with("mission_type", static_cast<std::int64_t>(type))
        .with("opaque_id", opaqueId(type));
    return {.target = target, .message = message};
}

AddressedMessage VehicleMissions::request() const
{
    const bool isOld = isArduPilot() || m_asksOldWay;
    LinkMessage message(isOld ? MessageId::MissionRequest : MessageId::MissionRequestInt);
    message.with("target_system", m_partner.system)
        .with("target_component", m_partner.component)
        .with("seq", m_seq)
        .with("mission_type", static_cast<std::int64_t>(m_type));
    return {.target = m_partner, .message = message};
}

std::vector<AddressedMessage> VehicleMissions::receive(const LinkMessage& message,
                                                       LinkAddress sender, double now_s)
{
    switch (message.id()) {
    case MessageId::MissionCount:
        return receiveCount(message, sender, now_s);
    case MessageId::MissionWritePartialList:
        return receivePartialList(message, sender, now_s);
    case MessageId::MissionItem:
    case MessageId::MissionItemInt:
        return receiveItem(message, sender, now_s);
    case MessageId::MissionRequestList:
        if (const std::optional<MissionType> type = typeOf(message))
            return sendCount(*type, sender, now_s);
        return {};
    case MessageId::MissionRequest:
    case MessageId::MissionRequestInt:
        return sendItem(message, sender, now_s);
    case MessageId::MissionClearAll:
        return clear(message, sender);
    case MessageId::MissionAck:
        if (m_state == State::Sending && sender == m_partner)
            m_state = State::Idle;
        return {};
    default:
        return {};
    }
}

std::vector<AddressedMessage> VehicleMissions::receiveCount(const LinkMessage& message,
                                                            LinkAddress sender, double now_s)
{
    const std::optional<MissionType> type = typeOf(message);
    if (!type)
        return {ack(sender, MissionType::Mission, kMissionTypeUnsupported)};
    const bool isOfOther = m_state != State::Idle && sender != m_partner;
    if (isArduPilot() && m_state == State::Receiving && isOfOther)
        return {ack(sender, *type, kMissionDenied)};
    if (!isArduPilot() && m_state != State::Idle) {
        // The first request may have been lost; later a new count is an error.
        const bool isAgain = m_state == State::Receiving && !isOfOther && m_seq == 0;
        if (isOfOther || !isAgain)
            return {ack(sender, *type, kMissionError)};
    }
    const int count = static_cast<int>(message.integer("count"));
    if (count > mostItems(*type))
        return {ack(sender, *type, kMissionNoSpace)};

    if (isArduPilot() && listOf(*type).items.size() > static_cast<std::size_t>(count)) {
        listOf(*type).items.resize(static_cast<std::size_t>(count)); // before any item arrives
        ++listOf(*type).revision;
    }
    std::vector<AddressedMessage> first = beginReceiving(*type, sender, 0, count - 1, now_s);
    if (count > 0)
        return first;
    complete();
    return {ack(sender, *type, kMissionAccepted)};
}

std::vector<AddressedMessage> VehicleMissions::receivePartialList(const LinkMessage& message,
                                                                  LinkAddress sender, double now_s)
{
    if (!isArduPilot())
        return {};
    const std::optional<MissionType> type = typeOf(message);
    if (!type)
        return {ack(sender, MissionType::Mission, kMissionTypeUnsupported)};
    if (m_state == State::Receiving)
        return {ack(sender, *type, kMissionDenied)};
    const auto count = static_cast<std::int64_t>(listOf(*type).items.size());
    const std::int64_t first = message.integer("start_index");
    const std::int64_t last = message.integer("end_index"); // may be the place behind the last item
    const bool isInside = first >= 0 && first <= last && last <= count && last < mostItems(*type);
    if (!isInside)
        return {ack(sender, *type, kMissionError)};
    return beginReceiving(*type, sender, static_cast<int>(first), static_cast<int>(last), now_s);
}

std::vector<AddressedMessage> VehicleMissions::beginReceiving(MissionType type, LinkAddress sender,
                                                              int first, int last, double now_s)
{
    m_state = State::Receiving;
    m_partner = sender;
    m_type = type;
    m_seq = first;
    m_count = last + 1;
    m_incoming.clear();
    m_repeats = 0;
    m_asksOldWay = false;
    m_lastHeard_s = m_lastRequest_s = now_s;
    return {request()};
}

std::vector<AddressedMessage> VehicleMissions::receiveItem(const LinkMessage& message,
                                                           LinkAddress sender, double now_s)
{
    const int seq = static_cast<int>(message.integer("seq"));
    if (m_state != State::Receiving) {
        if (isArduPilot() || sender != m_partner)
            return {};
        // PX4 takes the last item as a request for a lost acknowledgement.
        if (seq + 1 == m_count && m_seq == m_count)
            return {ack(sender, m_type, kMissionAccepted)};
        return {{.target = {}, .message = statusText(2, "IGN MISSION_ITEM: No transfer")},
                ack(sender, m_type, kMissionError)};
    }
    if (sender != m_partner)
        return {ack(sender, m_type, isArduPilot() ? kMissionDenied : kMissionError)};
    if (typeOf(message) != m_type)
        return {};
    if (!isArduPilot())
        m_lastHeard_s = now_s;
    if (seq != m_seq) {
        if (isArduPilot())
            return {ack(sender, m_type, kMissionInvalidSequence)};
        return {};
    }
    const LinkMissionItem item = itemOf(message);
    if (const int verdict = verdictOn(item, m_type, m_kind); verdict != kMissionAccepted) {
        m_state = State::Idle;
        return {ack(sender, m_type, verdict)};
    }
    if (isArduPilot()) { // written directly into the active mission
        std::vector<LinkMissionItem>& items = listOf(m_type).items;
        items.resize(std::max(items.size(), static_cast<std::size_t>(seq) + 1));
        const bool isHome = seq == 0 && m_type == MissionType::Mission;
        items[static_cast<std::size_t>(seq)] = isHome ? m_home : item;
        ++listOf(m_type).revision;
    } else {
        m_incoming.push_back(item);
    }
    m_repeats = 0;
    m_lastHeard_s = m_lastRequest_s = now_s;
    if (++m_seq < m_count)
        return {request()};
    complete();
    return {ack(sender, m_type, kMissionAccepted)};
}

void VehicleMissions::complete()
{
    m_state = State::Idle;
    if (!isArduPilot() || m_count == 0)
        listOf(m_type).items = m_incoming;
    ++listOf(m_type).revision;
    m_incoming.clear();
}

std::vector<AddressedMessage> VehicleMissions::sendCount(MissionType type, LinkAddress receiver,
                                                         double now_s)
{
    if (m_state == State::Receiving || (m_state == State::Sending && receiver != m_partner))
        return {ack(receiver, type, isArduPilot() ? kMissionDenied : kMissionError)};
    const std::size_t count = listOf(type).items.size();
    if (!isArduPilot()) {
        m_state = count > 0 ? State::Sending : State::Idle;
        m_partner = receiver;
        m_type = type;
        m_seq = 0;
        m_count = static_cast<int>(count);
        m_lastHeard_s = now_s;
    }
    LinkMessage message(MessageId::MissionCount);
    message.with("target_system", receiver.system)
        .with("target_component", receiver.component)
        .with("count", static_cast<std::int64_t>(count))
        .with("mission_type", static_cast<std::int64_t>(type))
        .with("opaque_id", opaqueId(type));
    return {{.target = receiver, .message = message}};
}

std::vector<AddressedMessage> VehicleMissions::sendItem(const LinkMessage& message,
                                                        LinkAddress receiver, double now_s)
{
    const std::optional<MissionType> type = typeOf(message);
    const int seq = static_cast<int>(message.integer("seq"));
    if (!type)
        return {};
    if (m_state == State::Receiving)
        return {ack(receiver, *type, isArduPilot() ? kMissionDenied : kMissionError)};
    const List& list = listOf(*type);
    std::optional<LinkMissionItem> item;
    if (seq < static_cast<int>(list.items.size()))
        item = list.items[static_cast<std::size_t>(seq)];
    else if (isArduPilot() && *type == MissionType::Mission && seq == 0)
        item = m_home; // stations read it without a mission, too
    if (!isArduPilot()) {
        if (m_state != State::Sending || receiver != m_partner || *type != m_type)
            return {};
        m_lastHeard_s = now_s;
        // Only the next item, or the last one again, may be requested.
        if (seq != m_seq && seq != m_seq - 1) {
            m_state = State::Idle;
            return {
                {.target = {}, .message = statusText(2, "WPM: REJ. CMD: Req. WP was unexpected")},
                ack(receiver, *type, kMissionError)};
        }
        m_seq = seq + 1;
    }
    if (!item)
        return {ack(receiver, *type, kMissionError)};
    const LinkMessage sent = itemMessage(*item, {.target = receiver, .type = *type, .seq = seq});
    return {{.target = receiver,
             .message = message.id() == MessageId::MissionRequestInt ? sent : floatItem(sent)}};
}

std::vector<AddressedMessage> VehicleMissions::clear(const LinkMessage& message, LinkAddress sender)
{
    const bool isAll = message.integer("mission_type") == kAllTypes;
    const std::optional<MissionType> type = typeOf(message);
    if (!isAll && !type)
        return {ack(sender, MissionType::Mission, kMissionTypeUnsupported)};
    // ArduPilot ends an upload of the same station; PX4 is busy.
    const bool isRefused =
        isArduPilot() ? m_state == State::Receiving && sender != m_partner : m_state != State::Idle;
    if (isRefused)
        return {ack(sender, type.value_or(MissionType::Mission),
                    isArduPilot() ? kMissionDenied : kMissionError)};
    m_state = State::Idle;
    for (std::size_t i = 0; i < m_lists.size(); ++i) {
        if (isAll || i == static_cast<std::size_t>(*type)) {
            m_lists.at(i).items.clear();
            ++m_lists.at(i).revision;
        }
    }
    AddressedMessage answer = ack(sender, type.value_or(MissionType::Mission), kMissionAccepted);
    if (isAll)
        answer.message.with("mission_type", kAllTypes);
    return {answer};
}

std::vector<AddressedMessage> VehicleMissions::advance(double now_s)
{
    if (m_state == State::Idle)
        return {};
    if (now_s - m_lastHeard_s > (isArduPilot() ? kArduPilotTimeout_s : kPx4Timeout_s)) {
        const bool wasReceiving = m_state == State::Receiving;
        m_state = State::Idle;
        if (!isArduPilot()) {
            m_seq = 0; // late items get no acknowledgement
            return {{.target = {}, .message = statusText(2, "Operation timeout")}};
        }
        if (wasReceiving)
            return {ack(m_partner, m_type, kMissionCancelled)};
        return {};
    }
    if (m_state != State::Receiving ||
        now_s - m_lastRequest_s < (isArduPilot() ? kArduPilotRetry_s : kPx4Retry_s))
        return {};
    m_lastRequest_s = now_s;
    m_asksOldWay = m_asksOldWay || ++m_repeats >= kMostRepeats;
    return {request()};
}

void VehicleMissions::reboot()
{
    m_state = State::Idle;
    m_incoming.clear();
    m_seq = 0;
    m_count = 0;
}

} // namespace berg
