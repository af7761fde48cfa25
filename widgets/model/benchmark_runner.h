#pragma once

#include "core/study/benchmark.h"
#include "widgets/model/latest_task.h"

#include <QElapsedTimer>
#include <QObject>

namespace berg {

struct BenchmarkReport
{
    std::vector<BenchmarkRow> rows;
    std::size_t done = 0;
    std::size_t count = 0;
};

/**
 * Runs benchmarks on a thread of its own; the GUI thread never waits. The newest one wins. What has
 * been measured stays when it is cancelled. GUI thread.
 */
class BenchmarkRunner : public QObject
{
    Q_OBJECT

public:
    explicit BenchmarkRunner(QObject* parent = nullptr);

    /** Starts with an empty table; ends the benchmark under way, if any. */
    void start(const BenchmarkSpec& spec);
    /** Ends it with the rows there are: `finished` follows. */
    void cancel();

    [[nodiscard]] bool isRunning() const { return m_running; }
    /** Rows so far, of the benchmark under way or of the last one. */
    [[nodiscard]] const std::vector<BenchmarkRow>& rows() const { return m_rows; }
    /** Of measuring, under way or of the last benchmark. */
    [[nodiscard]] double elapsed_s() const;
    /** Time of measuring that would be lost: of rows that are in no file. */
    [[nodiscard]] double unsaved_s() const;
    /** The rows, as they are now, are in a file. */
    void noteSaved() { m_isSaved = true; }

signals:
    /** Instances done and to do, those that will not be tried included. */
    void progress(qulonglong done, qulonglong count);
    /** `rows` has changed. */
    void updated();
    /** It has come to an end; `failure` says why, in the user's words, when that is an error. */
    void finished(const QString& failure);

private:
    using Task = LatestTask<BenchmarkSpec, BenchmarkReport>;
    void take(BenchmarkReport report);
    void end(const std::optional<WorkFailure>& failure);

    std::vector<BenchmarkRow> m_rows;
    bool m_running = false;
    bool m_isSaved = false;  ///< the rows are
    double m_measured_s = 0; ///< that the rows took
    QElapsedTimer m_sinceStart;
    Task m_task; ///< last: it ends before the rest
};

} // namespace berg
