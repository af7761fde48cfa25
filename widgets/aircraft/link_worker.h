#pragma once

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
    void updateGhosts(double now_s);
    [[nodiscard]] LinkStatus status() const;

    Mailbox<LinkStatus>& m_statuses;
    LinkClock m_clock;
    QTimer m_timer;
    std::unique_ptr<TransportLink> m_link;
    std::unique_ptr<LinkSession> m_session;
    std::map<LinkAddress, AircraftData> m_data;
    struct Ghost
    {
        GhostAircraft flight;
        double lastPosition_s = 0; ///< of the position from which it was predicted
        std::optional<ExpectedContact> expected;
    };
    std::map<LinkAddress, Ghost> m_ghosts;
    std::map<LinkAddress, std::vector<MissionPart>> m_onBoard;
    TrafficList m_traffic;
    std::vector<TimedLinkEvent> m_events;
    double m_pulse_s = 0;
    double m_nextStatus_s = 0;
};

} // namespace berg
