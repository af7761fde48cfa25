#pragma once

#include "core/link/logs/log_replay.h"
#include "core/link/tracker_list.h"
#include "core/link/transport/link_clock.h"
#include "widgets/aircraft/link_status.h"
#include "widgets/tasks/mailbox.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace berg {

/** Opens a link on the thread that uses it. */
using LinkOpener = std::function<std::unique_ptr<TransportLink>()>;

/** Returns the present time; tests have a clock of their own. */
using LinkClock = std::function<LinkTime()>;

/** A telemetry log to play. */
struct ReplayOrder
{
    std::shared_ptr<LogReplay> log;
    std::string path;
    double speed = 1; ///< seconds of the log in each second
};

/**
 * The link thread's side of `LinkMonitor`. It listens with a `LinkSession`, predicts the flight of
 * aircraft that are silent, and publishes its state ten times a second.
 */
class LinkWorker : public QObject
{
    Q_OBJECT

public:
    /** Borrows the mailbox. */
    explicit LinkWorker(Mailbox<LinkStatus>& statuses, LinkClock clock = linkTimeNow);

    void open(const LinkOpener& opener);
    /** Plays a log in place of a link; nothing can be sent. */
    void replay(const ReplayOrder& order);
    void setReplaySpeed(double speed) { m_replay.speed = speed; }
    /** Sets the folder for logs of links opened from now on, and of this one; empty for none. */
    void setLogFolder(const QString& folder);
    void close();
    void setSending(bool isOn);
    void startSync(LinkAddress vehicle, const std::vector<MissionPart>& parts,
                   MissionSync::Task task);
    void sendCommand(LinkAddress vehicle, const LinkCommand& command);
    void setData(const std::map<LinkAddress, AircraftData>& data) { m_data = data; }
    /** The window is alive. Without this for 3 s, nothing is sent or received. */
    void pulse();
    /** Processes what has arrived and publishes the state when that is due. A timer calls it. */
    void advance();

signals:
    void published();

private:
    void begin(ByteLink& link, ReceiveLimits limits, LinkAddress self);
    void advanceReplay();
    void receiveUntil(LinkTime now);
    void keepOnBoard(LinkAddress vehicle);
    void publish();
    void log(LinkTime now, std::span<const std::uint8_t> frame);
    [[nodiscard]] LinkTime now() const { return m_replay.log ? m_replay.log->time() : m_clock(); }
    [[nodiscard]] std::vector<LinkVehicle> vehicles() const;
    void updateGhosts(double now_s);
    void predictContact();
    [[nodiscard]] LinkStatus status() const;

    Mailbox<LinkStatus>& m_statuses;
    LinkClock m_clock;
    QTimer m_timer;
    std::unique_ptr<TransportLink> m_link;
    ReplayOrder m_replay; ///< without a log on a live link
    std::unique_ptr<TrackerLink> m_received;
    std::unique_ptr<LinkSession> m_session;
    TrackerList m_trackers;
    QString m_logFolder;
    std::unique_ptr<LinkLog> m_log;
    std::map<LinkAddress, AircraftData> m_data;
    struct Ghost
    {
        GhostAircraft flight;
        double lastPosition_s = 0; ///< of the position from which it was predicted
        bool isPredicted = false;  ///< `expected` was looked for
        std::optional<ExpectedContact> expected;
    };
    std::map<LinkAddress, Ghost> m_ghosts;
    std::map<LinkAddress, std::vector<MissionPart>> m_onBoard;
    TrafficList m_traffic;
    std::vector<TimedLinkEvent> m_events;
    std::map<LinkAddress, std::vector<LatLon>> m_places;
    double m_pulse_s = 0;
    double m_nextStatus_s = 0; ///< by the clock
    double m_advanced_s = 0;   ///< by the clock: last step of the replay
};

} // namespace berg
