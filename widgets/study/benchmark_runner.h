#pragma once

#include "core/study/benchmark.h"
#include "widgets/tasks/latest_task.h"

#include <QElapsedTimer>
#include <QObject>

namespace berg {

/**
 * Progress of a benchmark: the rows measured so far and how many instances are done of how many.
 */
struct BenchmarkReport
{
    std::vector<BenchmarkRow> rows;
    std::size_t done = 0;
    std::size_t count = 0;
};

/**
 * Runs benchmarks on its own thread; the GUI thread never waits. A new benchmark replaces the one
 * in progress. Cancelling keeps the rows measured so far. GUI thread.
 */
class BenchmarkRunner : public QObject
{
    Q_OBJECT

public:
    explicit BenchmarkRunner(QObject* parent = nullptr);

    /** Starts a benchmark with an empty table and stops the current one, if any. */
    void start(const BenchmarkSpec& spec);
    /** Stops the benchmark and keeps its rows; `finished` follows. */
    void cancel();

    [[nodiscard]] bool isRunning() const { return m_running; }
    /** Returns the rows so far of the current benchmark, or of the last one. */
    [[nodiscard]] const std::vector<BenchmarkRow>& rows() const { return m_rows; }
    /** Returns the measuring time of the current benchmark, or of the last one, s. */
    [[nodiscard]] double elapsed_s() const;
    /** Returns the measuring time that would be lost on exit, s: 0 if all rows are in a file. */
    [[nodiscard]] double unsaved_s() const;
    /** Records that the present rows are in a file. */
    void noteSaved() { m_isSaved = true; }

signals:
    /** Reports instances done and to do; skipped instances count. */
    void progress(qulonglong done, qulonglong count);
    /** Emitted when `rows` has changed. */
    void updated();
    /** Emitted when a benchmark ends. `failure` is an error text for the user, or empty. */
    void finished(const QString& failure);

private:
    using Task = LatestTask<BenchmarkSpec, BenchmarkReport>;
    void accept(BenchmarkReport report);
    void end(const std::optional<WorkFailure>& failure);

    std::vector<BenchmarkRow> m_rows;
    bool m_running = false;
    bool m_isSaved = false;  ///< whether the rows are in a file
    double m_measured_s = 0; ///< measuring time of the rows, s
    QElapsedTimer m_sinceStart;
    Task m_task; ///< last member: its thread ends before the others are destroyed
};

} // namespace berg
