#pragma once

#include "core/earth/geodesy.h"
#include "core/link/message/frame_exchange.h"
#include "core/link/mission/vehicle_missions.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace berg {

/** Measurements and status of a vehicle. Angles in radians, clockwise from north. */
struct VehicleReadings
{
    LatLon place;
    double altitude_m = 0; ///< Above mean sea level.
    LatLon home;
    double homeAltitude_m = 0; ///< Above mean sea level.
    double north_mps = 0;      ///< Over ground.
    double east_mps = 0;
    double down_mps = 0;
    double roll_rad = 0;
    double pitch_rad = 0;
    double heading_rad = 0;
    double airspeed_mps = 0;
    double windNorth_mps = 0; ///< Velocity of the air.
    double windEast_mps = 0;
    double battery = 1; ///< Remaining charge, 0 to 1.
    double voltage_v = 25;
    double current_a = 0;
    std::optional<double> timeRemaining_s; ///< Nullopt if unknown.
    std::uint32_t mode = 0;                ///< custom_mode of this autopilot's HEARTBEAT.
    bool isArmed = false;
    bool isFlying = false;
    int item = 0; ///< Present item, from 0, without home.
};

/** A request of a ground station to a vehicle. */
struct VehicleOrder
{
    enum class Kind
    {
        SetMode,     ///< Uses `mode`.
        SetItem,     ///< Uses `item`, from 0, without home.
        Reposition,  ///< Uses `place`, `altitude_m` above `frame`, and `radius_m` if not 0.
        ChangeSpeed, ///< Uses `speed_mps`.
        MissionChanged
    };
    Kind kind = Kind::SetMode;
    std::uint32_t mode = 0;
    int item = 0;
    LatLon place;
    double altitude_m = 0;
    ItemFrame frame = ItemFrame::AboveHome;
    double radius_m = 0;
    double speed_mps = 0;
};

/** Identity and behaviour of a vehicle. */
struct VehicleSideOptions
{
    LinkAddress self{.system = 1, .component = 1};
    AutopilotKind autopilot = AutopilotKind::ArduPilot;
    std::uint8_t type = 1; ///< MAV_TYPE; 1 is a fixed wing.
    std::optional<SigningKey> key;
    /** Reported on request; never changed. */
    std::vector<std::pair<std::string, double>> parameters;
    FrameLog log;             ///< May be empty.
    bool logsReceived = true; ///< False if another vehicle on the same link logs these frames.
};

/**
 * The vehicle's end of a link: heartbeats, requested telemetry, the mission protocol and commands,
 * with the behaviour of ArduPilot or PX4. It does not simulate flight: the caller passes readings
 * in and carries out the orders returned. No command makes it arm, take off or land.
 * Single-threaded; the caller supplies the time.
 */
class VehicleSide
{
public:
    /** `link` must outlive the vehicle's side. */
    VehicleSide(ByteLink& link, VehicleSideOptions options);

    /** Answers received messages, sends what is due and returns the orders received. */
    [[nodiscard]] std::vector<VehicleOrder> advance(LinkTime now, const VehicleReadings& readings);

    /** Reports that an item was reached (from 0, without home). */
    void reportReached(int item, LinkTime now);
    /** Sends a text, cut to 50 bytes; severity 0 (emergency) to 7 (debug). */
    void reportText(int severity, const std::string& text, LinkTime now);
    /**
     * Switches off for `off_s` seconds: messages in that time are lost, transfers and streams are
     * dropped.
     */
    void reboot(LinkTime now, double off_s);

    [[nodiscard]] const VehicleMissions& missions() const { return m_missions; }
    /** Puts a list on board without a link. */
    void load(MissionType type, std::span<const LinkMissionItem> items)
    {
        m_missions.load(type, items);
    }

private:
    struct Stream
    {
        double interval_s = 0;
        double next_s = 0;
    };

    void answer(const ReceivedFrame& received, LinkTime now, const VehicleReadings& readings,
                std::vector<VehicleOrder>& orders);
    [[nodiscard]] int execute(const LinkMessage& command, int peer, LinkTime now,
                              const VehicleReadings& readings, std::vector<VehicleOrder>& orders);
    /** Each of these four executes a command of a station and returns its MAV_RESULT. */
    [[nodiscard]] int setMode(int baseMode, std::uint32_t mode,
                              std::vector<VehicleOrder>& orders) const;
    [[nodiscard]] int setItem(std::int64_t seq, LinkTime now, const VehicleReadings& readings,
                              std::vector<VehicleOrder>& orders);
    [[nodiscard]] int reposition(const LinkMessage& command, const VehicleReadings& readings,
                                 std::vector<VehicleOrder>& orders) const;
    [[nodiscard]] int setMessageInterval(MessageId id, double interval_us, double now_s);
    /** Flies to a MISSION_ITEM with `current` 2, ArduPilot's older command of guided flight. */
    void answerGuidedItem(const ReceivedFrame& received, LinkTime now,
                          const VehicleReadings& readings, std::vector<VehicleOrder>& orders);
    void setInterval(MessageId id, double interval_s, double now_s);
    void setDefaultStreams(double now_s);
    void answerDataStream(const LinkMessage& request, double now_s);
    void answerParameters(const LinkMessage& request, int peer, LinkTime now);
    void sendAddressed(const std::vector<AddressedMessage>& messages, int peer, LinkTime now);
    [[nodiscard]] std::optional<LinkMessage> telemetry(MessageId id, LinkTime now,
                                                       const VehicleReadings& readings) const;
    /** Returns the offset of item numbers on the link: 1 for ArduPilot's home, else 0. */
    [[nodiscard]] int itemOffset() const;

    FrameExchange m_exchange;
    VehicleSideOptions m_options;
    VehicleMissions m_missions;
    std::map<MessageId, Stream> m_streams;
    std::map<LinkAddress, int> m_peerOf; ///< Peers of ground stations, bounded.
    double m_nextHeartbeat_s = 0;
    double m_bootedAt_s = 0;
    std::optional<double> m_offUntil_s;
    bool m_hasStarted = false;
};

} // namespace berg
