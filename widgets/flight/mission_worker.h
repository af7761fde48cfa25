#pragma once

#include "widgets/flight/export_worker.h"
#include "widgets/flight/mission_runner.h"
#include "widgets/tasks/work_failure.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace berg {

/**
 * The mission thread's side of `MissionRunner`: owns the mission and flies it in short slices. Its
 * commands do what those of the same name there do; without a mission they have no effect.
 */
class MissionWorker : public QObject
{
    Q_OBJECT

public:
    /** Borrows the channels. */
    explicit MissionWorker(MissionChannels& mail);

    /**
     * Runs `work`; an exception fails the mission instead of ending the program. Every entry point
     * of the thread uses it.
     */
    template <class Work>
    void runGuarded(const Work& work)
    {
        if (const auto failure = failureOf(work))
            fail(*failure);
    }

    /** Takes the newest request, if one waits, and plans it. */
    void start();
    /** Returns the generation of the last request taken. */
    [[nodiscard]] std::uint64_t generation() const { return m_request.generation; }
    void fly(FlightRate rate);
    void flyLive(double clock_s);
    /** Takes the waiting poses; a live flight continues up to them. */
    void addPoses();
    void sendMissions();
    void pause();
    void stepBy(double seconds);
    /** Applies the waiting interventions at the present instant. */
    void intervene();
    /** Replays the flight up to that time and pauses there. */
    void continueFrom(const ContinueRequest& request);
    void sendInstant();
    void sendRun(const QString& path);
    void sendRecoveryRun();
    void setExportPaint(const ExportPaint& paint) { m_paint = paint; }
    void sendExport(const ExportTask& task);
    void sendExportPreview();

signals:
    void published();
    void instantPublished();
    void refused(const QString& message);
    /** Emitted when an export is prepared; another thread completes it. */
    void exportPrepared(const std::shared_ptr<const berg::ExportJob>& job);
    void previewPrepared(const std::shared_ptr<const berg::ExportJob>& job);
    void previewRefused(const std::shared_ptr<const berg::ExportPreview>& preview,
                        quint64 generation);
    void missionsReady(const std::shared_ptr<const std::vector<berg::UavMission>>& missions,
                       quint64 generation);
    void runReady(const QString& path, const std::shared_ptr<const berg::RunFile>& run);
    void recoveryRunReady(const std::shared_ptr<const berg::RunFile>& run);

private:
    /** A mission and its phase. */
    struct Flight
    {
        std::unique_ptr<Mission> mission;
        RunPhase phase = RunPhase::Planning;
    };
    /**
     * Returns the flight that replaces `present`; one without mission means that the scenario of
     * the request is planned.
     */
    [[nodiscard]] Flight nextFlight(Flight present, const RestartOptions& restartOptions);
    void resume(Flight flight);
    void slice();
    void sliceLive();
    void sliceAsFastAsPossible();
    /** Advances and updates the phase; returns false if the run has ended or was stopped. */
    bool advanceTo(double until_s);
    void fail(const WorkFailure& failure);
    [[nodiscard]] MissionSnapshot present();
    void publish();
    void publishIncumbent(PlanPointer plan);
    void replayRun(const RunFile& run);
    void listenToIncumbents();
    [[nodiscard]] HistoryUpdate takeNewRecords();
    /** Prepares an export of the present mission. Throws `Error` if it has no plan. */
    [[nodiscard]] std::shared_ptr<const ExportJob> prepared(const ExportTask& task) const;

    MissionChannels& m_mail;
    MissionRequest m_request;
    std::unique_ptr<Mission> m_mission;
    Flight m_discarded; ///< flight discarded last; may have no mission
    ExportPaint m_paint;
    std::optional<Error> m_error;
    RunPhase m_phase = RunPhase::Planning;
    /** Whether this generation continues from the flight then put into `m_discarded`. */
    bool m_hasContinued = false;
    std::optional<double> m_liveZero_s; ///< clock at run time 0 in a live flight
    QTimer m_timer;
    QElapsedTimer m_clock;
    FlightRate m_rate = 1;
    double m_target_s = 0;     ///< simulated time that is due by the wall clock, s
    HistoryUpdate m_published; ///< number of records already sent; its part stays empty
};

} // namespace berg
