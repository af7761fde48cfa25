#pragma once

#include "core/sim/plan_forecast.h"
#include "core/sim/recorder.h"

#include <QLocale>
#include <QString>
#include <QStringList>

#include <optional>

namespace berg {

/** The plan there is, and whether another one is being made. */
struct PlanReadout
{
    std::optional<PlanEvent> plan; ///< of several UAVs that of one of them
    bool solving = false;
    bool isOver = false; ///< the run has ended: nothing is left of the plan
    bool isHeld = false; ///< every UAV returns, holds or is on the ground: no plan is in force
    QString fault;       ///< why nothing can be planned; empty: nothing stands in the way
    OrdersByUav others;  ///< of the UAVs that were planned together with it
    std::optional<double> weighed_m = {}; ///< D of Eq. (2); nullopt if the policy weighs none

    /** In the orders of all of them. */
    [[nodiscard]] std::size_t icebergs() const;
};

/** How much is known about a plan. */
enum class PlanVerdict
{
    None, ///< nothing to judge
    Proven,
    Estimate, ///< a good order, not proven
    Warning,  ///< not what was asked for
    Fault     ///< nothing can be planned
};

/** What to say of a plan. */
struct PlanState
{
    PlanVerdict verdict = PlanVerdict::None;
    QString text;    ///< in the user's words
    QString details; ///< the solver's, one line for each; empty when there was no solve
};
[[nodiscard]] PlanState planState(const PlanReadout& readout, const QLocale& locale);

/** The numbers of Eq. (1) behind a plan; none where the policy does not weigh them. */
struct PlanFigures
{
    std::optional<double> distance_m;
    std::optional<double> reward_m2; ///< sum sigma_i (N - t_i) = mu D - F
    std::optional<double> objective_m2;
    std::optional<double> mu_m; ///< m^2 of uncertainty for each m of way
};
[[nodiscard]] PlanFigures planFigures(const PlanReadout& readout, PolicyKind policy);

/** A relative gap as per cent in steps of 0.1, from 10 on of 1, rounded up: "within" must stay
 * true.
 */
[[nodiscard]] QString gapText(double gap, const QLocale& locale);

/**
 * What is left of the endurance above the reserve at home: "Home with 03:46 above the reserve", "1
 * flight in 20 uses 02:44 or more of the reserve". `margin_s` as planned, `low_s` of 1 flight in
 * 20; minus infinity: the UAV never comes home against the wind.
 */
[[nodiscard]] QStringList marginLines(double margin_s, double low_s);

/** "87 %" for 0.87. */
[[nodiscard]] QString chanceText(double chance, const QLocale& locale);

} // namespace berg
