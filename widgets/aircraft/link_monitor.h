#pragma once

#include "widgets/aircraft/link_worker.h"

#include <QObject>
#include <QThread>
#include <QTimer>

#include <vector>

namespace berg {

/**
 * Listens to aircraft on a thread of its own; the GUI thread never waits. Nothing runs before the
 * first call of `listen`. Listening and sending are two choices: nothing is sent while sending is
 * off, and it is off whenever listening begins. GUI thread.
 */
class LinkMonitor : public QObject
{
    Q_OBJECT

public:
    explicit LinkMonitor(QObject* parent = nullptr);
    /** Closes the link and waits for the thread, under a second. */
    ~LinkMonitor() override;

    /** Listens on the link that `opener` makes on the link thread, in place of another. */
    void listen(const LinkOpener& opener);
    /** Plays a telemetry log in place of a link, as if its aircraft were heard now. */
    void replay(const ReplayOrder& order);
    /** Sets the speed of the replay, in seconds of the log in each second. */
    void setReplaySpeed(double speed);
    void stop();
    /** Sets the folder in which telemetry logs are written; empty for none, as at first. */
    void setLogFolder(const QString& folder);
    void setSending(bool isOn);
    /** Starts an upload or comparison, if sending is on and none is running for this vehicle. */
    void startSync(LinkAddress vehicle, const std::vector<MissionPart>& parts,
                   MissionSync::Task task);
    /** Sends a command, if sending is on and it is permitted. */
    void sendCommand(LinkAddress vehicle, const LinkCommand& command);
    /** Sets what predictions need besides telemetry. */
    void setData(const std::map<LinkAddress, AircraftData>& data);

    [[nodiscard]] bool isListening() const { return m_isListening; }
    /** Returns the newest state, with the events since the one before. */
    [[nodiscard]] const LinkStatus& status() const { return m_status; }
    /** Returns the positions of a vehicle since listening began, thinned to 5,000. */
    [[nodiscard]] const std::vector<LatLon>& trackOf(LinkAddress vehicle) const;

signals:
    /** Emitted when `status` has changed. */
    void updated();

private:
    template <class Command>
    void post(Command command);
    void begin();
    void accept();
    void extendTracks();

    Mailbox<LinkStatus> m_statuses;
    QThread m_thread;
    LinkWorker* m_worker; ///< lives on `m_thread`
    QTimer m_pulse;
    bool m_isListening = false;
    LinkStatus m_status;
    std::map<LinkAddress, std::vector<LatLon>> m_tracks;
};

} // namespace berg
