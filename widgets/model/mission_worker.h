#pragma once

#include "widgets/model/mission_runner.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace berg {

/** The mission thread's side of `MissionRunner`: owns the mission, flies it in short slices. */
class MissionWorker : public QObject
{
    Q_OBJECT

public:
    MissionWorker(Mailbox<MissionRequest>& requests,
                  Mailbox<std::vector<Intervention>>& interventions,
                  Mailbox<MissionSnapshot>& snapshots);

    /** Takes the newest request, if one waits, and plans it. */
    void start();
    void fly(double rate);
    void pause();
    void stepBy(double seconds);
    /** Applies the interventions that wait, here and now. */
    void intervene();
    void sendRun();
    void sendExport(const std::string& formatId);

signals:
    void published();
    void refused(const QString& message);
    void exportReady(const std::string& content);
    void runReady(const std::shared_ptr<const berg::RunFile>& run);

private:
    void slice();
    void sliceAsFastAsPossible();
    /** Advances and keeps the phase; false when there is nothing more to fly. */
    bool advanceTo(double until_s);
    void fail(const Error& error);
    [[nodiscard]] MissionSnapshot present();
    void publish();
    void publishIncumbent(const PlanEvent& plan);
    void addHistory(MissionSnapshot& snapshot);

    Mailbox<MissionRequest>& m_requests;
    Mailbox<std::vector<Intervention>>& m_interventions;
    Mailbox<MissionSnapshot>& m_snapshots;
    MissionRequest m_request;
    std::unique_ptr<Mission> m_mission;
    std::optional<Error> m_error;
    RunPhase m_phase = RunPhase::Planning;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_rate = 1;
    double m_target_s = 0;       ///< simulated time that the wall clock asks for
    std::size_t m_published = 0; ///< samples already sent
};

} // namespace berg
