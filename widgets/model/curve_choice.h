#pragma once

#include "core/plan/policy/tau_curve.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace berg {

// What the widgets that show a trade-off curve say of it and jump to on it.

/** Index of the interval that holds tau; -1 when the curve does not reach it. */
[[nodiscard]] int presentInterval(const TauCurve& curve, double tau);

/** A tau with few digits strictly inside the interval, as near to its middle as they allow. */
[[nodiscard]] double shortTau(const CurveInterval& interval);

/** Tau of the neighbouring plan towards shorter ways; none at the end of the curve. */
[[nodiscard]] std::optional<double> tauOfNextPlan(const TauCurve& curve, double tau);
/** Tau of the neighbouring plan towards most uncertain first; none at the start. */
[[nodiscard]] std::optional<double> tauOfPreviousPlan(const TauCurve& curve, double tau);

/** "τ 0.83 to 1.21: 14.2 km, proven optimal" */
[[nodiscard]] QString intervalText(const CurveInterval& interval, const QLocale& locale);

} // namespace berg
