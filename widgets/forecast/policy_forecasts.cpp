#include "widgets/forecast/policy_forecasts.h"

#include "core/checks/validate.h"
#include "widgets/flight/compared_run.h"

#include <algorithm>
#include <tuple>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kPause_ms = 300;

/** Returns the policies, fast ones first. */
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

/** Returns the settings that a flight with the policy depends on. */
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

using Deliver = std::function<void(PolicyForecast)>;

void flyDrawn(const Scenario& scenario, PolicyKind policy, int flights, const std::stop_token& stop,
              const Deliver& deliver)
{
    PolicyForecast forecast{.state = ForecastState::Computing};
    for (int number = 0; number < flights; ++number) {
        const std::optional<double> zeta_m2s = drawnZeta_m2s(scenario, policy, number, stop);
        if (!zeta_m2s)
            return;
        forecast.drawn_m2s.push_back(*zeta_m2s);
        forecast.share = (number + 1.0) / flights;
        if (number + 1 == flights)
            forecast.state = ForecastState::Known;
        deliver(forecast);
    }
}

bool isUnderWay(const PolicyForecast& forecast)
{
    return forecast.state == ForecastState::Waiting || forecast.state == ForecastState::Computing;
}

} // namespace

std::optional<ZetaPrediction> PolicyForecast::prediction() const
{
    if (state != ForecastState::Known)
        return std::nullopt;
    return predictionOf(drawn_m2s);
}

PolicyForecasts::PolicyForecasts(QObject* parent, int limit_ms, int drawnFlights)
    : QObject(parent)
    , m_drawnFlights(drawnFlights)
    , m_order(soonFirst())
    , m_task(u"forecasts"_s,
             {.work =
                  [](const Request& request, const std::stop_token& stop, const auto& deliver) {
                      flyDrawn(request.scenario, request.policy, request.drawnFlights, stop,
                               deliver);
                  },
              .deliver = [this](PolicyForecast forecast) { accept(std::move(forecast)); },
              .end =
                  [this](const std::optional<WorkFailure>& failure) {
                      if (failure)
                          accept({.state = ForecastState::Impossible,
                                  .unsupportedReason = failure->report});
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
    if (hasErrors(validate(*m_scenario))) { // the window reports them elsewhere
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
    const auto waits = [this](PolicyKind policy) {
        return m_forecasts[policy].state == ForecastState::Waiting;
    };
    const PolicyKind chosen = m_scenario->planner.policy;
    const auto next = std::ranges::find_if(m_order, waits);
    if (next != m_order.end())
        startPresent(waits(chosen) ? chosen : *next);
}

void PolicyForecasts::startPresent(PolicyKind policy)
{
    m_present = policy;
    m_forecasts[policy].state = ForecastState::Computing;
    m_limit.start();
    m_task.start({.scenario = *m_scenario, .policy = policy, .drawnFlights = m_drawnFlights});
}

void PolicyForecasts::stopPresent()
{
    m_task.drop();
    m_limit.stop();
    m_present.reset();
}

void PolicyForecasts::giveUp()
{
    m_forecasts[*m_present] = {.state = ForecastState::TooLong};
    stopPresent();
    emit updated();
    startNext();
}

/** Extrapolates from the flights so far, which all take about the same time. */
bool PolicyForecasts::isTooSlow(const PolicyForecast& forecast) const
{
    const int passed_ms = m_limit.interval() - m_limit.remainingTime();
    return passed_ms > forecast.share * m_limit.interval();
}

void PolicyForecasts::accept(PolicyForecast forecast)
{
    if (!m_present)
        return;
    if (forecast.state == ForecastState::Computing && isTooSlow(forecast)) {
        giveUp();
        return;
    }
    const bool isDone = forecast.state != ForecastState::Computing;
    m_forecasts[*m_present] = std::move(forecast);
    if (isDone)
        stopPresent();
    emit updated();
    startNext();
}

} // namespace berg
