#pragma once

#include "core/plan/policy/tau_curve.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// Texts about a trade-off curve, and the tau values that the widgets jump to.

/** Returns the index of the interval with tau, or nullopt if the curve does not reach it. */
[[nodiscard]] std::optional<int> presentInterval(const TauCurve& curve, double tau);

/**
 * Returns a tau strictly inside the interval with few digits, as near to its middle as they allow.
 */
[[nodiscard]] double shortTau(const CurveInterval& interval);

/**
 * Returns a tau of the neighbouring plan towards shorter paths, or nullopt at the end of the curve
 * or for a tau that it does not reach.
 */
[[nodiscard]] std::optional<double> tauOfNextPlan(const TauCurve& curve, double tau);
/**
 * Returns a tau of the neighbouring plan towards "most uncertain first", or nullopt at the start.
 * For a tau that the curve does not reach, returns one of its last plan.
 */
[[nodiscard]] std::optional<double> tauOfPreviousPlan(const TauCurve& curve, double tau);

/** Returns "τ 0.83 to 1.21: whole order 14.2 km, proven optimal". */
[[nodiscard]] QString intervalText(const CurveInterval& interval, const QLocale& locale);

} // namespace berg
