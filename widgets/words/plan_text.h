#pragma once

#include "core/plan/policy/policy.h"

#include <QLocale>
#include <QString>
#include <QStringList>

#include <optional>

namespace berg {

/** The present plan, and whether another one is being made. */
struct PlanReadout
{
    PlanPointer plan; ///< null if there is none
    bool solving = false;
    bool isOver = false; ///< whether the run has ended
    bool isHeld = false; ///< every UAV returns, holds or is on the ground: no plan is in force
    QString fault;       ///< reason for which nothing can be planned; empty if there is none
    std::optional<double> weighed_m = {}; ///< D of Eq. (2); nullopt if the policy has none

    /** Returns the number of icebergs in all orders. */
    [[nodiscard]] std::size_t icebergs() const;
};

/** Quality of a plan. */
enum class PlanVerdict
{
    None, ///< there is nothing to judge
    Proven,
    Estimate, ///< a good order, not proven optimal
    Warning,  ///< differs from the request
    Fault     ///< nothing can be planned
};

/** Description of a plan for the user. */
struct PlanState
{
    PlanVerdict verdict = PlanVerdict::None;
    QString text;    ///< in the user's words
    QString details; ///< the solver's results, one a line; empty without a solve
};
/** Returns the description of the present plan. */
[[nodiscard]] PlanState planState(const PlanReadout& readout, const QLocale& locale);

/** Terms of Eq. (1) for a plan; nullopt if the policy does not use them. */
struct PlanFigures
{
    std::optional<double> distance_m;
    std::optional<double> reward_m2; ///< sum sigma_i (N - t_i) = mu D - F
    std::optional<double> objective_m2;
    std::optional<double> mu_m; ///< distance weight, m^2 of uncertainty per m of path
};
/** Returns the terms of Eq. (1) of the present plan. */
[[nodiscard]] PlanFigures planFigures(const PlanReadout& readout, PolicyKind policy);

/**
 * Returns a relative gap as per cent in steps of 0.1, or of 1 from 10 on, rounded up so that
 * "within" stays true.
 */
[[nodiscard]] QString gapText(double gap, const QLocale& locale);

/**
 * Returns the endurance left above the reserve on return: "Home with 03:46 above the reserve", "1
 * flight in 20 uses 02:44 or more of the reserve". `margin_s` is the planned margin, `low_s` that
 * of 1 flight in 20; minus infinity means that the UAV cannot return against the wind.
 */
[[nodiscard]] QStringList marginLines(double margin_s, double low_s);

/**
 * Returns what a lower bound on zeta follows from, see `BoundPoint::isFromRates`; no line for
 * nullopt.
 */
[[nodiscard]] QStringList boundSourceLines(std::optional<bool> isFromRates);

/** Returns why there is no plan for a UAV that returns, holds or is on the ground. */
[[nodiscard]] QString heldPlanText();

/** Returns "87 %" for 0.87. */
[[nodiscard]] QString chanceText(double chance, const QLocale& locale);

} // namespace berg
