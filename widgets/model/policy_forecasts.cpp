#include "widgets/model/policy_forecasts.h"

#include "core/scenario/validate.h"
#include "core/sim/policy_forecast.h"
#include "core/study/statistics.h"
#include "widgets/model/compared_run.h"

#include <algorithm>
#include <tuple>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 300;
constexpr int kBetweenReports_ms = 200;

/** Those that are soon flown first. */
std::vector<PolicyKind> soonFirst()
{
    std::vector<PolicyTraits> all(kPolicyTable.begin(), kPolicyTable.end());
    std::ranges::stable_sort(all, {}, [](const PolicyTraits& policy) {
        return std::tuple(policy.method == PolicyMethod::PredictedZeta,
                          policy.solves() && !policy.keepsRoute(), policy.solves());
    });
    std::vector<PolicyKind> policies;
    for (const PolicyTraits& policy : all)
        policies.push_back(policy.kind);
    return policies;
}

/** What of the settings a flight with the policy depends on. */
PlannerSettings relevant(PolicyKind policy, const PlannerSettings& settings)
{
    PlannerSettings used{.policy = policy};
    if (traitsOf(policy).solves()) {
        used.backend = settings.backend;
        used.formulation = settings.formulation;
    }
    if (traitsOf(policy).usesTau) {
        used.tau = settings.tau;
        used.route = settings.route;
    }
    return used;
}

using Tell = std::function<void(PolicyForecast)>;

void foresee(const Scenario& scenario, PolicyKind policy, const std::stop_token& stop,
             const Tell& tell)
{
    ReportPace pace(kBetweenReports_ms);
    const auto report = [&](double share) {
        if (pace.isDue())
            tell({.state = ForecastState::Computing, .share = share});
    };
    if (const auto metrics = forecastOf(scenario, policy, stop, report))
        tell({.state = ForecastState::Known, .share = 1, .metrics = *metrics});
}

/** Those of `flights` that `forecast` does not have. */
void flyDrawn(const Scenario& scenario, PolicyForecast forecast, PolicyKind policy, int flights,
              const std::stop_token& stop, const Tell& tell)
{
    while (!forecast.drawsNoMore) {
        const auto number = static_cast<int>(forecast.drawn_m2s.size());
        const std::optional<double> zeta_m2s = drawnZeta_m2s(scenario, policy, number, stop);
        if (!zeta_m2s)
            return;
        forecast.drawn_m2s.push_back(*zeta_m2s);
        forecast.drawsNoMore = number + 1 >= flights;
        tell(forecast);
    }
}

bool isUnderWay(const PolicyForecast& forecast)
{
    return forecast.state == ForecastState::Waiting || forecast.state == ForecastState::Computing;
}

bool awaitsDrawn(const PolicyForecast& forecast)
{
    return forecast.state == ForecastState::Known && !forecast.drawsNoMore;
}

} // namespace

std::optional<ZetaRange> PolicyForecast::range() const
{
    if (!isFlown())
        return std::nullopt;
    std::vector<double> sorted_m2s = drawn_m2s;
    std::ranges::sort(sorted_m2s);
    return ZetaRange{.least_m2s = quantile(sorted_m2s, 0.05),
                     .most_m2s = quantile(sorted_m2s, 0.95)};
}

PolicyForecasts::PolicyForecasts(QObject* parent, int limit_ms, int drawnFlights)
    : QObject(parent)
    , m_drawnFlights(drawnFlights)
    , m_order(soonFirst())
    , m_task(u"forecasts"_s,
             {.work =
                  [](const Request& request, const std::stop_token& stop, const auto& tell) {
                      if (request.soFar.state == ForecastState::Known)
                          flyDrawn(request.scenario, request.soFar, request.policy,
                                   request.drawnFlights, stop, tell);
                      else
                          foresee(request.scenario, request.policy, stop, tell);
                  },
              .deliver = [this](PolicyForecast forecast) { take(std::move(forecast)); },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      if (failure)
                          take({.state = ForecastState::Impossible, .whyNot = failure->report});
                  }},
             WorkPriority::Low)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &PolicyForecasts::start);
    m_limit.setSingleShot(true);
    m_limit.setInterval(limit_ms);
    connect(&m_limit, &QTimer::timeout, this, &PolicyForecasts::giveUp);
}

bool PolicyForecasts::isComplete() const
{
    return std::none_of(m_forecasts.begin(), m_forecasts.end(),
                        [](const auto& entry) { return isUnderWay(entry.second); });
}

bool PolicyForecasts::isDrawn() const
{
    return isComplete() &&
           std::none_of(m_forecasts.begin(), m_forecasts.end(),
                        [](const auto& entry) { return awaitsDrawn(entry.second); });
}

void PolicyForecasts::setScenario(const Scenario& scenario)
{
    const bool sameWorld = m_scenario && isSameWorld(*m_scenario, scenario);
    const auto stillHolds = [&](PolicyKind policy) {
        return sameWorld && m_forecasts[policy].state != ForecastState::Impossible &&
               relevant(policy, m_scenario->planner) == relevant(policy, scenario.planner);
    };
    bool changed = false;
    for (const PolicyKind policy : m_order) {
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
    for (const PolicyKind policy : m_order)
        if (m_forecasts[policy].state == ForecastState::Waiting) {
            m_forecasts[policy].state = ForecastState::Computing;
            startPresent(policy);
            return;
        }
    for (const PolicyKind policy : m_order)
        if (awaitsDrawn(m_forecasts[policy])) {
            startPresent(policy);
            return;
        }
}

void PolicyForecasts::startPresent(PolicyKind policy)
{
    m_present = policy;
    m_limit.start();
    m_task.start({.scenario = *m_scenario,
                  .policy = policy,
                  .soFar = m_forecasts[policy],
                  .drawnFlights = m_drawnFlights});
}

void PolicyForecasts::stopPresent()
{
    m_task.drop();
    m_limit.stop();
    m_present.reset();
}

void PolicyForecasts::giveUp()
{
    PolicyForecast& forecast = m_forecasts[*m_present];
    if (forecast.state == ForecastState::Known)
        forecast.drawsNoMore = true;
    else
        forecast = {.state = ForecastState::TooLong};
    stopPresent();
    emit updated();
    startNext();
}

/** The flights in drawn worlds take as long as the one that has just ended. */
bool PolicyForecasts::hasTimeToDraw() const
{
    return (m_limit.interval() - m_limit.remainingTime()) * m_drawnFlights <= m_limit.interval();
}

void PolicyForecasts::take(PolicyForecast forecast)
{
    if (!m_present)
        return;
    const bool isDone = forecast.state == ForecastState::Known
                            ? forecast.drawn_m2s.empty() || forecast.drawsNoMore
                            : forecast.state != ForecastState::Computing;
    PolicyForecast& present = m_forecasts[*m_present];
    if (present.state == ForecastState::Known && forecast.state == ForecastState::Impossible)
        present.drawsNoMore = true; // of a drawn world: what was foreseen holds
    else
        present = std::move(forecast);
    if (awaitsDrawn(present) && present.drawn_m2s.empty())
        present.drawsNoMore = !hasTimeToDraw();
    if (isDone)
        stopPresent();
    emit updated();
    startNext();
}

} // namespace berg
