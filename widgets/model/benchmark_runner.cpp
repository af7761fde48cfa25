#include "widgets/model/benchmark_runner.h"

#include "widgets/model/work_failure.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

/** Small instances take microseconds: telling of each would cost more than solving it. */
constexpr int kBetweenReports_ms = 40;

} // namespace

BenchmarkRunner::BenchmarkRunner(QObject* parent) : QObject(parent), m_onThread(new QObject)
{
    m_thread.setObjectName(u"benchmark"_s);
    m_onThread->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_onThread, &QObject::deleteLater);
    m_thread.start();
}

BenchmarkRunner::~BenchmarkRunner()
{
    m_stop.request_stop();
    m_thread.quit();
    m_thread.wait();
}

void BenchmarkRunner::start(const BenchmarkSpec& spec)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    ++m_generation;
    m_running = true;
    m_rows.clear();
    m_isSaved = false;
    m_measured_s = 0;
    m_sinceStart.start();
    QMetaObject::invokeMethod(
        m_onThread,
        [this,
         request = Request{.generation = m_generation, .spec = spec, .stop = m_stop.get_token()}] {
            measure(request);
        },
        Qt::QueuedConnection);
    emit updated();
}

double BenchmarkRunner::unsaved_s() const
{
    return m_isSaved || m_rows.empty() ? 0 : m_measured_s;
}

void BenchmarkRunner::cancel()
{
    m_stop.request_stop();
}

void BenchmarkRunner::measure(const Request& request)
{
    Result result{.generation = request.generation};
    QElapsedTimer sinceReport;
    sinceReport.start();
    const auto failure = failureOf([&] {
        const auto report = [&](const BenchmarkProgress& progress) {
            if (sinceReport.elapsed() < kBetweenReports_ms)
                return;
            sinceReport.restart();
            result.rows.assign(progress.rows.begin(), progress.rows.end());
            result.done = progress.done;
            result.count = progress.count;
            publish(result);
        };
        result.rows = runBenchmark(request.spec, request.stop, report);
        result.done = result.count;
    });
    if (failure)
        result.failure = failure->report;
    result.ended = true;
    publish(std::move(result));
}

void BenchmarkRunner::publish(Result result)
{
    if (m_results.put(std::move(result)))
        QMetaObject::invokeMethod(this, &BenchmarkRunner::take, Qt::QueuedConnection);
}

void BenchmarkRunner::take()
{
    std::optional<Result> result = m_results.take();
    if (!result || result->generation != m_generation)
        return;
    const bool newRows = result->rows.size() != m_rows.size();
    m_rows = std::move(result->rows);
    m_isSaved = false;
    m_measured_s = static_cast<double>(m_sinceStart.elapsed()) / 1000;
    emit progress(result->done, result->count);
    if (newRows || result->ended)
        emit updated();
    if (!result->ended)
        return;
    m_running = false;
    emit finished(result->failure);
}

} // namespace berg
