#include "widgets/model/bound_runner.h"

#include "core/scenario/validate.h"
#include "widgets/model/low_priority.h"
#include "widgets/model/work_failure.h"

#include <QElapsedTimer>

#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 1000; // plan, curve and forecasts come first
constexpr int kBetweenReports_ms = 200;

/** The scenario with only what its bound depends on. */
Scenario boundedPart(const Scenario& scenario)
{
    Scenario part{.duration_s = scenario.duration_s,
                  .seed = scenario.seed,
                  .dt_s = scenario.dt_s,
                  .noise = scenario.noise,
                  .wind_mps = scenario.wind_mps,
                  .current_mps = scenario.current_mps,
                  .area_m = scenario.area_m,
                  .observer = scenario.observer,
                  .uavs = scenario.uavs,
                  .icebergs = scenario.icebergs,
                  .fovShape = scenario.fovShape};
    for (Uav& uav : part.uavs)
        uav.name.clear();
    for (Iceberg& iceberg : part.icebergs)
        iceberg.name.clear(); // its id stays: the noise is drawn by it
    return part;
}

} // namespace

BoundRunner::BoundRunner(QObject* parent, std::int64_t workLimit)
    : QObject(parent), m_workLimit(workLimit), m_onThread(new QObject)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &BoundRunner::start);
    m_thread.setObjectName(u"bound"_s);
    m_onThread->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_onThread, &QObject::deleteLater);
    m_thread.start(QThread::LowPriority);
    QMetaObject::invokeMethod(m_onThread, lowerPriority, Qt::QueuedConnection);
}

BoundRunner::~BoundRunner()
{
    m_stop.request_stop();
    m_thread.quit();
    m_thread.wait();
}

void BoundRunner::setScenario(const Scenario& scenario)
{
    Scenario part = boundedPart(scenario);
    if (m_scenario == part)
        return;
    m_scenario = std::move(part);
    m_stop.request_stop();
    ++m_generation;
    m_known = {};
    m_complete = !hasZetaBound(*m_scenario);
    if (m_complete)
        m_pause.stop();
    else
        m_pause.start();
    emit updated();
}

void BoundRunner::start()
{
    if (hasErrors(validate(*m_scenario))) { // said elsewhere
        m_complete = true;
        emit updated();
        return;
    }
    m_stop = std::stop_source();
    QMetaObject::invokeMethod(
        m_onThread,
        [this, request = Request{.generation = m_generation,
                                 .scenario = *m_scenario,
                                 .stop = m_stop.get_token()}] { compute(request); },
        Qt::QueuedConnection);
}

void BoundRunner::compute(const Request& request)
{
    QElapsedTimer sinceReport;
    sinceReport.start();
    const auto report = [&](const BoundProgress& progress) {
        if (sinceReport.elapsed() < kBetweenReports_ms)
            return;
        sinceReport.restart();
        publish({.generation = request.generation,
                 .known = {.zeta_m2s = progress.zeta_m2s, .share = progress.share}});
    };
    Result result{.generation = request.generation, .complete = true};
    const auto failure = failureOf([&] {
        const auto bound = std::make_shared<const ZetaBound>(
            zetaLowerBound(request.scenario,
                           {.workLimit = m_workLimit, .stop = request.stop, .onProgress = report}));
        result.known = {.zeta_m2s = bound->zeta_m2s, .share = 1, .whole = bound};
    });
    if (failure)
        result.known = {}; // too large for the memory, as a rule
    publish(std::move(result));
}

void BoundRunner::publish(Result result)
{
    if (m_results.put(std::move(result)))
        QMetaObject::invokeMethod(this, &BoundRunner::takeResult, Qt::QueuedConnection);
}

void BoundRunner::takeResult()
{
    std::optional<Result> result = m_results.take();
    if (!result || result->generation != m_generation)
        return;
    m_known = std::move(result->known);
    m_complete = result->complete;
    emit updated();
}

} // namespace berg
