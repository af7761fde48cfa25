#pragma once

#include "core/io/files/run_json.h"
#include "widgets/flight/compared_run.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>

#include <deque>

namespace berg {

using RunPointer = std::shared_ptr<const ComparedRun>;

/**
 * Replays a recorded run to obtain its history. Throws as `replay`, and `Error` ReplayMismatch if
 * the run comes from a file (`path` is not empty) and gives another result than recorded. If
 * stopped, the mission has flown less.
 */
[[nodiscard]] Mission replayedMission(const RunFile& recorded, const std::string& path,
                                      const std::stop_token& stop = {},
                                      const std::function<void(double)>& onProgress = {});

/** Two comparable runs and the time that both have flown. */
struct RunComparison
{
    RunPointer reference;
    RunPointer other;
    double until_s = 0;
};

/**
 * The last runs and the two that are compared. Flies further runs and those of run files one after
 * the other on its own thread; the GUI thread never waits. GUI thread.
 */
class RunList : public QObject
{
    Q_OBJECT

public:
    /** When full, the oldest run outside the comparison is removed. */
    static constexpr std::size_t kMost = 12;

    explicit RunList(QObject* parent = nullptr);

    /**
     * Adds a flown run as the new reference; an empty record is ignored. An equal run is replaced.
     */
    void add(const FlightRecord& record);
    /** Flies the scenario with these settings in the background and compares the run. */
    void addFlown(const Scenario& scenario, const PlannerSettings& planner);
    /**
     * Flies the world of a run, with its changes in flight, from the start with other settings. If
     * the list has the same run, that one is compared at once.
     */
    void addVariant(const ComparedRun& run, const PlannerSettings& planner);
    /** Replays a run file; a run that gives another result is refused. */
    void open(const QString& path);
    /** Stops the current flight and drops the pending ones. */
    void cancel();
    /** Returns the name or file of the current flight, or an empty text if there is none. */
    [[nodiscard]] QString flying(const QLocale& locale) const;
    [[nodiscard]] bool isFlying() const { return !m_jobs.empty(); }

    [[nodiscard]] const std::vector<RunPointer>& runs() const { return m_runs; }
    /** Removes a run; throws `std::out_of_range` if there is none of this index, as those below. */
    void remove(std::size_t index);
    /** Sets the name; an empty name restores the one made from the settings. */
    void rename(std::size_t index, const QString& name);
    /**
     * Sets the reference. Choosing the other run swaps the two; a run that cannot be compared with
     * it is dropped from the comparison.
     */
    void setReference(std::size_t index);
    /**
     * Sets the other run; ignored if it cannot be compared with the reference. Choosing the
     * reference swaps the two.
     */
    void setOther(std::size_t index);
    /** Returns one of the runs being compared, or null if there is none. */
    [[nodiscard]] const RunPointer& reference() const { return m_reference; }
    [[nodiscard]] const RunPointer& other() const { return m_other; }
    /** Returns the comparison, or nullopt unless two runs are compared. */
    [[nodiscard]] std::optional<RunComparison> comparison() const;
    /**
     * Shows the world of another scenario: comparisons of other worlds end, and the newest two runs
     * of this one are compared. All runs stay in the list.
     */
    void showWorld(const ScenarioWorld& world);
    /** Returns the run to draw over a map of this world, or null if there is none. */
    [[nodiscard]] RunPointer otherIn(const Scenario& scenario) const;

signals:
    /** Emitted when `runs`, the reference or the other run has changed. */
    void changed();
    /** Emitted when the result of `comparison` or a name in it may have changed. */
    void comparisonChanged();
    /** Reports simulated times of the current flight, s. */
    void progress(double flown_s, double duration_s);
    /**
     * Emitted when no flight is pending any more. `failure` is an error text for the user, or
     * empty.
     */
    void finished(const QString& failure);

private:
    struct Job
    {
        RunFile run;
        QString path; ///< run file; if empty, `run` is flown
    };
    struct Result
    {
        double flown_s = 0;
        double duration_s = 0;
        RunPointer run; ///< null until the flight is complete
    };
    void queue(Job job);
    void start();
    void accept(const Result& result);
    void end(const std::optional<WorkFailure>& failure);
    RunPointer insert(RunPointer run);
    void replace(RunPointer& known, RunPointer run);
    void compare(RunPointer reference, RunPointer other);
    void makeRoom();
    [[nodiscard]] RunPointer newestBeside(const RunPointer& run) const;
    using Deliver = LatestTask<Job, Result>::Deliver;
    static void fly(const Job& job, const std::stop_token& stop, const Deliver& deliver);

    std::vector<RunPointer> m_runs; ///< oldest first
    RunPointer m_reference;
    RunPointer m_other;
    std::deque<Job> m_jobs; ///< the first one is being flown
    QString m_failure;      ///< first failure since the list was idle
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<Job, Result> m_task;
};

} // namespace berg
