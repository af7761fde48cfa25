#pragma once

#include "core/link/mission/mission_item.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** A message of a vehicle for one receiver, or for all of them if the target is 0, 0. */
struct AddressedMessage
{
    LinkAddress target;
    LinkMessage message;
};

/**
 * The vehicle's side of the mission protocol, with the behaviour of ArduPilot or PX4: type and
 * interval of requests, timeouts, refusals, updates of a part of a list (ArduPilot only), and the
 * result of a broken upload (ArduPilot a mixture, PX4 the old mission). Unlike PX4, its counterpart
 * here turns to the old MISSION_REQUEST when a station does not answer the new one, as MAVProxy
 * does not. Kind Other behaves as ArduPilot. The caller supplies the time.
 */
class VehicleMissions
{
public:
    explicit VehicleMissions(AutopilotKind kind);

    /** Processes a message for this vehicle and returns the answers. */
    [[nodiscard]] std::vector<AddressedMessage> receive(const LinkMessage& message,
                                                        LinkAddress sender, double now_s);
    /** Returns the messages due at this time: repeated requests and the end of a transfer. */
    [[nodiscard]] std::vector<AddressedMessage> advance(double now_s);
    /** Drops the transfer in progress, as a reboot does; the lists stay. */
    void reboot();

    /** Sets ArduPilot's item 0, whatever a ground station has sent for it. */
    void setHome(const LinkMissionItem& home);
    /** Replaces a list by planned items without home, as an upload does. */
    void load(MissionType type, std::span<const LinkMissionItem> items);
    /** Returns a list without home. */
    [[nodiscard]] std::vector<LinkMissionItem> items(MissionType type) const;
    /** Returns the number of changes of a list. */
    [[nodiscard]] int revision(MissionType type) const { return listOf(type).revision; }
    /** Returns PX4's opaque id of a list, or 0 for an empty list and for ArduPilot. */
    [[nodiscard]] std::uint32_t opaqueId(MissionType type) const;

private:
    struct List
    {
        std::vector<LinkMissionItem>
            items; ///< Items as on the link; ArduPilot's missions with home.
        int revision = 0;
    };

    enum class State
    {
        Idle,
        Receiving,
        Sending ///< PX4 only, which tracks the requests of a receiver.
    };

    [[nodiscard]] const List& listOf(MissionType type) const;
    [[nodiscard]] List& listOf(MissionType type);
    [[nodiscard]] bool isArduPilot() const { return m_kind != AutopilotKind::Px4; }
    [[nodiscard]] AddressedMessage ack(LinkAddress target, MissionType type, int result) const;
    [[nodiscard]] AddressedMessage request() const;
    [[nodiscard]] std::vector<AddressedMessage> receiveCount(const LinkMessage& message,
                                                             LinkAddress sender, double now_s);
    [[nodiscard]] std::vector<AddressedMessage>
    receivePartialList(const LinkMessage& message, LinkAddress sender, double now_s);
    /** Begins to receive items `first` to `last` of a list and returns the first request. */
    [[nodiscard]] std::vector<AddressedMessage> beginReceiving(MissionType type, LinkAddress sender,
                                                               int first, int last, double now_s);
    [[nodiscard]] std::vector<AddressedMessage> receiveItem(const LinkMessage& message,
                                                            LinkAddress sender, double now_s);
    [[nodiscard]] std::vector<AddressedMessage> sendCount(MissionType type, LinkAddress receiver,
                                                          double now_s);
    [[nodiscard]] std::vector<AddressedMessage> sendItem(const LinkMessage& message,
                                                         LinkAddress receiver, double now_s);
    [[nodiscard]] std::vector<AddressedMessage> clear(const LinkMessage& message,
                                                      LinkAddress sender);
    void complete();

    AutopilotKind m_kind;
    std::array<List, 3> m_lists;
    LinkMissionItem m_home;
    State m_state = State::Idle;
    LinkAddress m_partner;
    MissionType m_type = MissionType::Mission;
    std::vector<LinkMissionItem> m_incoming; ///< Items of PX4 until all have arrived.
    int m_seq = 0;                           ///< The item that is expected, or asked for, next.
    int m_count = 0;
    double m_lastHeard_s = 0;
    double m_lastRequest_s = 0;
    int m_repeats = 0;         ///< Requests repeated since the last item.
    bool m_asksOldWay = false; ///< PX4's requests are MISSION_REQUEST for the rest of the transfer.
};

} // namespace berg
