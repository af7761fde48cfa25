#pragma once

#include "core/study/zeta_prediction.h"
#include "widgets/tasks/latest_task.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <map>
#include <optional>

namespace berg {

enum class ForecastState
{
    Waiting,
    Computing,
    Known,
    TooLong,   ///< stopped because it would exceed the time limit
    Impossible ///< the policy cannot fly this scenario; see `unsupportedReason`
};

/** Forecast of the zeta of one policy before take-off. */
struct PolicyForecast
{
    ForecastState state = ForecastState::Waiting;
    double share = 0;                   ///< share of the drawn flights that are flown, 0 to 1
    std::vector<double> drawn_m2s = {}; ///< zeta of each flight by `drawnZeta_m2s`
    QString unsupportedReason = {};

    /** Returns the prediction once all flights are flown; nullopt before. */
    [[nodiscard]] std::optional<ZetaPrediction> prediction() const;
    bool operator==(const PolicyForecast&) const = default;
};

using PolicyForecastList = std::map<PolicyKind, PolicyForecast>;

/**
 * Predicts zeta for every policy by flights in drawn worlds, on its own thread at low priority, a
 * moment after the last change: first the chosen policy, then the fast ones. A change of settings
 * drops only the forecasts that depend on it. GUI thread.
 */
class PolicyForecasts : public QObject
{
    Q_OBJECT

public:
    /** Time limit for one policy, ms: fields of hundreds of icebergs take hours to fly. */
    static constexpr int kLimit_ms = 120'000;

    explicit PolicyForecasts(QObject* parent = nullptr, int limit_ms = kLimit_ms,
                             int drawnFlights = kDrawnFlights);

    /** Sets the scenario; forecasts that still hold are kept, the others are computed again. */
    void setScenario(const Scenario& scenario);

    /** Returns the forecasts for the present scenario, none before the first scenario. */
    [[nodiscard]] const PolicyForecastList& forecasts() const { return m_forecasts; }
    /** Returns whether no forecast is pending or running. */
    [[nodiscard]] bool isComplete() const;

signals:
    void updated();

private:
    struct Request
    {
        Scenario scenario;
        PolicyKind policy = PolicyKind::Visitation;
        int drawnFlights = 0;
    };

    void accept(PolicyForecast forecast);
    void start();
    void startNext();
    void startPresent(PolicyKind policy);
    void stopPresent();
    [[nodiscard]] bool isTooSlow(const PolicyForecast& forecast) const;
    void giveUp();

    int m_drawnFlights;
    std::optional<Scenario> m_scenario;
    PolicyForecastList m_forecasts;
    std::vector<PolicyKind> m_order;     ///< order of computation
    std::optional<PolicyKind> m_present; ///< current policy
    QTimer m_pause;                      ///< restarted by each change
    QTimer m_limit;
    /** Last member: its thread ends before the others are destroyed. */
    LatestTask<Request, PolicyForecast> m_task;
};

} // namespace berg
