#include "widgets/study/benchmark_runner.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Small instances take microseconds: reporting each would cost more than solving it. */
constexpr int kBetweenReports_ms = 40;

void measure(const BenchmarkSpec& spec, const std::stop_token& stop,
             const std::function<void(BenchmarkReport)>& deliver)
{
    ReportPace pace(kBetweenReports_ms);
    std::size_t count = 0;
    std::vector<BenchmarkRow> rows =
        runBenchmark(spec, stop, [&](const BenchmarkProgress& progress) {
            count = progress.count;
            if (pace.isDue())
                deliver({.rows = {progress.rows.begin(), progress.rows.end()},
                         .done = progress.done,
                         .count = progress.count});
        });
    deliver({.rows = std::move(rows), .done = count, .count = count});
}

} // namespace

BenchmarkRunner::BenchmarkRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"benchmark"_s,
             {.work = measure,
              .deliver = [this](BenchmarkReport report) { accept(std::move(report)); },
              .end = [this](const std::optional<WorkFailure>& failure) { end(failure); }})
{
}

void BenchmarkRunner::start(const BenchmarkSpec& spec)
{
    m_running = true;
    m_rows.clear();
    m_isSaved = false;
    m_measured_s = 0;
    m_sinceStart.start();
    m_task.start(spec);
    emit updated();
}

double BenchmarkRunner::elapsed_s() const
{
    return m_running ? 1e-9 * static_cast<double>(m_sinceStart.nsecsElapsed()) : m_measured_s;
}

double BenchmarkRunner::unsaved_s() const
{
    return m_isSaved || m_rows.empty() ? 0 : m_measured_s;
}

void BenchmarkRunner::cancel()
{
    m_task.stop();
}

void BenchmarkRunner::accept(BenchmarkReport report)
{
    const bool newRows = report.rows.size() != m_rows.size();
    m_rows = std::move(report.rows);
    m_isSaved = false;
    m_measured_s = elapsed_s();
    emit progress(report.done, report.count);
    if (newRows)
        emit updated();
}

void BenchmarkRunner::end(const std::optional<WorkFailure>& failure)
{
    m_measured_s = elapsed_s();
    emit updated();
    m_running = false;
    emit finished(failure ? failure->report : QString());
}

} // namespace berg
