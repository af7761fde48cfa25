#pragma once

#include "core/io/run_json.h"
#include "core/sim/mission.h"
#include "widgets/model/mailbox.h"

#include <QObject>
#include <QThread>

#include <memory>

namespace berg {

enum class RunPhase
{
    Planning, ///< a plan from the start is being made
    Ready,    ///< planned, at time 0
    Flying,
    Paused,
    Finished,
    Failed ///< the scenario cannot be planned or flown: `error`
};

/** What the mission looks like at one instant, for drawing. Immutable once published. */
struct MissionSnapshot
{
    std::uint64_t generation = 0; ///< of the scenario it belongs to
    RunPhase phase = RunPhase::Planning;
    double time_s = 0;
    WorldState world;
    std::vector<Iceberg> icebergs; ///< those added in flight at the end
    std::vector<Point> truth_m;
    std::vector<bool> active;
    std::optional<PlanEvent> plan; ///< the present one
    std::vector<PlanEvent> plans;  ///< all of them
    std::vector<MissionEvent> events;
    PlannerSettings planner; ///< in force now, interventions applied
    Metrics metrics;
    std::size_t firstSample = 0;    ///< number of the first of `newSamples` in the history
    std::vector<Sample> newSamples; ///< since the snapshot taken before
    std::vector<std::vector<IcebergSample>> newRows; ///< icebergs at each of them
    std::optional<Error> error;
};

/** The mission as it is now, without generation, phase and samples. */
[[nodiscard]] MissionSnapshot snapshotOf(const Mission& mission);

/** What the worker is to fly next. */
struct MissionRequest
{
    std::uint64_t generation = 0;
    Scenario scenario;
    MissionOptions options;
    std::stop_token stop;
};

class MissionWorker;

/**
 * Plans and flies on a thread of its own; the GUI thread never waits. Commands return at once;
 * what comes of them is taken from the mailbox when `updated` is emitted. Each scenario has a
 * generation, and snapshots of an older one are never handed out. GUI thread.
 */
class MissionRunner : public QObject
{
    Q_OBJECT

public:
    explicit MissionRunner(QObject* parent = nullptr);
    /** Stops a solve or a flight under way and waits for the thread: well under a second. */
    ~MissionRunner() override;

    /** Plans this scenario from its start; ends what was under way. The newest request wins. */
    void setScenario(const Scenario& scenario, const MissionOptions& options = {});
    [[nodiscard]] std::uint64_t generation() const { return m_generation; }

    /** Flies at `rate` simulated seconds a second; 0: as fast as possible. */
    void fly(double rate);
    void pause();
    /** Pauses and advances by `seconds` of simulated time. */
    void stepBy(double seconds);
    /** Back to the start of the same scenario. */
    void restart();
    /** Applies the change at the present instant of a flight that has begun. */
    void intervene(const Intervention& intervention);

    /**
     * Asks for the plan from the start, or in flight for what was flown, in a format of
     * `exportFormats`: `exportReady` or `commandRefused` follows.
     */
    void requestExport(const std::string& formatId);

    /** The newest snapshot of the present generation, with all samples since the last one taken. */
    [[nodiscard]] std::optional<MissionSnapshot> takeSnapshot();

    /** Asks for the run so far, to be saved or exported: `runReady` follows. */
    void requestRun();

signals:
    /** A snapshot waits. */
    void updated();
    /** An intervention or an export could not be done: why. */
    void commandRefused(const QString& message);
    void exportReady(const std::string& content);
    void runReady(const std::shared_ptr<const berg::RunFile>& run);

private:
    void begin();
    template <class Command>
    void post(Command command);

    Mailbox<MissionSnapshot> m_snapshots;
    Mailbox<MissionRequest> m_requests;
    Mailbox<std::vector<Intervention>> m_interventions;
    QThread m_thread;
    MissionWorker* m_worker; ///< lives on `m_thread`
    std::uint64_t m_generation = 0;
    std::stop_source m_stop; ///< of the generation under way
    Scenario m_scenario;
    MissionOptions m_options;
};

} // namespace berg
