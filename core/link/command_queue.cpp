#include "core/link/command_queue.h"

#include "core/base/error.h"
#include "core/link/autopilot_modes.h"

#include <algorithm>
#include <string>
#include <utility>

namespace berg {

namespace {

constexpr int kMostCommandSends = 4;
constexpr double kCommandResend_s = 1;
constexpr double kInProgress_s = 10; ///< A vehicle that executes a command gets more time.
constexpr std::int64_t kResultInProgress = 5;

/** Returns true for modes that neither take off nor land: automatic, circling, home, guided. */
bool isHarmlessMode(const LinkCommand& command, AutopilotKind kind)
{
    if (kind == AutopilotKind::Other)
        return false;
    const AutopilotModes modes = autopilotModes(kind);
    const std::array<std::uint32_t, 4> harmless{modes.mission, modes.home, modes.hold,
                                                modes.guided};
    return std::any_of(harmless.begin(), harmless.end(), [&](std::uint32_t mode) {
        return kind == AutopilotKind::Px4
                   ? command.params[1] == (mode >> 16U & 0xFFU) && command.params[2] == mode >> 24U
                   : command.params[1] == mode;
    });
}

LinkMessage commandMessage(const LinkCommand& command, LinkAddress vehicle, int confirmation)
{
    const bool isInt = command.frame.has_value();
    LinkMessage message(isInt ? MessageId::CommandInt : MessageId::CommandLong);
    message.with("command", command.command)
        .with("target_system", vehicle.system)
        .with("target_component", vehicle.component);
    const std::size_t reals = isInt ? 4 : 7;
    for (std::size_t i = 0; i < reals; ++i)
        message.withReal("param" + std::to_string(i + 1), command.params[i]);
    if (!isInt)
        return message.with("confirmation", confirmation);
    return message.with("frame", static_cast<std::int64_t>(*command.frame))
        .with("x", static_cast<std::int64_t>(command.params[4]))
        .with("y", static_cast<std::int64_t>(command.params[5]))
        .withReal("z", command.params[6]);
}

} // namespace

bool isPermitted(const LinkCommand& command, AutopilotKind kind)
{
    switch (command.command) {
    case LinkCommandId::kSetMode:
        return isHarmlessMode(command, kind);
    case LinkCommandId::kOrbit:
    case LinkCommandId::kChangeSpeed:
    case LinkCommandId::kReposition:
    case LinkCommandId::kPauseContinue:
    case LinkCommandId::kSetCurrentItem:
    case LinkCommandId::kSetMessageInterval:
    case LinkCommandId::kRequestMessage:
        return true;
    default:
        return false;
    }
}

int CommandQueue::add(const LinkCommand& command)
{
    require(isPermitted(command, m_kind), "a command that Bergwatch may send");
    m_pending.push_back({.number = ++m_lastNumber, .command = command});
    return m_lastNumber;
}

std::vector<LinkMessage> CommandQueue::advance(double now_s)
{
    std::vector<LinkMessage> messages;
    std::vector<std::uint16_t> activeKinds;
    for (auto each = m_pending.begin(); each != m_pending.end();) {
        const std::uint16_t kind = each->command.command;
        if (std::find(activeKinds.begin(), activeKinds.end(), kind) != activeKinds.end()) {
            ++each;
            continue;
        }
        if (each->sends == kMostCommandSends && now_s >= each->next_s) {
            m_results.push_back({.number = each->number, .command = each->command});
            each = m_pending.erase(each);
            continue;
        }
        activeKinds.push_back(kind);
        if (each->sends == 0 || now_s >= each->next_s) {
            messages.push_back(commandMessage(each->command, m_vehicle, each->sends));
            ++each->sends;
            each->next_s = now_s + kCommandResend_s;
        }
        ++each;
    }
    return messages;
}

void CommandQueue::receive(const LinkMessage& message, double now_s)
{
    if (message.id() != MessageId::CommandAck)
        return;
    const auto found = std::find_if(m_pending.begin(), m_pending.end(), [&](const Pending& each) {
        return each.command.command == message.integer("command");
    });
    if (found == m_pending.end() || found->sends == 0)
        return;
    if (message.integer("result") == kResultInProgress) {
        found->next_s = now_s + kInProgress_s;
        return;
    }
    m_results.push_back({.number = found->number,
                         .command = found->command,
                         .result = static_cast<int>(message.integer("result"))});
    m_pending.erase(found);
}

std::vector<CommandResult> CommandQueue::takeResults()
{
    return std::exchange(m_results, {});
}

} // namespace berg
