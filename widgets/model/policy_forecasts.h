#pragma once

#include "core/study/zeta_prediction.h"
#include "widgets/model/latest_task.h"

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
    TooLong,   ///< given up: it would take longer than the limit
    Impossible ///< the scenario cannot be flown with the policy: `whyNot`
};

/** What is known of a flight with one policy before it is flown. */
struct PolicyForecast
{
    ForecastState state = ForecastState::Waiting;
    double share = 0;                   ///< of the flights, flown so far
    std::vector<double> drawn_m2s = {}; ///< zeta of each, by `drawnZeta_m2s`
    QString whyNot = {};

    /** Once all were flown; nullopt before. */
    [[nodiscard]] std::optional<ZetaPrediction> prediction() const;
    bool operator==(const PolicyForecast&) const = default;
};

using PolicyForecastList = std::map<PolicyKind, PolicyForecast>;

/**
 * Predicts what the scenario comes to with each policy by flights in drawn worlds, on a thread of
 * its own at low priority, a moment after the last change: first the policy chosen, then those that
 * are soon done. A change of settings does away with the forecasts that depend on them only. GUI
 * thread.
 */
class PolicyForecasts : public QObject
{
    Q_OBJECT

public:
    /** Longest time for a policy: fields of hundreds of icebergs take hours to fly. */
    static constexpr int kLimit_ms = 120'000;

    explicit PolicyForecasts(QObject* parent = nullptr, int limit_ms = kLimit_ms,
                             int drawnFlights = kDrawnFlights);

    void setScenario(const Scenario& scenario);

    /** Of every policy, for the present scenario; empty before the first one. */
    [[nodiscard]] const PolicyForecastList& forecasts() const { return m_forecasts; }
    /** None waits or is under way. */
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

    void take(PolicyForecast forecast);
    void start();
    void startNext();
    void startPresent(PolicyKind policy);
    void stopPresent();
    [[nodiscard]] bool isTooSlow(const PolicyForecast& forecast) const;
    void giveUp();

    int m_drawnFlights;
    std::optional<Scenario> m_scenario;
    PolicyForecastList m_forecasts;
    std::vector<PolicyKind> m_order;     ///< in which they are flown
    std::optional<PolicyKind> m_present; ///< under way
    QTimer m_pause;                      ///< runs out when changes have come to rest
    QTimer m_limit;
    LatestTask<Request, PolicyForecast> m_task; ///< last: it ends before the rest
};

} // namespace berg
