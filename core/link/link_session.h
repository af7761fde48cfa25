#pragma once

#include "core/link/aircraft_state.h"
#include "core/link/command_queue.h"
#include "core/link/message/frame_exchange.h"
#include "core/link/mission/mission_sync.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Identity and limits of a ground station on a link. */
struct LinkSessionOptions
{
    LinkAddress self{.system = 255, .component = 190};
    std::optional<SigningKey> key;
    ReceiveLimits limits;
    FrameLog log;
};

/** Frames of a sender received and lost, by gaps in their sequence numbers. */
struct SenderLoss
{
    std::uint8_t lastSequence = 0;
    std::uint64_t received = 0;
    std::uint64_t lost = 0; ///< Too high if frames arrive over several radios.
};

/** An autopilot that has been heard. */
struct LinkVehicle
{
    LinkAddress address;
    int peer = 0; ///< Peer of its last frame.
    AutopilotKind autopilot = AutopilotKind::Other;
    int type = 0;     ///< MAV_TYPE of the heartbeat.
    int baseMode = 0; ///< Flags of the heartbeat; 128 is "armed".
    std::uint32_t mode = 0;
    int systemStatus = 0; ///< MAV_STATE; 4 is "active".
    double lastHeartbeat_s = 0;
    double lastHeard_s = 0;
    bool isLost = false;                                     ///< True after 3 s without heartbeat.
    SignatureVerdict signature = SignatureVerdict::Unsigned; ///< Verdict on the last frame.
    SenderLoss loss;
    AircraftState state;
    /** Last upload or comparison; empty before the first and after one that was broken off. */
    std::optional<SyncStatus> sync;
    /** Last time when it was heard to receive a list from another ground station. */
    std::optional<double> othersUpload_s;
};

/** An event on a link. */
struct LinkEvent
{
    enum class Kind
    {
        VehicleAppeared,
        VehicleLost,
        VehicleReturned,
        ModeChanged, ///< `vehicle` has a new mode.
        ItemReached, ///< `value` is the item as numbered on the link.
        Text,        ///< `text` with its severity in `value`, 0 (emergency) to 7.
        CommandEnded,
        SyncEnded,  ///< See the vehicle's `sync`.
        SameIdHeard ///< Another ground station uses the same id; sending is switched off.
    };
    Kind kind = Kind::Text;
    LinkAddress vehicle;
    int value = 0;
    std::string text; ///< Text of the sender: any bytes, which must be shown as text only.
    std::optional<CommandResult> command;
};

/** A position of a vehicle, of which one step may bring several. */
struct VehiclePlace
{
    LinkAddress vehicle;
    LatLon place;
};

/** Result of one step of a session. */
struct LinkUpdate
{
    std::vector<LinkEvent> events;
    /** All frames received, for traffic display and recordings. */
    std::vector<ReceivedFrame> frames;
    std::vector<VehiclePlace> places; ///< every new position of a vehicle, for tracks
};

/**
 * The ground station's end of a link. It discovers vehicles and follows their state. Only while
 * sending is switched on, it sends heartbeats, requests telemetry, sends commands and transfers
 * missions; otherwise not a byte is sent. Commands and transfers are not sent to a vehicle that has
 * been silent for `kPeerKept_s`, so they fail in time. The numbers of vehicles, senders and texts
 * are bounded. Single-threaded. The caller supplies the times. It must stop calling `advance` when
 * planner or window hang, so that they look dead to the vehicles.
 */
class LinkSession
{
public:
    /** `link` must outlive the session. */
    LinkSession(ByteLink& link, LinkSessionOptions options);

    /** Switches sending on or off. A change drops all commands and transfers without an event. */
    void setSending(bool isOn);
    [[nodiscard]] bool isSending() const { return m_isSending; }

    /**
     * Processes received frames and sends what is due. Must be called at least ten times a second.
     */
    [[nodiscard]] LinkUpdate advance(LinkTime now);

    /** Returns the vehicles heard so far, ordered by address. */
    [[nodiscard]] std::vector<LinkVehicle> vehicles() const;
    /**
     * Returns a vehicle, or null if it has not been heard. Valid until the next call of `advance`.
     */
    [[nodiscard]] const LinkVehicle* findVehicle(LinkAddress address) const;
    /** Returns the losses of every sender, by address. */
    [[nodiscard]] const std::map<LinkAddress, SenderLoss>& senders() const { return m_senders; }
    [[nodiscard]] const FrameExchange& exchange() const { return m_exchange; }

    /**
     * Queues a command and returns its number, or nullopt if sending is off, the vehicle is unknown
     * or the command is not permitted.
     */
    std::optional<int> sendCommand(LinkAddress vehicle, const LinkCommand& command);
    /**
     * Starts an upload or comparison. Returns false if sending is off, the vehicle is unknown,
     * there are no parts or one is running. A recheck that is running gives way to any other task.
     */
    bool startSync(LinkAddress vehicle, std::vector<MissionPart> parts, MissionSync::Task task);
    /**
     * Returns the lists read so far by the last upload or comparison; it is empty without one, for
     * an unknown vehicle and after `setSending`.
     */
    [[nodiscard]] std::vector<MissionPart> onBoard(LinkAddress vehicle) const;

private:
    /** A vehicle with its pending commands and transfers. */
    struct Partner
    {
        LinkVehicle vehicle;
        CommandQueue commands;
        std::optional<MissionSync> sync;
        bool isSyncReported = true;
        bool isTelemetryRequested = false; ///< Telemetry was requested since it was (re)discovered.
        std::vector<int> ownCommands;      ///< Numbers of the commands that request telemetry.
        int textId = 0;                    ///< Id of the text that arrives in chunks.
        std::string text;
    };

    void receiveFrame(const ReceivedFrame& received, LinkTime now, LinkUpdate& update);
    void countSequence(const LinkFrame& frame);
    void receiveHeartbeat(const ReceivedFrame& received, LinkTime now, LinkUpdate& update);
    void receiveText(Partner& partner, const LinkMessage& message, LinkUpdate& update);
    void sendDue(Partner& partner, LinkTime now, LinkUpdate& update);
    static void requestTelemetry(Partner& partner);
    void reportCommands(Partner& partner, LinkTime now, LinkUpdate& update);
    [[nodiscard]] bool isForUs(const LinkMessage& message) const;

    FrameExchange m_exchange;
    bool m_isSending = false;
    double m_nextHeartbeat_s = 0;
    std::map<LinkAddress, Partner> m_partners;
    std::map<LinkAddress, SenderLoss> m_senders;
};

} // namespace berg
