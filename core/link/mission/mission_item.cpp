#include "core/link/mission/mission_item.h"

#include <algorithm>
#include <cmath>

namespace berg {

namespace {

constexpr double kDegrees = 1e7; ///< Units per degree.
constexpr float kAltitudeTolerance_m = 0.05F;
constexpr float kParameterTolerance = 0.01F; ///< Relative tolerance.

/** Parameters that a command uses, as bits from the lowest. */
struct UsedParameters
{
    std::uint16_t command;
    unsigned bits;
};

constexpr std::array<UsedParameters, 22> kUsedParameters{{
    {LinkCommandId::kWaypoint, 0b0111},
    {LinkCommandId::kLoiterUnlimited, 0b0100},
    {LinkCommandId::kLoiterTurns, 0b0101},
    {LinkCommandId::kLoiterTime, 0b0101},
    {LinkCommandId::kReturnToLaunch, 0},
    {LinkCommandId::kLand, 0},
    {LinkCommandId::kTakeOff, 0b0001},
    {LinkCommandId::kLoiterToAltitude, 0b0010},
    {LinkCommandId::kVtolTakeOff, 0},
    {LinkCommandId::kVtolLand, 0},
    {LinkCommandId::kJump, 0b0011},
    {LinkCommandId::kChangeSpeed, 0b0011},
    {LinkCommandId::kLandStart, 0},
    {LinkCommandId::kMountControl, 0b0111},
    {LinkCommandId::kTriggerDistance, 0b0001},
    {LinkCommandId::kStartCapture, 0b0010},
    {LinkCommandId::kStopCapture, 0},
    {LinkCommandId::kFenceInside, 0b0001}, // number of corners
    {LinkCommandId::kFenceOutside, 0b0001},
    {5003, 0b0001}, // radius of a circle
    {5004, 0b0001},
    {LinkCommandId::kRally, 0},
}};

/** Returns the bits of the parameters to compare, all of them for an unknown command. */
unsigned usedParameters(std::uint16_t command)
{
    const auto row =
        std::find_if(kUsedParameters.begin(), kUsedParameters.end(),
                     [&](const UsedParameters& each) { return each.command == command; });
    return row != kUsedParameters.end() ? row->bits : 0b1111U;
}

/** Returns the present value for a frame with an old name. */
std::uint8_t plainFrame(std::uint8_t frame)
{
    switch (frame) {
    case 5:
        return static_cast<std::uint8_t>(ItemFrame::Global);
    case 6:
        return static_cast<std::uint8_t>(ItemFrame::AboveHome);
    case 11:
        return static_cast<std::uint8_t>(ItemFrame::AboveTerrain);
    default:
        return frame;
    }
}

bool hasPosition(const LinkMissionItem& item)
{
    return item.frame != static_cast<std::uint8_t>(ItemFrame::NoPosition) &&
           item.command != LinkCommandId::kReturnToLaunch;
}

/** Compares a parameter. Some vehicles store the default (NaN) as 0. */
bool isSameParameter(float planned, float onBoard)
{
    const float a = std::isnan(planned) ? 0 : planned;
    const float b = std::isnan(onBoard) ? 0 : onBoard;
    return std::abs(a - b) <= kParameterTolerance * std::abs(a);
}

bool isHomeAdded(MissionType type, AutopilotKind kind)
{
    return type == MissionType::Mission && kind == AutopilotKind::ArduPilot;
}

void moveJumps(std::span<LinkMissionItem> items, float by)
{
    for (LinkMissionItem& item : items)
        if (item.command == LinkCommandId::kJump)
            item.params[0] += by;
}

} // namespace

AutopilotKind autopilotKind(std::int64_t mavAutopilot)
{
    switch (mavAutopilot) {
    case 3:
        return AutopilotKind::ArduPilot;
    case 12:
        return AutopilotKind::Px4;
    default:
        return AutopilotKind::Other;
    }
}

LinkMessage itemMessage(const LinkMissionItem& item, const ItemAddress& address)
{
    LinkMessage message(MessageId::MissionItemInt);
    message.with("target_system", address.target.system)
        .with("target_component", address.target.component)
        .with("seq", address.seq)
        .with("frame", item.frame)
        .with("command", item.command)
        .with("current", address.isCurrent ? 1 : 0)
        .with("autocontinue", 1)
        .with("x", item.x)
        .with("y", item.y)
        .withReal("z", static_cast<double>(item.z))
        .with("mission_type", static_cast<std::int64_t>(address.type));
    for (std::size_t i = 0; i < item.params.size(); ++i)
        message.withReal("param" + std::to_string(i + 1), static_cast<double>(item.params[i]));
    return message;
}

LinkMissionItem itemOf(const LinkMessage& message)
{
    LinkMissionItem item;
    item.command = static_cast<std::uint16_t>(message.integer("command"));
    item.frame = static_cast<std::uint8_t>(message.integer("frame"));
    for (std::size_t i = 0; i < item.params.size(); ++i)
        item.params[i] = static_cast<float>(message.real("param" + std::to_string(i + 1)));
    item.z = static_cast<float>(message.real("z"));
    if (message.id() == MessageId::MissionItemInt) {
        item.x = static_cast<std::int32_t>(message.integer("x"));
        item.y = static_cast<std::int32_t>(message.integer("y"));
        return item;
    }
    const double scale = hasPosition(item) ? kDegrees : 1;
    const auto whole = [&](const char* field) {
        const double value = scale * message.real(field);
        return std::abs(value) < 2'000'000'000 ? static_cast<std::int32_t>(std::lround(value)) : 0;
    };
    item.x = whole("x");
    item.y = whole("y");
    return item;
}

std::vector<LinkMissionItem> itemsToSend(std::span<const LinkMissionItem> items, MissionType type,
                                         AutopilotKind kind)
{
    std::vector<LinkMissionItem> sent(items.begin(), items.end());
    if (isHomeAdded(type, kind) && !sent.empty()) {
        moveJumps(sent, 1);
        LinkMissionItem home{.frame = static_cast<std::uint8_t>(ItemFrame::Global)};
        home.params[3] = 0;
        sent.insert(sent.begin(), home);
    }
    return sent;
}

std::vector<LinkMissionItem> itemsReadBack(std::span<const LinkMissionItem> items, MissionType type,
                                           AutopilotKind kind)
{
    std::vector<LinkMissionItem> read(items.begin(), items.end());
    if (isHomeAdded(type, kind) && !read.empty()) {
        read.erase(read.begin());
        moveJumps(read, -1);
    }
    return read;
}

std::vector<ItemDifference> missionDifferences(std::span<const LinkMissionItem> planned,
                                               std::span<const LinkMissionItem> onBoard)
{
    std::vector<ItemDifference> differences;
    if (planned.size() != onBoard.size())
        differences.push_back({.field = "count"});
    for (std::size_t i = 0; i < std::min(planned.size(), onBoard.size()); ++i) {
        const LinkMissionItem& plan = planned[i];
        const LinkMissionItem& board = onBoard[i];
        const auto compare = [&](bool isSame, const std::string& field) {
            if (!isSame)
                differences.push_back({.index = static_cast<int>(i), .field = field});
        };
        compare(plan.command == board.command, "command");
        if (hasPosition(plan)) {
            compare(plainFrame(plan.frame) == plainFrame(board.frame), "frame");
            compare(plan.x == board.x, "x");
            compare(plan.y == board.y, "y");
            compare(std::abs(plan.z - board.z) <= kAltitudeTolerance_m, "z");
        }
        const unsigned used = usedParameters(plan.command);
        for (std::size_t p = 0; p < plan.params.size(); ++p)
            if ((used >> p & 1U) != 0)
                compare(isSameParameter(plan.params[p], board.params[p]),
                        "param" + std::to_string(p + 1));
    }
    return differences;
}

} // namespace berg
