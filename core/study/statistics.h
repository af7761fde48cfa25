#pragma once

#include <span>
#include <vector>

namespace berg {

/** Mean and spread of a set of numbers. */
struct Summary
{
    int n = 0;
    double mean = 0;
    double standardError = 0; ///< of the mean; 0 for n < 2
    double median = 0;
    double quartile1 = 0;
    double quartile3 = 0;
    double decile1 = 0; ///< 10 %
    double decile9 = 0; ///< 90 %
};

/** Quantiles interpolate linearly between order statistics (Hyndman and Fan 1996, type 7). */
[[nodiscard]] Summary summarise(std::span<const double> values);

/** Quantile of ascending values, `p` in [0, 1]. */
[[nodiscard]] double quantile(std::span<const double> sorted, double p);

/**
 * 97.5 % quantile of Student's t, by which a standard error becomes half a 95 % interval, to 1e-9;
 * `degrees` of freedom >= 1. Abramowitz and Stegun (1964), 26.7.3, 26.7.4 and 26.7.5.
 */
[[nodiscard]] double studentFactor(int degrees);

/** A mean with its 95 % confidence interval (Student's t; low = high = mean for n < 2). */
struct MeanInterval
{
    double mean = 0;
    double low = 0;
    double high = 0;
};
[[nodiscard]] MeanInterval meanInterval(std::span<const double> values);

/**
 * Each value / its reference - 1. There is no share of a reference of 0: where only that is 0 the
 * pair is left out; where both are, nothing differs.
 */
[[nodiscard]] std::vector<double> relativeDifferences(std::span<const double> values,
                                                      std::span<const double> reference);

/** Returns true if the 95 % interval of the relative differences, of two pairs or more, is below 0.
 */
[[nodiscard]] bool isSurelyLower(std::span<const double> values, std::span<const double> others);

/** Returns true if `values` are surely lower than each of `all` that differs from them; of those at
 * least one. */
[[nodiscard]] bool isSurelyLowest(std::span<const double> values,
                                  std::span<const std::vector<double>> all);

} // namespace berg
