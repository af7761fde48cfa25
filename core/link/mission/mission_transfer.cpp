#include "core/link/mission/mission_transfer.h"

#include <algorithm>
#include <utility>

namespace berg {

namespace {

// Times and counts follow MAVLink's mission protocol and QGroundControl's PlanManager.
constexpr double kResend_s = 1.5;
constexpr int kMostSends = 6;
constexpr double kSilence_s = 10;    ///< Both autopilots give up earlier.
constexpr double kNoProgress_s = 90; ///< Limit for repeated requests of one item.
/** Sends of the last item before the comparison replaces the missing acknowledgement. */
constexpr int kSendsOfLastItem = 4;
/** An unspecific error may answer a repeated message: it counts only if silence follows. */
constexpr double kErrorHolds_s = 4;
constexpr double kBusy_s = 2;
constexpr int kMostBusyAnswers = 8;
constexpr int kMostItemsRead = 5000;

// Values of MAV_MISSION_RESULT.
constexpr int kAccepted = 0;
constexpr int kError = 1;
constexpr int kInvalidSequence = 13;
constexpr int kDenied = 14;
constexpr int kCancelled = 15;

LinkMessage addressed(MessageId id, LinkAddress vehicle, MissionType type)
{
    LinkMessage message(id);
    message.with("target_system", vehicle.system)
        .with("target_component", vehicle.component)
        .with("mission_type", static_cast<std::int64_t>(type));
    return message;
}

bool isOfType(const LinkMessage& message, MissionType type)
{
    return message.has("mission_type") &&
           message.integer("mission_type") == static_cast<std::int64_t>(type);
}

} // namespace

MissionUpload::MissionUpload(std::vector<LinkMissionItem> items, MissionType type,
                             LinkAddress vehicle)
    : m_items(std::move(items)), m_type(type), m_vehicle(vehicle), m_wasRequested(m_items.size())
{
    m_status.total = static_cast<int>(m_items.size());
}

LinkMessage MissionUpload::countMessage() const
{
    return addressed(MessageId::MissionCount, m_vehicle, m_type)
        .with("count", static_cast<std::int64_t>(m_items.size()));
}

LinkMessage MissionUpload::itemMessageAt(int seq) const
{
    return itemMessage(m_items[static_cast<std::size_t>(seq)],
                       {.target = m_vehicle,
                        .type = m_type,
                        .seq = seq,
                        .isCurrent = seq == 0 && m_type == MissionType::Mission});
}

bool MissionUpload::isEveryItemRequested() const
{
    return std::find(m_wasRequested.begin(), m_wasRequested.end(), false) == m_wasRequested.end();
}

void MissionUpload::fail(TransferFailure failure)
{
    m_status.state = TransferState::Failed;
    m_status.failure = failure;
}

std::vector<LinkMessage> MissionUpload::restart(double now_s)
{
    m_mustRestart = false;
    m_refused_s.reset();
    if (m_hasRestarted) {
        fail(TransferFailure::GaveUp);
        return {};
    }
    m_hasRestarted = true;
    m_wasRequested.assign(m_items.size(), false);
    m_status.item.reset();
    m_status.done = 0;
    m_sends = 1;
    m_lastSent_s = m_lastHeard_s = m_lastProgress_s = now_s;
    return {countMessage()};
}

std::vector<LinkMessage> MissionUpload::advance(double now_s)
{
    if (m_status.state != TransferState::Running)
        return {};
    if (m_refused_s && now_s - *m_refused_s > kErrorHolds_s) {
        fail(TransferFailure::Refused);
        return {};
    }
    if (m_mustRestart)
        return restart(now_s);
    const bool isDue = m_sends == 0 || now_s - m_lastSent_s >= kResend_s;
    if (!m_status.item) { // nothing requested yet
        if (!isDue)
            return {};
        if (m_sends == kMostSends) {
            fail(m_status.result != kAccepted ? TransferFailure::Refused
                 : m_hasRestarted             ? TransferFailure::GaveUp
                                              : TransferFailure::NoAnswer);
            return {};
        }
        ++m_sends;
        m_lastSent_s = m_lastHeard_s = m_lastProgress_s = now_s;
        return {countMessage()};
    }
    if (isDue && isEveryItemRequested() && m_sends >= kSendsOfLastItem) {
        m_status.state = TransferState::AckMissing;
        return {};
    }
    if (now_s - m_lastHeard_s >= kSilence_s || now_s - m_lastProgress_s >= kNoProgress_s)
        return restart(now_s);
    if (!isDue)
        return {};
    ++m_sends;
    m_lastSent_s = now_s;
    return {itemMessageAt(*m_status.item)};
}

std::vector<LinkMessage> MissionUpload::receive(const LinkMessage& message, double now_s)
{
    if (m_status.state != TransferState::Running || m_sends == 0 || !isOfType(message, m_type))
        return {};
    switch (message.id()) {
    case MessageId::MissionRequest:
    case MessageId::MissionRequestInt:
        return answerRequest(static_cast<int>(message.integer("seq")), now_s);
    case MessageId::MissionAck:
        receiveAck(static_cast<int>(message.integer("type")), now_s);
        return {};
    default:
        return {};
    }
}

std::vector<LinkMessage> MissionUpload::answerRequest(int seq, double now_s)
{
    if (seq >= *m_status.total) {
        m_status.item = seq;
        fail(TransferFailure::WrongItem);
        return {addressed(MessageId::MissionAck, m_vehicle, m_type).with("type", kCancelled)};
    }
    if (!m_wasRequested[static_cast<std::size_t>(seq)]) {
        m_wasRequested[static_cast<std::size_t>(seq)] = true;
        m_lastProgress_s = now_s;
    }
    m_status.item = seq;
    m_status.result = kAccepted;
    m_status.done = seq; // the previous items are on board
    m_refused_s.reset();
    m_sends = 1;
    m_lastSent_s = m_lastHeard_s = now_s;
    return {itemMessageAt(seq)};
}

void MissionUpload::receiveAck(int result, double now_s)
{
    if (result == kInvalidSequence) // ArduPilot received an item twice
        return;
    if (result == kAccepted) { // otherwise it belongs to an earlier transfer
        if (isEveryItemRequested()) {
            m_status.state = TransferState::Done;
            m_status.done = *m_status.total;
        }
        return;
    }
    if (result == kCancelled && m_status.item) { // ArduPilot has timed out
        m_mustRestart = true;
        return;
    }
    m_status.result = result;
    if (result != kError) {
        fail(TransferFailure::Refused);
        return;
    }
    // A busy PX4 only reports "error", for example until it drops a transfer whose end was lost.
    // The count is then sent again.
    if (m_status.item)
        m_refused_s = m_refused_s.value_or(now_s);
}

MissionDownload::MissionDownload(MissionType type, LinkAddress vehicle)
    : m_type(type), m_vehicle(vehicle)
{
}

LinkMessage MissionDownload::request() const
{
    if (!m_count)
        return addressed(MessageId::MissionRequestList, m_vehicle, m_type);
    return addressed(MessageId::MissionRequestInt, m_vehicle, m_type)
        .with("seq", static_cast<std::int64_t>(m_items.size()));
}

std::vector<LinkMessage> MissionDownload::sendRequest(double now_s)
{
    ++m_sends;
    m_nextSend_s = now_s + kResend_s;
    return {request()};
}

std::vector<LinkMessage> MissionDownload::finish()
{
    m_status.state = TransferState::Done;
    return {addressed(MessageId::MissionAck, m_vehicle, m_type).with("type", kAccepted)};
}

std::vector<LinkMessage> MissionDownload::advance(double now_s)
{
    if (m_status.state != TransferState::Running || (m_sends > 0 && now_s < m_nextSend_s))
        return {};
    if (m_sends == kMostSends) {
        if (m_hasRestarted || !m_count) {
            m_status.state = TransferState::Failed;
            m_status.failure = m_hasRestarted ? TransferFailure::GaveUp : TransferFailure::NoAnswer;
            return {};
        }
        m_hasRestarted = true;
        m_count.reset();
        m_items.clear();
        m_status.done = 0;
        m_sends = 0;
    }
    return sendRequest(now_s);
}

std::vector<LinkMessage> MissionDownload::receive(const LinkMessage& message, double now_s)
{
    if (m_status.state != TransferState::Running || m_sends == 0 || !isOfType(message, m_type))
        return {};
    if (message.id() == MessageId::MissionCount && !m_count) {
        m_count = static_cast<int>(message.integer("count"));
        m_status.total = m_count;
        if (*m_count > kMostItemsRead) {
            m_status.state = TransferState::Failed;
            m_status.failure = TransferFailure::TooManyItems;
            return {};
        }
        m_sends = 0;
        return *m_count == 0 ? finish() : sendRequest(now_s);
    }
    const bool isItem =
        message.id() == MessageId::MissionItemInt || message.id() == MessageId::MissionItem;
    if (isItem && m_count && message.integer("seq") == static_cast<int>(m_items.size())) {
        m_status.item = static_cast<int>(m_items.size());
        m_items.push_back(itemOf(message));
        m_status.done = static_cast<int>(m_items.size());
        m_sends = 0;
        return m_status.done == *m_count ? finish() : sendRequest(now_s);
    }
    if (message.id() == MessageId::MissionAck && message.integer("type") != kAccepted) {
        m_status.result = static_cast<int>(message.integer("type"));
        const bool isBusy = m_status.result == kDenied || m_status.result == kError;
        if (isBusy && m_busyAnswers < kMostBusyAnswers) {
            ++m_busyAnswers;
            m_count.reset(); // PX4 has dropped the transfer
            m_items.clear();
            m_status.done = 0;
            m_sends = 1;
            m_nextSend_s = now_s + kBusy_s;
        } else {
            m_status.state = TransferState::Failed;
            m_status.failure = TransferFailure::Refused;
        }
    }
    return {};
}

} // namespace berg
