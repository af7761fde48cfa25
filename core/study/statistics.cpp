#include "core/study/statistics.h"

#include "core/base/angles.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace berg {

namespace {

constexpr double kNormalFactor = 1.9599639845400542; ///< 97.5 % quantile of the normal distribution

/**
 * Returns P(|T| <= tan(angle) sqrt(degrees)) as a finite sum (26.7.3 for odd, 26.7.4 for even
 * degrees).
 */
double studentWithin(double angle_rad, int degrees)
{
    const double cosine2 = std::cos(angle_rad) * std::cos(angle_rad);
    const bool odd = degrees % 2 == 1;
    double term = odd ? std::cos(angle_rad) : 1;
    double sum = degrees == 1 ? 0 : term;
    for (int k = odd ? 3 : 2; k < degrees; k += 2) {
        term *= cosine2 * (k - 1) / k;
        sum += term;
    }
    sum *= std::sin(angle_rad);
    return odd ? 2 / kPi * (angle_rad + sum) : sum;
}

double studentByBisection(int degrees)
{
    double low_rad = 0;
    double high_rad = kPi / 2;
    for (int i = 0; i < 52; ++i) {
        const double middle_rad = (low_rad + high_rad) / 2;
        (studentWithin(middle_rad, degrees) < 0.95 ? low_rad : high_rad) = middle_rad;
    }
    return std::tan(low_rad) * std::sqrt(degrees);
}

/** Expands in 1 / degrees about the normal quantile, 26.7.5. */
double studentByExpansion(int degrees)
{
    const double z = kNormalFactor;
    const double z2 = z * z;
    const double n = degrees;
    const double g1 = (z2 + 1) / 4;
    const double g2 = ((5 * z2 + 16) * z2 + 3) / 96;
    const double g3 = (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
    const double g4 = ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
    return z * (1 + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n);
}

} // namespace

double quantile(std::span<const double> sorted, double p)
{
    require(!sorted.empty() && p >= 0 && p <= 1, "quantile: no values, or p outside [0, 1]");
    const double place = p * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

Summary summarise(std::span<const double> values)
{
    Summary summary;
    summary.n = static_cast<int>(values.size());
    if (values.empty())
        return summary;
    const auto n = static_cast<double>(values.size());
    summary.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    if (values.size() > 1) {
        double squares = 0;
        for (const double v : values)
            squares += (v - summary.mean) * (v - summary.mean);
        summary.standardError = std::sqrt(squares / (n - 1) / n);
    }
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    summary.median = quantile(sorted, 0.5);
    summary.quartile1 = quantile(sorted, 0.25);
    summary.quartile3 = quantile(sorted, 0.75);
    summary.decile1 = quantile(sorted, 0.1);
    summary.decile9 = quantile(sorted, 0.9);
    return summary;
}

double studentFactor(int degrees)
{
    require(degrees >= 1, "studentFactor: less than one degree of freedom");
    return degrees <= 100 ? studentByBisection(degrees) : studentByExpansion(degrees);
}

MeanInterval meanInterval(std::span<const double> values)
{
    const Summary s = summarise(values);
    const double half = s.n < 2 ? 0 : studentFactor(s.n - 1) * s.standardError;
    return {.mean = s.mean, .low = s.mean - half, .high = s.mean + half};
}

std::vector<double> relativeDifferences(std::span<const double> values,
                                        std::span<const double> reference)
{
    require(values.size() == reference.size(), "relativeDifferences: values without a reference");
    std::vector<double> differences;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (reference[i] != 0)
            differences.push_back(values[i] / reference[i] - 1);
        else if (values[i] == 0)
            differences.push_back(0);
    return differences;
}

bool isSurelyLower(std::span<const double> values, std::span<const double> others)
{
    const std::vector<double> differences = relativeDifferences(values, others);
    return differences.size() > 1 && meanInterval(differences).high < 0;
}

bool isSurelyLowest(std::span<const double> values, std::span<const std::vector<double>> all)
{
    bool isAnyOther = false;
    for (const std::vector<double>& others : all) {
        if (std::ranges::equal(values, others))
            continue;
        if (!isSurelyLower(values, others))
            return false;
        isAnyOther = true;
    }
    return isAnyOther;
}

} // namespace berg
