#pragma once

#include "core/study/study_summary.h"
#include "widgets/tasks/latest_task.h"

#include <QElapsedTimer>
#include <QObject>

#include <atomic>
#include <memory>

namespace berg {

/** A study and its results. Immutable: shared between threads. */
struct StudyResult
{
    Study study;
    StudySummary summary;
    /** For each setting, number of complete cases in which it has the lowest zeta. */
    std::vector<std::size_t> bestIn;
    /** For each of `summary.cases`, the setting with the lowest zeta. */
    std::vector<std::size_t> bestByCase;
};
using StudyPointer = std::shared_ptr<const StudyResult>;

/** Progress of a study when it was passed on for saving: see `StudyRunner::noteSaved`. */
struct StudySavePoint
{
    std::uint64_t study = 0; ///< number of the study among those of this runner
    double unsaved_s = 0;    ///< flying time that the file will contain, s
};

/**
 * Returns the results of a study. Throws `std::logic_error` if it has no setting `reference`. Cost:
 * linear in the missions flown, apart from sorting each setting.
 */
[[nodiscard]] StudyResult resultOf(Study study, std::size_t reference);

/**
 * Flies studies on its own thread, which uses all cores; the GUI thread never waits. Results come a
 * few times a second. A cancelled study keeps its results and can be continued. A new start
 * replaces the current study. GUI thread.
 */
class StudyRunner : public QObject
{
    Q_OBJECT

public:
    explicit StudyRunner(QObject* parent = nullptr);

    /** Flies a study from its start and stops the current one. */
    void start(const StudySpec& spec);
    /**
     * Flies the missing missions of the present study, unless it has no results or is being flown.
     */
    void carryOn();
    /** Stops the study and keeps its results; `finished` follows. */
    void cancel();
    /** Shows a study flown before and stops the current one. */
    void show(Study study);
    /** Shows a recovered study, which is in no file of the user. */
    void restore(Study study);
    /** Sets the setting that the others are compared with; `updated` follows. */
    void setReference(std::size_t setting);

    [[nodiscard]] bool isRunning() const { return m_running; }
    /** Returns the present results, or null if there are none. */
    [[nodiscard]] const StudyPointer& result() const { return m_result; }
    [[nodiscard]] std::size_t flown() const { return m_flown; }
    [[nodiscard]] std::size_t count() const { return m_count; }
    [[nodiscard]] bool isComplete() const { return m_count > 0 && m_flown == m_count; }
    /**
     * Returns the remaining time at the present pace, s, or nullopt if no study is being flown or
     * no mission has ended since it was started.
     */
    [[nodiscard]] std::optional<double> timeLeft_s() const;
    /** Returns the flying time of the study, s; nullopt if it was flown before or not at all. */
    [[nodiscard]] std::optional<double> elapsed_s() const { return m_elapsed_s; }
    /** Returns the flying time that would be lost on exit, s: 0 if all missions are in a file. */
    [[nodiscard]] double unsaved_s() const;
    /** Returns the present progress, for saving. */
    [[nodiscard]] StudySavePoint savePoint() const;
    /** Records that the progress at that point is in a file. Ignored for another study. */
    void noteSaved(const StudySavePoint& point);
    /** Returns the estimated duration of a study on this machine, s; learns from those flown. */
    [[nodiscard]] double estimated_s(const StudySpec& spec) const;

signals:
    /** Emitted when `flown` has grown. */
    void progress();
    /** Emitted when `result` has changed. */
    void updated();
    /** Emitted when a study ends. `failure` is an error text for the user, or empty. */
    void finished(const QString& failure);

private:
    struct Outcome
    {
        StudyPointer result;
        std::size_t flown = 0;
        QString failure;
    };
    struct Request
    {
        Study study;
        std::size_t reference = 0;
        bool flies = true; ///< if false, only the results are computed
    };
    using Task = LatestTask<Request, Outcome>;
    void begin(Study study, std::size_t reference, bool flies);
    void accept(Outcome outcome);
    void end(const std::optional<WorkFailure>& failure);
    void learn(double elapsed_s);
    [[nodiscard]] double sinceStart_s() const;
    // Runs on the task's thread.
    void work(Request& request, const std::stop_token& stop, const Task::Deliver& deliver);

    StudyPointer m_result;
    std::size_t m_flown = 0;
    std::size_t m_count = 0;
    std::size_t m_flownAtStart = 0;
    bool m_running = false;
    std::optional<double> m_elapsed_s;
    std::uint64_t m_study = 0; ///< number of the present study
    double m_unsaved_s = 0;    ///< unsaved flying time before the current flight, s
    double m_pace = 1;         ///< actual time divided by estimated time
    QElapsedTimer m_sinceStart;
    QString m_failure;                       ///< failure of the current work
    std::atomic<std::size_t> m_reference{0}; ///< read by the thread while a study is flown
    Task m_task; ///< last member: its thread ends before the others are destroyed
};

} // namespace berg
