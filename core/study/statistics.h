#pragma once

#include <span>
#include <vector>

namespace berg {

/** Mean and spread of a set of numbers. */
struct Summary
{
    /** Number of values. */
    int n = 0;
    double mean = 0;
    double standardError = 0; ///< of the mean; 0 if n < 2
    double median = 0;
    double quartile1 = 0;
    double quartile3 = 0;
    double decile1 = 0; ///< 10 % quantile
    double decile9 = 0; ///< 90 % quantile
};

/**
 * Returns mean, standard error and quantiles; all are 0 without values. Quantiles interpolate
 * linearly between order statistics (Hyndman and Fan 1996, type 7).
 */
[[nodiscard]] Summary summarise(std::span<const double> values);

/**
 * Returns a quantile of ascending values, `p` in [0, 1]. Throws `std::logic_error` without values
 * or for another `p`.
 */
[[nodiscard]] double quantile(std::span<const double> sorted, double p);

/**
 * Returns the 97.5 % quantile of Student's t for `degrees` >= 1 of freedom, the factor between a
 * standard error and half a 95 % interval, accurate to 1e-9. Throws `std::logic_error` for
 * `degrees` < 1. Abramowitz and Stegun (1964), 26.7.3, 26.7.4 and 26.7.5.
 */
[[nodiscard]] double studentFactor(int degrees);

/** A mean with its 95 % confidence interval (Student's t; low = high = mean if n < 2). */
struct MeanInterval
{
    double mean = 0;
    double low = 0;
    double high = 0;
};
/** Returns the mean of the values with its 95 % confidence interval. */
[[nodiscard]] MeanInterval meanInterval(std::span<const double> values);

/**
 * Returns value / reference - 1 for each pair. A pair with a reference of 0 is left out, unless the
 * value is 0 too, which gives 0. Throws `std::logic_error` if the lengths differ.
 */
[[nodiscard]] std::vector<double> relativeDifferences(std::span<const double> values,
                                                      std::span<const double> reference);

/**
 * Returns true if there are at least two relative differences of `values` to `others` and their
 * 95 % interval is below 0. Throws `std::logic_error` if the lengths differ.
 */
[[nodiscard]] bool isSurelyLower(std::span<const double> values, std::span<const double> others);

/**
 * Returns true if `values` are surely lower than every member of `all` that is not equal to them,
 * and there is at least one. Throws `std::logic_error` if the lengths differ.
 */
[[nodiscard]] bool isSurelyLowest(std::span<const double> values,
                                  std::span<const std::vector<double>> all);

} // namespace berg
