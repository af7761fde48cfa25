#include "core/link/mission/mission_sync.h"

#include "core/base/error.h"

#include <algorithm>
#include <utility>

namespace berg {

MissionSync::MissionSync(std::vector<MissionPart> parts, Task task, LinkAddress vehicle,
                         AutopilotKind kind)
    : m_parts(std::move(parts))
    , m_task(task)
    , m_vehicle(vehicle)
    , m_kind(kind)
    , m_transfer(MissionDownload(MissionType::Mission, vehicle))
{
    require(!m_parts.empty(), "lists to compare");
    std::stable_partition(m_parts.begin(), m_parts.end(), [](const MissionPart& part) {
        return part.type != MissionType::Mission;
    });
    m_status.isRecheck = task == Task::Recheck;
    startPart();
}

void MissionSync::startPart()
{
    const MissionPart& part = m_parts[m_part];
    m_status.type = part.type;
    if (m_task == Task::UploadAndCompare) {
        m_status.phase = SyncPhase::Uploading;
        m_transfer =
            MissionUpload(itemsToSend(part.items, part.type, m_kind), part.type, m_vehicle);
    } else {
        m_status.phase = SyncPhase::ReadingBack;
        m_transfer = MissionDownload(part.type, m_vehicle);
    }
}

std::vector<LinkMessage> MissionSync::advance(double now_s)
{
    if (!isRunning())
        return {};
    std::vector<LinkMessage> sent =
        std::visit([&](auto& transfer) { return transfer.advance(now_s); }, m_transfer);
    startNextTransfer();
    return sent;
}

std::vector<LinkMessage> MissionSync::receive(const LinkMessage& message, double now_s)
{
    if (!isRunning())
        return {};
    std::vector<LinkMessage> sent =
        std::visit([&](auto& transfer) { return transfer.receive(message, now_s); }, m_transfer);
    startNextTransfer();
    return sent;
}

void MissionSync::startNextTransfer()
{
    m_status.transfer =
        std::visit([](const auto& transfer) { return transfer.status(); }, m_transfer);
    if (m_status.transfer.state == TransferState::Running)
        return;
    if (m_status.transfer.state == TransferState::Failed) {
        if (mayLeaveOut()) {
            m_status.leftOut.push_back(m_parts[m_part].type);
            startNextPart();
        } else {
            m_status.phase = SyncPhase::Failed;
        }
        return;
    }
    const MissionPart& part = m_parts[m_part];
    if (m_status.phase == SyncPhase::Uploading) {
        m_status.phase = SyncPhase::ReadingBack;
        m_transfer = MissionDownload(part.type, m_vehicle);
        return;
    }
    m_onBoard.push_back(
        {.type = part.type,
         .items = itemsReadBack(std::get<MissionDownload>(m_transfer).items(), part.type, m_kind)});
    m_status.differences = missionDifferences(part.items, m_onBoard.back().items);
    if (!m_status.differences.empty())
        m_status.phase = SyncPhase::Different;
    else
        startNextPart();
}

void MissionSync::startNextPart()
{
    if (m_part + 1 == m_parts.size()) {
        m_status.phase = SyncPhase::Equal;
        return;
    }
    ++m_part;
    startPart();
}

bool MissionSync::mayLeaveOut() const
{
    constexpr int kUnsupported = 3;
    const MissionPart& part = m_parts[m_part];
    const bool isDispensable =
        part.type == MissionType::Rally || (part.type == MissionType::Fence && part.items.empty());
    const TransferStatus& transfer = m_status.transfer;
    return isDispensable &&
           (transfer.failure == TransferFailure::NoAnswer ||
            (transfer.failure == TransferFailure::Refused && transfer.result == kUnsupported));
}

} // namespace berg
