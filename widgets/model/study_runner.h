#pragma once

#include "core/study/study_summary.h"
#include "widgets/model/latest_task.h"

#include <QElapsedTimer>
#include <QObject>

#include <atomic>
#include <memory>

namespace berg {

/** A study and what it has come to. Immutable: shared between threads. */
struct StudyResult
{
    Study study;
    StudySummary summary;
    std::vector<std::size_t> bestIn;     ///< by setting: complete cases in which it is the lowest
    std::vector<std::size_t> bestByCase; ///< by `summary.cases`: the setting that is the lowest
};
using StudyPointer = std::shared_ptr<const StudyResult>;

/** How far a study had come when it was given to be saved: see `StudyRunner::noteSaved`. */
struct StudySavePoint
{
    std::uint64_t study = 0; ///< number of the study among those of the runner
    double unsaved_s = 0;    ///< time of flying that the file will hold
};

/** Cost: linear in the missions flown, apart from sorting each setting. */
[[nodiscard]] StudyResult resultOf(Study study, std::size_t reference);

/**
 * Flies studies on a thread of its own, which spreads them over all cores; the GUI thread never
 * waits. Results come a few times a second. What has been flown stays when it is cancelled, and
 * can be carried on. The newest start wins. GUI thread.
 */
class StudyRunner : public QObject
{
    Q_OBJECT

public:
    explicit StudyRunner(QObject* parent = nullptr);

    /** Flies it from the start; ends what is under way. */
    void start(const StudySpec& spec);
    /** Flies what is missing of the study there is. */
    void carryOn();
    /** Ends it with what has been flown: `finished` follows. */
    void cancel();
    /** Shows a study that was flown before; ends what is under way. */
    void show(Study study);
    /** As `show`, of one that is in no file of the user's. */
    void restore(Study study);
    /** The setting that the others are compared with: `updated` follows. */
    void setReference(std::size_t setting);

    [[nodiscard]] bool isRunning() const { return m_running; }
    /** Null: none yet. */
    [[nodiscard]] const StudyPointer& result() const { return m_result; }
    [[nodiscard]] std::size_t flown() const { return m_flown; }
    [[nodiscard]] std::size_t count() const { return m_count; }
    [[nodiscard]] bool isComplete() const { return m_count > 0 && m_flown == m_count; }
    /** Of what is under way, at the pace so far; none: nothing has been flown yet. */
    [[nodiscard]] std::optional<double> timeLeft_s() const;
    /** That flying the study took; none: flown before, or not at all. */
    [[nodiscard]] std::optional<double> elapsed_s() const { return m_elapsed_s; }
    /** Time of flying that would be lost: of missions that are in no file. */
    [[nodiscard]] double unsaved_s() const;
    /** Of the study there is, as it stands now. */
    [[nodiscard]] StudySavePoint savePoint() const;
    /** What had been flown at that point is in a file. Nothing changes for another study. */
    void noteSaved(const StudySavePoint& point);
    /** How long a study may take on this machine: learns from those flown. */
    [[nodiscard]] double estimated_s(const StudySpec& spec) const;

signals:
    /** `flown` has grown. */
    void progress();
    /** `result` has changed. */
    void updated();
    /** It has come to an end; `failure` says why, in the user's words, when that is an error. */
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
        bool flies = true; ///< else only the figures are made
    };
    using Task = LatestTask<Request, Outcome>;
    void begin(Study study, std::size_t reference, bool flies);
    void take(Outcome outcome);
    void end(const std::optional<WorkFailure>& failure);
    void learn(double elapsed_s);
    [[nodiscard]] double sinceStart_s() const;
    // On the thread of the runner:
    void work(Request& request, const std::stop_token& stop, const Task::Tell& tell);

    StudyPointer m_result;
    std::size_t m_flown = 0;
    std::size_t m_count = 0;
    std::size_t m_flownAtStart = 0;
    bool m_running = false;
    std::optional<double> m_elapsed_s;
    std::uint64_t m_study = 0; ///< number of the study there is
    double m_unsaved_s = 0;    ///< before the flight under way
    double m_pace = 1;         ///< time taken for each second estimated
    QElapsedTimer m_sinceStart;
    QString m_failure;                       ///< of the one under way
    std::atomic<std::size_t> m_reference{0}; ///< wanted, while one is being flown
    Task m_task;                             ///< last: it ends before the rest
};

} // namespace berg
