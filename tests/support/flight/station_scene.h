#pragma once

// A vehicle's side and a ground station that sends what MAVProxy and programs made with pymavlink
// send, in their order and with their addresses.

#include "tests/support/flight/link_scene.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

namespace berg::test {

inline constexpr LinkAddress kMavproxy{.system = 255, .component = 230};
/** MAVProxy addresses component 0 until the user names another. */
inline constexpr LinkAddress kTarget{.system = 1, .component = 0};

inline LinkMessage toVehicle(MessageId id, LinkAddress target = kTarget)
{
    return LinkMessage(id)
        .with("target_system", target.system)
        .with("target_component", target.component);
}

inline LinkMessage commandLong(std::uint16_t command, std::array<double, 7> params = {})
{
    LinkMessage message = toVehicle(MessageId::CommandLong);
    message.with("command", command);
    for (std::size_t i = 0; i < params.size(); ++i)
        message.withReal("param" + std::to_string(i + 1), params[i]);
    return message;
}

/** Returns a frame of MAVLink 1: the base fields at full length. */
inline std::vector<std::uint8_t> oldFrame(const LinkMessage& message, LinkAddress sender)
{
    const std::size_t length = message.spec().baseLength;
    std::vector<std::uint8_t> bytes{0xFE,
                                    static_cast<std::uint8_t>(length),
                                    0,
                                    sender.system,
                                    sender.component,
                                    static_cast<std::uint8_t>(message.spec().id)};
    const std::span<const std::uint8_t> payload = message.payload().first(length);
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    std::uint16_t crc = linkChecksum(std::span(bytes).subspan(1));
    const std::uint8_t extra = message.spec().crcExtra;
    crc = linkChecksum(std::span(&extra, 1), crc);
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFFU));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8U));
    return bytes;
}

/** A vehicle and a ground station that is driven by hand; time passes in steps of 50 ms. */
struct StationScene
{
    explicit StationScene(AutopilotKind kind, LinkAddress station = kMavproxy)
        : link(hub.addPeer())
        , writer(station)
        , vehicle(hub, {.autopilot = kind,
                        .parameters = {{"SYSID_THISMAV", 1}, {"WP_RADIUS", 50}, {"FENCE", 0}}})
    {
        run(1);
    }

    void send(const LinkMessage& message) { link->send(0, writer.write(message, 0)); }

    /** Lets time pass; `react` receives every message of the vehicle. */
    void run(
        double duration_s,
        const std::function<void(const LinkMessage&)>& react = [](const auto&) {})
    {
        for (const double end_s = time_s + duration_s; time_s < end_s;) {
            time_s += 0.05;
            for (const VehicleOrder& order : vehicle.advance(linkTime(time_s), readings)) {
                if (order.kind == VehicleOrder::Kind::SetMode)
                    readings.mode = order.mode;
                orders.push_back(order);
            }
            while (const std::optional<LinkPacket> packet = link->receive())
                for (const LinkFrame& frame : parser.feedDatagram(packet->bytes)) {
                    heard.push_back(*frame.message);
                    react(*frame.message);
                }
        }
    }

    /** Sends a message and returns the answers of half a second. */
    std::vector<LinkMessage> answers(const LinkMessage& message)
    {
        heard.clear();
        send(message);
        run(0.5);
        return heard;
    }

    /** Returns the first answer of a kind, or a message of zeros of another kind. */
    LinkMessage answer(const LinkMessage& message, MessageId id)
    {
        for (const LinkMessage& each : answers(message))
            if (each.id() == id)
                return each;
        return LinkMessage(id == MessageId::Ping ? MessageId::Heartbeat : MessageId::Ping);
    }

    /** Returns the result of a command, or -1 without an answer. */
    int result(const LinkMessage& command)
    {
        for (const LinkMessage& each : answers(command))
            if (each.id() == MessageId::CommandAck &&
                (!command.has("command") || each.integer("command") == command.integer("command")))
                return static_cast<int>(each.integer("result"));
        return -1;
    }

    /**
     * Reads a list as MAVProxy does: with five requests under way, and without an acknowledgement
     * at the end. Returns the items in order of their numbers.
     */
    std::vector<LinkMissionItem> list(MissionType type)
    {
        std::map<int, LinkMissionItem> items;
        int expected = -1;
        std::set<int> requested;
        const auto request = [&] {
            const int next = static_cast<int>(items.size());
            for (int seq = next; seq < std::min(next + 5, expected); ++seq)
                if (requested.insert(seq).second)
                    send(toVehicle(MessageId::MissionRequestInt)
                             .with("seq", seq)
                             .with("mission_type", static_cast<int>(type)));
        };
        send(toVehicle(MessageId::MissionRequestList).with("mission_type", static_cast<int>(type)));
        run(5, [&](const LinkMessage& message) {
            if (message.has("mission_type") &&
                message.integer("mission_type") != static_cast<int>(type))
                return;
            if (message.id() == MessageId::MissionCount)
                expected = static_cast<int>(message.integer("count"));
            else if (message.id() == MessageId::MissionItemInt)
                items[static_cast<int>(message.integer("seq"))] = itemOf(message);
            else
                return;
            request();
        });
        std::vector<LinkMissionItem> read;
        for (const auto& [seq, item] : items)
            read.push_back(item);
        return expected == static_cast<int>(read.size()) ? read : std::vector<LinkMissionItem>(99);
    }

    /**
     * Writes a list as MAVProxy does: `begin` is sent once, and only MISSION_REQUEST is answered.
     * Returns the result of the last MISSION_ACK, or -1 without one.
     */
    int load(const LinkMessage& begin, const std::vector<LinkMissionItem>& items)
    {
        const auto type = static_cast<MissionType>(begin.integer("mission_type"));
        int acknowledged = -1;
        send(begin);
        run(20, [&](const LinkMessage& message) {
            if (message.id() == MessageId::MissionAck)
                acknowledged = static_cast<int>(message.integer("type"));
            if (message.id() != MessageId::MissionRequest ||
                message.integer("target_system") != kMavproxy.system ||
                message.integer("target_component") != kMavproxy.component ||
                message.integer("mission_type") != static_cast<int>(type))
                return;
            const int seq = static_cast<int>(message.integer("seq"));
            if (seq < static_cast<int>(items.size()))
                send(itemMessage(items[static_cast<std::size_t>(seq)],
                                 {.target = kTarget, .type = type, .seq = seq}));
        });
        return acknowledged;
    }

    int load(MissionType type, const std::vector<LinkMissionItem>& items)
    {
        return load(toVehicle(MessageId::MissionCount)
                        .with("count", static_cast<int>(items.size()))
                        .with("mission_type", static_cast<int>(type)),
                    items);
    }

    double time_s = 0;
    VehicleReadings readings = flyingReadings();
    HubLink hub;
    std::unique_ptr<MemoryLink> link;
    FrameWriter writer;
    FrameParser parser;
    VehicleSide vehicle;
    std::vector<VehicleOrder> orders;
    std::vector<LinkMessage> heard;
};

} // namespace berg::test
