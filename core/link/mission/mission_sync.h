#pragma once

#include "core/link/mission/mission_transfer.h"

#include <variant>
#include <vector>

namespace berg {

/** A list of items intended for a vehicle. */
struct MissionPart
{
    MissionType type = MissionType::Mission;
    std::vector<LinkMissionItem> items; ///< Planned items without home, numbered from 0.
};

/** Agreement between plan and vehicle. */
enum class SyncPhase
{
    Uploading,
    ReadingBack,
    Equal, ///< Everything on board equals the plan, except for lists that were left out.
    Different,
    Failed
};

/** Progress and result of an upload and its comparison. */
struct SyncStatus
{
    SyncPhase phase = SyncPhase::Uploading;
    /** The list in progress, or the one that failed or differs. */
    MissionType type = MissionType::Mission;
    TransferStatus transfer;                 ///< Status of that list.
    std::vector<ItemDifference> differences; ///< Empty unless the phase is Different.
    /** Lists that the vehicle does not support and that were left out: no fence, rally points. */
    std::vector<MissionType> leftOut;
    bool isRecheck = false; ///< The task is a recheck.
};

/**
 * Uploads lists to a vehicle, reads each back and compares it. Only the items on board count, not
 * the vehicle's "accepted". Fence and rally points go before the mission, whatever the order of
 * `parts`; the first list that fails or differs ends the task. Rally points, and an empty list in
 * place of a fence, are left out if the vehicle does not support them or never answers. The tasks
 * Compare and Recheck only read and compare. The constructor throws `std::logic_error` without
 * parts.
 */
class MissionSync
{
public:
    enum class Task
    {
        UploadAndCompare,
        Compare,
        Recheck ///< A comparison in the background, to notice changes by others.
    };

    MissionSync(std::vector<MissionPart> parts, Task task, LinkAddress vehicle, AutopilotKind kind);

    /** Returns the messages due at this time; the first call starts the first transfer. */
    [[nodiscard]] std::vector<LinkMessage> advance(double now_s);
    /** Processes a message of the vehicle addressed to us and returns the answers. */
    [[nodiscard]] std::vector<LinkMessage> receive(const LinkMessage& message, double now_s);

    [[nodiscard]] const SyncStatus& status() const { return m_status; }
    [[nodiscard]] bool isRunning() const
    {
        return m_status.phase == SyncPhase::Uploading || m_status.phase == SyncPhase::ReadingBack;
    }
    /** Returns the lists read so far, without home. */
    [[nodiscard]] const std::vector<MissionPart>& onBoard() const { return m_onBoard; }

private:
    void startPart();
    /** Records the end of a transfer and starts the next. */
    void startNextTransfer();
    void startNextPart();
    /** Returns true if the transfer has failed because the vehicle has no such list. */
    [[nodiscard]] bool mayLeaveOut() const;

    std::vector<MissionPart> m_parts;
    Task m_task;
    LinkAddress m_vehicle;
    AutopilotKind m_kind;
    std::size_t m_part = 0;
    std::variant<MissionUpload, MissionDownload> m_transfer;
    std::vector<MissionPart> m_onBoard;
    SyncStatus m_status;
};

} // namespace berg
