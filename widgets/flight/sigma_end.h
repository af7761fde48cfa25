#pragma once

#include <QSettings>

#include <optional>

namespace berg {

struct Scenario;

/**
 * Returns the smallest round end of a sigma scale at or above `sigma_m2`: 1, 1.5, 2, 3, 4, 5, 6, 8,
 * 10, …
 */
[[nodiscard]] double roundSigmaScale(double sigma_m2);

/**
 * Returns the end of the sigma colour scale for a scenario, m^2, > 0: the user's choice, else
 * `ownSigmaEnd_m2`. Map, plan, tables, charts, exports and images use it, so that a sigma has one
 * colour at every instant of every run. Thread: any.
 */
[[nodiscard]] double sigmaEnd_m2(const Scenario& scenario);

/**
 * Returns the round end that suits a scenario by what is known at take-off: the sigma of icebergs
 * that are out of view for the time of a round tour, at most for the duration of the run. The most
 * uncertain iceberg counts unless it exceeds eight times the median: one that is as good as lost
 * must not make all others look alike. Cost: linear.
 */
[[nodiscard]] double ownSigmaEnd_m2(const Scenario& scenario);

/**
 * Returns the end chosen by the user for this process, m^2, or nullopt if each scenario uses its
 * own.
 */
[[nodiscard]] std::optional<double> chosenSigmaEnd_m2();
/** Sets the end for this process, m^2; nullopt lets each scenario use its own. */
void chooseSigmaEnd(std::optional<double> end_m2);

/** Key of the setting: 0 or the end in m^2. */
inline constexpr const char* kSigmaEndKey = "view/sigmaEnd";
/** Returns the setting, or nullopt if it is missing, not a number or outside (0, 10^12]. */
[[nodiscard]] std::optional<double> readSigmaEnd_m2(const QSettings& settings);

} // namespace berg
