#pragma once

#include "core/io/files/run_json.h"
#include "core/link/mission/mission_sync.h"
#include "widgets/flight/export_worker.h"
#include "widgets/flight/flight_rate.h"
#include "widgets/flight/mission_snapshot.h"
#include "widgets/tasks/mailbox.h"

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace berg {

/** Handling of the current flight at a restart. */
struct RestartOptions
{
    bool keepsFlight = false;    ///< stores the present flight, so that it can be restored
    bool restoresFlight = false; ///< restores the stored flight
};

/** A restart of the flight from an earlier instant, to continue differently. */
struct ContinueRequest
{
    double time_s = 0;
    double seenUntil_s = 0; ///< time up to which the requester knew the flight, s
    /** Number of interventions to repeat; nullopt repeats all up to `time_s`. */
    std::optional<std::size_t> interventions;
};

/** The next mission of the worker. */
struct MissionRequest
{
    std::uint64_t generation = 0;
    Scenario scenario;
    MissionOptions options;
    std::shared_ptr<const RunFile> run; ///< recorded run to replay first; null if there is none
    /** Options of the requests that this one replaces, in order, and its own. */
    std::vector<RestartOptions> restarts;
    std::stop_token stop;
};

/** Pose of a real aircraft, for the UAV that stands for it. */
struct LivePose
{
    int uav = 0;        ///< index in the scenario
    double clock_s = 0; ///< clock of the link when it was valid
    DubinsState pose;
    bool isMeasured = true; ///< as in `PoseFix`
};

/** The present plan of a UAV as an upload for its aircraft. */
struct UavMission
{
    std::string uav; ///< id
    std::vector<MissionPart> parts;
    std::vector<std::string> order; ///< `sortieIcebergs` its plan
};

/** Mailboxes between the GUI thread and the mission thread. */
struct MissionChannels
{
    Mailbox<MissionRequest> requests;
    Mailbox<std::vector<Intervention>> interventions;
    Mailbox<MissionSnapshot> snapshots;
    Mailbox<double> instantRequests; ///< times, s
    Mailbox<MissionSnapshot> instants;
    Mailbox<ExportTask> previewRequests;
    Mailbox<std::vector<LivePose>> poses;
};

class MissionWorker;

/** Returns the message for an export whose scenario has been replaced meanwhile. */
[[nodiscard]] QString outdatedExportText();
/** Returns the message for a change after the run has ended. */
[[nodiscard]] QString runEndedText();

/**
 * Plans and flies on its own thread; the GUI thread never waits. Commands return at once, and
 * results are taken from the mailbox when `updated` is emitted. Each scenario has a generation;
 * snapshots of older ones are never returned. GUI thread.
 */
class MissionRunner : public QObject
{
    Q_OBJECT

public:
    explicit MissionRunner(QObject* parent = nullptr);
    /** Stops the current solve or flight and waits for the thread, well under a second. */
    ~MissionRunner() override;

    /** Plans this scenario from its start and ends what was in progress. The newest request wins.
     */
    void setScenario(const Scenario& scenario, const MissionOptions& options = {});
    /** Replays a recorded run as far as it went; `commandRefused` follows if the result differs. */
    void setRun(std::shared_ptr<const RunFile> run);
    [[nodiscard]] std::uint64_t generation() const { return m_generation; }

    void fly(FlightRate rate);
    /**
     * Flies with real aircraft from now on, at their pace: as far as the poses of `addPoses` reach.
     * `clock_s` is the present time of their clock (`LivePose::clock_s`).
     */
    void flyLive(double clock_s);
    /** Adds poses of real aircraft. They have no effect outside a live flight. */
    void addPoses(const std::vector<LivePose>& poses);
    /**
     * Requests the present plans as uploads; `missionsReady` follows unless `begun` comes first. It
     * is empty after `commandRefused`. Solves nothing.
     */
    void requestMissions();
    void pause();
    /** Pauses and advances by `seconds` of simulated time. */
    void stepBy(double seconds);
    /** Returns to the start of the same scenario. With `keepsFlight` the flight can be restored. */
    void restart(bool keepsFlight = false);
    /**
     * Restores the flight stored last, which belongs to this scenario; `keepsFlight` stores the
     * present one in its place.
     */
    void restoreFlight(const Scenario& scenario, bool keepsFlight);
    /**
     * Pauses and returns to an earlier instant of the flight, to continue from there. The later
     * part is discarded and stored, so that it can be restored.
     */
    void continueFrom(const ContinueRequest& request);
    /**
     * Requests the mission's state at `time_s`; `instantUpdated` follows. The newest request wins.
     */
    void requestInstant(double time_s);
    /**
     * Applies the change at the present instant of a flight that has begun; `commandRefused`
     * follows if that is impossible. Of changes that still wait, the newest tau, policy, wind and
     * asset count.
     */
    void intervene(const Intervention& intervention);

    using Predictor = std::function<std::optional<ZetaPrediction>()>;
    /** Sets the function that gives the zeta predicted before take-off; called at each export. */
    void setPredictor(const Predictor& predictor);

    /** Sets the painter of exports, which adds the painted formats. */
    void setExportPaint(const ExportPaint& paint);
    /**
     * Requests the present plan, or in flight the present mission, as files. `exportReady` follows,
     * or `commandRefused`, also if another scenario was set meanwhile. Solves nothing; the mission
     * flies on.
     */
    void requestExport(const ExportRequest& request);
    /** Requests a preview of an export; `exportPreviewReady` follows. The newest request wins. */
    void requestExportPreview(const ExportRequest& request);
    /** Cancels the preview. */
    void cancelExportPreview();

    /**
     * Returns the newest snapshot of the present generation with all samples since the last one, or
     * nullopt if none waits.
     */
    [[nodiscard]] std::optional<MissionSnapshot> acceptSnapshot();

    /** Returns the newest requested instant of the present generation, or nullopt if none waits. */
    [[nodiscard]] std::optional<MissionSnapshot> acceptInstant();

    /**
     * Requests the run so far for saving; `runReady` with the same `path` follows, or
     * `commandRefused` if there is no mission.
     */
    void requestRun(const QString& path = {});
    /** Requests the run so far for a recovery; `recoveryRunReady` follows if there is a mission. */
    void requestRecoveryRun();

signals:
    /** Emitted for a new generation; requests of earlier ones are not answered any more. */
    void begun();
    /** Emitted when a snapshot waits. */
    void updated();
    /** Emitted when an instant waits. */
    void instantUpdated();
    /** Reports why a command failed or was changed. */
    void commandRefused(const QString& message);
    void exportReady(const std::vector<berg::ExportFile>& files);
    void exportPreviewReady(const std::shared_ptr<const berg::ExportPreview>& preview);
    void missionsReady(const std::shared_ptr<const std::vector<berg::UavMission>>& missions);
    void runReady(const QString& path, const std::shared_ptr<const berg::RunFile>& run);
    void recoveryRunReady(const std::shared_ptr<const berg::RunFile>& run);

private:
    void begin(RestartOptions restartOptions = {}, std::shared_ptr<const RunFile> run = {});
    [[nodiscard]] std::optional<MissionSnapshot>
    ifCurrent(std::optional<MissionSnapshot> snapshot) const;
    template <class Command>
    void post(Command command);
    void connectExports();
    [[nodiscard]] ExportTask taskOf(const ExportRequest& request) const;
    template <class Command>
    void postToFlight(Command command);

    MissionChannels m_mail;
    QThread m_thread;
    QThread m_exportThread;
    MissionWorker* m_worker; ///< lives on `m_thread`
    ExportWorker* m_exports; ///< lives on `m_exportThread`
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< stops the present generation
    std::stop_source m_previewStop;
    Predictor m_predictor;
    Scenario m_scenario;
    MissionOptions m_options;
};

} // namespace berg
