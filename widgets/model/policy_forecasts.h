#pragma once

#include "core/sim/policy_forecast.h"
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

/** Where zeta of nine flights in ten lies. */
struct ZetaRange
{
    double least_m2s = 0;
    double most_m2s = 0;
};

/** What is known of a flight with one policy before it is flown (`forecastOf`). */
struct PolicyForecast
{
    ForecastState state = ForecastState::Waiting;
    double share = 0;                   ///< flown in advance so far
    Metrics metrics;                    ///< when known
    std::vector<double> drawn_m2s = {}; ///< zeta of flights in drawn worlds, by `drawnZeta_m2s`
    bool drawsNoMore = false;           ///< all were flown, or it takes too long
    QString whyNot;

    /** In all drawn worlds. */
    [[nodiscard]] bool isFlown() const { return drawn_m2s.size() == kDrawnFlights; }
    /** Of zeta in these, 5 and 95 %; none before. */
    [[nodiscard]] std::optional<ZetaRange> range() const;
    bool operator==(const PolicyForecast&) const = default;
};

using PolicyForecastList = std::map<PolicyKind, PolicyForecast>;

/**
 * Forecasts what the scenario comes to with each policy, on a thread of its own at low priority, a
 * moment after the last change, one policy after the other, those that are soon done first; then
 * flies each in drawn worlds, which tell its mean and spread. A change of settings does away with
 * the forecasts that depend on them only. GUI thread.
 */
class PolicyForecasts : public QObject
{
    Q_OBJECT

public:
    /** Longest time for a policy, and again for its drawn worlds: fields of hundreds of icebergs
     * take hours to fly. */
    static constexpr int kLimit_ms = 60'000;

    explicit PolicyForecasts(QObject* parent = nullptr, int limit_ms = kLimit_ms,
                             int drawnFlights = kDrawnFlights);

    void setScenario(const Scenario& scenario);

    /** Of every policy, for the present scenario; empty before the first one. */
    [[nodiscard]] const PolicyForecastList& forecasts() const { return m_forecasts; }
    /** None waits or is under way; drawn worlds may be. */
    [[nodiscard]] bool isComplete() const;
    /** Nor are they. */
    [[nodiscard]] bool isDrawn() const;

signals:
    void updated();

private:
    struct Request
    {
        Scenario scenario;
        PolicyKind policy = PolicyKind::Visitation;
        PolicyForecast soFar;
        int drawnFlights = 0;
    };

    void take(PolicyForecast forecast);
    void start();
    void startNext();
    void startPresent(PolicyKind policy);
    void stopPresent();
    [[nodiscard]] bool hasTimeToDraw() const;
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
