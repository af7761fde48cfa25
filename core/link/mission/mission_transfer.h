#pragma once

#include "core/link/mission/mission_item.h"

#include <optional>
#include <vector>

namespace berg {

/** State of a transfer of items. */
enum class TransferState
{
    Running,
    Done,
    AckMissing, ///< Every item was requested, but there was no acknowledgement.
    Failed
};

/** Reason for a failed transfer. */
enum class TransferFailure
{
    None,
    NoAnswer,    ///< The vehicle has not answered the message that opens the transfer.
    GaveUp,      ///< It stopped answering in the middle, twice.
    Refused,     ///< It refuses: see `result`.
    WrongItem,   ///< It requests an item that does not exist.
    TooManyItems ///< It announces more items than Bergwatch accepts.
};

/** Progress and result of a transfer. */
struct TransferStatus
{
    TransferState state = TransferState::Running;
    TransferFailure failure = TransferFailure::None;
    int result = 0; ///< MAV_MISSION_RESULT of the vehicle's last refusal.
    /** Last item requested by the vehicle or read from it, as on the link; nullopt before. */
    std::optional<int> item;
    int done = 0;
    std::optional<int> total; ///< Number of items; nullopt while unknown.
};

/**
 * Sends a list of items to a vehicle, which requests one after another. Follows MAVLink's mission
 * protocol with the resends required by lossy radios: the count and the last item every 1.5 s;
 * after 10 s of silence, 90 s without progress or a cancellation it restarts once. Messages must
 * come from the vehicle and be addressed to us. The functions return the messages to send.
 */
class MissionUpload
{
public:
    /** `items` must come from `itemsToSend`; an empty list clears the vehicle's list. */
    MissionUpload(std::vector<LinkMissionItem> items, MissionType type, LinkAddress vehicle);

    /** Returns the messages due at this time; the first call starts the transfer. */
    [[nodiscard]] std::vector<LinkMessage> advance(double now_s);
    /** Processes a message of the vehicle and returns the answers. Other messages are ignored. */
    [[nodiscard]] std::vector<LinkMessage> receive(const LinkMessage& message, double now_s);

    [[nodiscard]] const TransferStatus& status() const { return m_status; }

private:
    [[nodiscard]] LinkMessage countMessage() const;
    [[nodiscard]] LinkMessage itemMessageAt(int seq) const;
    [[nodiscard]] std::vector<LinkMessage> answerRequest(int seq, double now_s);
    void receiveAck(int result, double now_s);
    /** Restarts, or fails if it has restarted before. */
    [[nodiscard]] std::vector<LinkMessage> restart(double now_s);
    void fail(TransferFailure failure);
    [[nodiscard]] bool isEveryItemRequested() const;

    std::vector<LinkMissionItem> m_items;
    MissionType m_type;
    LinkAddress m_vehicle;
    TransferStatus m_status;
    std::vector<bool> m_wasRequested;
    double m_lastSent_s = 0;
    double m_lastHeard_s = 0;
    double m_lastProgress_s = 0;
    /** Number of sends of the count, or of the last item since the vehicle was heard. */
    int m_sends = 0;
    /** Time of an unspecific error, which may answer an old message. */
    std::optional<double> m_refused_s;
    bool m_mustRestart = false; ///< The vehicle has cancelled the transfer.
    bool m_hasRestarted = false;
};

/**
 * Reads a list of up to 5000 items from a vehicle. Each request is sent up to six times, 1.5 s
 * apart; the transfer restarts once. A busy vehicle gets another request after 2 s, up to eight
 * times. Messages must come from the vehicle and be addressed to us.
 */
class MissionDownload
{
public:
    MissionDownload(MissionType type, LinkAddress vehicle);

    /** Returns the messages due at this time; the first call starts the transfer. */
    [[nodiscard]] std::vector<LinkMessage> advance(double now_s);
    /** Processes a message of the vehicle and returns the answers. Other messages are ignored. */
    [[nodiscard]] std::vector<LinkMessage> receive(const LinkMessage& message, double now_s);

    [[nodiscard]] const TransferStatus& status() const { return m_status; }
    /** Returns the items read so far, as numbered on the link. */
    [[nodiscard]] const std::vector<LinkMissionItem>& items() const { return m_items; }

private:
    /** Returns the request due now: for the list or for the next item. */
    [[nodiscard]] LinkMessage request() const;
    [[nodiscard]] std::vector<LinkMessage> sendRequest(double now_s);
    [[nodiscard]] std::vector<LinkMessage> finish();

    MissionType m_type;
    LinkAddress m_vehicle;
    TransferStatus m_status;
    std::vector<LinkMissionItem> m_items;
    std::optional<int> m_count; ///< Empty until the vehicle has sent it.
    double m_nextSend_s = 0;
    int m_sends = 0; ///< Number of sends of the present request.
    int m_busyAnswers = 0;
    bool m_hasRestarted = false;
};

} // namespace berg
