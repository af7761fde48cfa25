#pragma once

#include "widgets/model/export_worker.h"
#include "widgets/model/mission_runner.h"
#include "widgets/model/work_failure.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace berg {

/** The mission thread's side of `MissionRunner`: owns the mission, flies it in short slices. */
class MissionWorker : public QObject
{
    Q_OBJECT

public:
    /** The mail is borrowed. */
    explicit MissionWorker(MissionMail& mail);

    /** Everything is done through this: what it throws fails the mission, not the program. */
    template <class Work>
    void guarded(const Work& work)
    {
        if (const auto failure = failureOf(work))
            fail(*failure);
    }

    /** Takes the newest request, if one waits, and plans it. */
    void start();
    /** Of the request taken last. */
    [[nodiscard]] std::uint64_t generation() const { return m_request.generation; }
    void fly(double rate);
    void pause();
    void stepBy(double seconds);
    /** Applies the interventions that wait, here and now. */
    void intervene();
    /** Flies the same way again until that time, and pauses there. */
    void flyOnFrom(const FlyOn& request);
    void sendInstant();
    void sendRun(const QString& path);
    void sendNote();
    void setExportPaint(const ExportPaint& paint) { m_paint = paint; }
    void sendExport(const ExportOrder& order);
    void sendExportPreview();

signals:
    void published();
    void instantPublished();
    void refused(const QString& message);
    /** What is left of an export is not this thread's business. */
    void exportPrepared(const std::shared_ptr<const berg::ExportJob>& job);
    void previewPrepared(const std::shared_ptr<const berg::ExportJob>& job);
    void previewRefused(const std::shared_ptr<const berg::ExportPreview>& preview,
                        quint64 generation);
    void runReady(const QString& path, const std::shared_ptr<const berg::RunFile>& run);
    void runNoted(const std::shared_ptr<const berg::RunFile>& run);

private:
    /** A mission and how far it is. */
    struct Flight
    {
        std::unique_ptr<Mission> mission;
        RunPhase phase = RunPhase::Planning;
    };
    /** What is flown on after this; no mission: the request's scenario is planned. */
    [[nodiscard]] Flight handedOver(Flight present, const FlightHandover& handover);
    void takeUp(Flight flight);
    void slice();
    void sliceAsFastAsPossible();
    /** Advances and keeps the phase; false when there is nothing more to fly. */
    bool advanceTo(double until_s);
    void fail(const WorkFailure& failure);
    [[nodiscard]] MissionSnapshot present();
    void publish();
    void publishIncumbent(const PlanEvent& plan);
    void flyAgain(const RunFile& run);
    void listenToIncumbents();
    [[nodiscard]] HistoryUpdate takeUpdate();
    /** Of the mission there is. Throws `Error` where it has no plan. */
    [[nodiscard]] std::shared_ptr<const ExportJob> prepared(const ExportOrder& order) const;

    MissionMail& m_mail;
    MissionRequest m_request;
    std::unique_ptr<Mission> m_mission;
    Flight m_givenUp; ///< the last one; no mission: none
    ExportPaint m_paint;
    std::optional<Error> m_error;
    RunPhase m_phase = RunPhase::Planning;
    bool m_hasFlownOn = false; ///< from what `m_givenUp` was then, in this generation
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_rate = 1;
    double m_target_s = 0;               ///< simulated time that the wall clock asks for
    std::vector<PlanEvent> m_incumbents; ///< of one solve so far, by UAV
    HistoryUpdate m_published;           ///< how much of each was sent; nothing in it
};

} // namespace berg
