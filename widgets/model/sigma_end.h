#pragma once

#include <QSettings>

namespace berg {

struct Scenario;

/** Smallest "round" end of a sigma scale at or above `sigma_m2`: 1, 1.5, 2, 3, 4, 5, 6, 8, 10, ...
 */
[[nodiscard]] double roundSigmaScale(double sigma_m2);

/**
 * End of the colour scale of sigma for a scenario, m^2, > 0: the one chosen by the user, else the
 * one that `ownSigmaEnd_m2` finds. Map, plan, tables, charts, exports and pictures use it, so that
 * a sigma has one colour at every instant of every run. Thread: any.
 */
[[nodiscard]] double sigmaEnd_m2(const Scenario& scenario);

/**
 * The end that suits a scenario, round, from what is known at take-off: the sigma that icebergs
 * reach when they are not seen for the time of a round tour, at most for the duration of the run.
 * The most uncertain iceberg counts, unless it exceeds the median by a factor of eight: one that is
 * as good as lost does not make all others look alike. Cost: linear.
 */
[[nodiscard]] double ownSigmaEnd_m2(const Scenario& scenario);

/** The end chosen by the user, m^2; 0: each scenario has its own. It holds for the process. */
[[nodiscard]] double chosenSigmaEnd_m2();
void chooseSigmaEnd(double end_m2);

/** Settings of the user: 0 or the end in m^2. */
inline constexpr const char* kSigmaEndKey = "view/sigmaEnd";
/** Returns 0 if the setting is missing, no number or outside (0, 10^12]. */
[[nodiscard]] double readSigmaEnd_m2(const QSettings& settings);

} // namespace berg
