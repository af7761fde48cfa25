#include "widgets/model/policy_forecasts.h"

#include "core/scenario/validate.h"
#include "core/sim/policy_forecast.h"
#include "widgets/model/compared_run.h"
#include "widgets/model/low_priority.h"
#include "widgets/model/work_failure.h"

#include <QElapsedTimer>

#include <algorithm>
#include <array>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 300;
constexpr int kBetweenReports_ms = 200;

/** Those that are soon flown first. */
constexpr std::array kPolicies{PolicyKind::Nearest, PolicyKind::Uncertainty, PolicyKind::Path,
                               PolicyKind::Tour,    PolicyKind::Visitation,  PolicyKind::Latency,
                               PolicyKind::Coverage};

/** What of the settings a flight with the policy depends on. */
PlannerSettings relevant(PolicyKind policy, const PlannerSettings& settings)
{
    PlannerSettings used{.policy = policy};
    const bool solves = policy != PolicyKind::Nearest && policy != PolicyKind::Uncertainty &&
                        policy != PolicyKind::Coverage;
    if (solves) {
        used.backend = settings.backend;
        used.formulation = settings.formulation;
    }
    if (policy == PolicyKind::Visitation) {
        used.tau = settings.tau;
        used.route = settings.route;
    }
    return used;
}

bool isUnderWay(const PolicyForecast& forecast)
{
    return forecast.state == ForecastState::Waiting || forecast.state == ForecastState::Computing;
}

} // namespace

PolicyForecasts::PolicyForecasts(QObject* parent, int limit_ms)
    : QObject(parent), m_onThread(new QObject)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &PolicyForecasts::start);
    m_limit.setSingleShot(true);
    m_limit.setInterval(limit_ms);
    connect(&m_limit, &QTimer::timeout, this, &PolicyForecasts::giveUp);
    m_thread.setObjectName(u"forecasts"_s);
    m_onThread->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_onThread, &QObject::deleteLater);
    m_thread.start(QThread::LowPriority);
    QMetaObject::invokeMethod(m_onThread, lowerPriority, Qt::QueuedConnection);
}

PolicyForecasts::~PolicyForecasts()
{
    m_stop.request_stop();
    m_thread.quit();
    m_thread.wait();
}

bool PolicyForecasts::isComplete() const
{
    return std::none_of(m_forecasts.begin(), m_forecasts.end(),
                        [](const auto& entry) { return isUnderWay(entry.second); });
}

void PolicyForecasts::setScenario(const Scenario& scenario)
{
    const bool sameWorld = m_scenario && isSameWorld(*m_scenario, scenario);
    const auto stillHolds = [&](PolicyKind policy) {
        return sameWorld && m_forecasts[policy].state != ForecastState::Impossible &&
               relevant(policy, m_scenario->planner) == relevant(policy, scenario.planner);
    };
    bool changed = false;
    for (const PolicyKind policy : kPolicies) {
        if (stillHolds(policy))
            continue;
        if (m_present == policy)
            stopPresent();
        m_forecasts[policy] = {};
        changed = true;
    }
    m_scenario = scenario;
    if (!changed)
        return;
    m_pause.start();
    emit updated();
}

void PolicyForecasts::start()
{
    if (hasErrors(validate(*m_scenario))) { // said elsewhere
        for (auto& [policy, forecast] : m_forecasts)
            forecast = {.state = ForecastState::Impossible};
        emit updated();
        return;
    }
    startNext();
}

void PolicyForecasts::startNext()
{
    if (m_present || m_pause.isActive())
        return;
    for (const PolicyKind policy : kPolicies) {
        PolicyForecast& forecast = m_forecasts[policy];
        if (forecast.state != ForecastState::Waiting)
            continue;
        forecast.state = ForecastState::Computing;
        m_present = policy;
        m_stop = std::stop_source();
        m_limit.start();
        QMetaObject::invokeMethod(
            m_onThread,
            [this, request = Request{.generation = m_generation,
                                     .scenario = *m_scenario,
                                     .policy = policy,
                                     .stop = m_stop.get_token()}] { compute(request); },
            Qt::QueuedConnection);
        return;
    }
}

/** What still comes of it is of another generation. */
void PolicyForecasts::stopPresent()
{
    m_stop.request_stop();
    m_limit.stop();
    m_present.reset();
    ++m_generation;
}

void PolicyForecasts::giveUp()
{
    m_forecasts[*m_present] = {.state = ForecastState::TooLong};
    stopPresent();
    emit updated();
    startNext();
}

void PolicyForecasts::compute(const Request& request)
{
    QElapsedTimer sinceReport;
    sinceReport.start();
    const auto report = [&](double share) {
        if (sinceReport.elapsed() < kBetweenReports_ms)
            return;
        sinceReport.restart();
        publish(request, {.state = ForecastState::Computing, .share = share});
    };
    const auto failure = failureOf([&] {
        if (const auto metrics = forecastOf(request.scenario, request.policy, request.stop, report))
            publish(request, {.state = ForecastState::Known, .share = 1, .metrics = *metrics});
    });
    if (failure)
        publish(request, {.state = ForecastState::Impossible, .whyNot = failure->report});
}

void PolicyForecasts::publish(const Request& request, PolicyForecast forecast)
{
    if (m_results.put({.generation = request.generation, .forecast = std::move(forecast)}))
        QMetaObject::invokeMethod(this, &PolicyForecasts::takeResult, Qt::QueuedConnection);
}

void PolicyForecasts::takeResult()
{
    std::optional<Result> result = m_results.take();
    if (!result || result->generation != m_generation || !m_present)
        return;
    PolicyForecast& forecast = m_forecasts[*m_present];
    forecast = std::move(result->forecast);
    if (forecast.state != ForecastState::Computing)
        stopPresent();
    emit updated();
    startNext();
}

} // namespace berg
