#pragma once

#include "core/link/mission/mission_item.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** A command to a vehicle, as carried by COMMAND_LONG or COMMAND_INT. */
struct LinkCommand
{
    std::uint16_t command = 0; ///< MAV_CMD.
    /** Parameters. If the command has a position, the fifth and sixth are in 1e-7 degrees. */
    std::array<double, 7> params{};
    std::optional<ItemFrame> frame; ///< Set if the command has a position (COMMAND_INT).
};

/**
 * Returns true if Bergwatch may send the command: a request for messages, a speed, an item, a
 * target position, an orbit, pause or continue, or one of the modes automatic, circling, guided
 * (ArduPilot only) and return. Bergwatch never arms, takes off, lands, changes parameters or
 * terminates. No mode is permitted for an autopilot of kind Other.
 */
[[nodiscard]] bool isPermitted(const LinkCommand& command, AutopilotKind kind);

/** Result of a command. */
struct CommandResult
{
    int number = 0; ///< The number returned by `CommandQueue::add`.
    LinkCommand command;
    std::optional<int> result; ///< MAV_RESULT, 0 for accepted; nullopt without an answer.
};

/**
 * Sends commands to one vehicle and waits for their acknowledgements. Each is sent up to four
 * times, a second apart; "in progress" postpones the next send by 10 s. Commands of one kind wait
 * for each other, because an acknowledgement names only the kind.
 */
class CommandQueue
{
public:
    CommandQueue(LinkAddress vehicle, AutopilotKind kind) : m_vehicle(vehicle), m_kind(kind) {}

    /**
     * Queues a command and returns its number. Throws `std::logic_error` if it is not permitted.
     */
    int add(const LinkCommand& command);
    /** Returns the messages due at this time. */
    [[nodiscard]] std::vector<LinkMessage> advance(double now_s);
    /** Processes a COMMAND_ACK of the vehicle; other messages are ignored. */
    void receive(const LinkMessage& message, double now_s);
    /** Returns and clears the results of commands that have ended. */
    [[nodiscard]] std::vector<CommandResult> takeResults();

private:
    struct Pending
    {
        int number = 0;
        LinkCommand command;
        int sends = 0;
        double next_s = 0;
    };

    LinkAddress m_vehicle;
    AutopilotKind m_kind;
    std::vector<Pending> m_pending; ///< The first of each kind is being sent.
    std::vector<CommandResult> m_results;
    int m_lastNumber = 0;
};

} // namespace berg
