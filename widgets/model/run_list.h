#pragma once

#include "core/io/files/run_json.h"
#include "widgets/model/compared_run.h"
#include "widgets/model/latest_task.h"

#include <QObject>

#include <deque>

namespace berg {

using RunPointer = std::shared_ptr<const ComparedRun>;

/**
 * A recorded run, flown again so that there is a history. Throws as `replay`, and `Error`
 * ReplayMismatch when a run of a file, whose `path` is not empty, does not come out as recorded.
 */
[[nodiscard]] Mission flownAgain(const RunFile& recorded, const std::string& path,
                                 const std::stop_token& stop = {},
                                 const std::function<void(double)>& onProgress = {});

/** Two comparable runs and the time both have flown. */
struct RunComparison
{
    RunPointer reference;
    RunPointer other;
    double until_s = 0;
};

/**
 * The last runs, and which two of them are set beside each other. Flies further ones, and those of
 * run files, one after the other on a thread of its own: the GUI thread never waits. GUI thread.
 */
class RunList : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 12; ///< the oldest not compared makes room

    explicit RunList(QObject* parent = nullptr);

    /**
     * Keeps what was flown as the new reference; nothing when nothing was. Takes the place of an
     * equal run.
     */
    void add(const FlightRecord& record);
    /** Flies the scenario with these settings in the background and compares it. */
    void addFlown(const Scenario& scenario, const PlannerSettings& planner);
    /**
     * Flies the world of a run, as it was changed in flight, with other settings from the start. A
     * run of the list that is the same is compared at once.
     */
    void addVariant(const ComparedRun& run, const PlannerSettings& planner);
    /** Flies a run file again; one that does not repeat is refused. */
    void open(const QString& path);
    /** Ends the flight under way and drops those that wait. */
    void cancel();
    /** Name or file of what is being flown; empty: nothing. */
    [[nodiscard]] QString flying(const QLocale& locale) const;
    [[nodiscard]] bool isFlying() const { return !m_jobs.empty(); }

    [[nodiscard]] const std::vector<RunPointer>& runs() const { return m_runs; }
    void remove(std::size_t index);
    /** Without a name it is called by its settings again. */
    void rename(std::size_t index, const QString& name);
    /** Choosing the other one swaps the two. What cannot be compared with it is dropped. */
    void setReference(std::size_t index);
    /** Ignored when it cannot be compared with the reference. */
    void setOther(std::size_t index);
    /** Null: none. */
    [[nodiscard]] const RunPointer& reference() const { return m_reference; }
    [[nodiscard]] const RunPointer& other() const { return m_other; }
    [[nodiscard]] std::optional<RunComparison> comparison() const;
    /**
     * Another scenario is on the map now: runs of other worlds are not compared any more, but the
     * newest of this one with the one before; they stay in the list.
     */
    void showWorld(const ScenarioWorld& world);
    /** The run to be drawn over a map of this world; null: none. */
    [[nodiscard]] RunPointer otherIn(const Scenario& scenario) const;

signals:
    /** `runs`, reference or other. */
    void changed();
    void comparisonChanged();
    /** Of the flight under way, simulated. */
    void progress(double flown_s, double duration_s);
    /** A flight is over and no other one waits; `failure` says why in the user's words. */
    void finished(const QString& failure);

private:
    struct Job
    {
        RunFile run;
        QString path; ///< of the run file; empty: `run` is flown
    };
    struct Result
    {
        double flown_s = 0;
        double duration_s = 0;
        RunPointer run; ///< null: not flown to its end yet
    };
    void queue(Job job);
    void start();
    void take(const Result& result);
    void end(const std::optional<WorkFailure>& failure);
    RunPointer insert(RunPointer run);
    void replace(RunPointer& known, RunPointer run);
    void compare(RunPointer reference, RunPointer other);
    void makeRoom();
    [[nodiscard]] RunPointer newestBeside(const RunPointer& run) const;
    using Tell = LatestTask<Job, Result>::Tell;
    static void fly(const Job& job, const std::stop_token& stop, const Tell& tell);

    std::vector<RunPointer> m_runs; ///< oldest first
    RunPointer m_reference;
    RunPointer m_other;
    std::deque<Job> m_jobs;         ///< the first is being flown
    QString m_failure;              ///< the first of those flown in one go
    LatestTask<Job, Result> m_task; ///< last: it ends before the rest
};

} // namespace berg
