#include "core/plan/problem/tuning.h"

#include <algorithm>

namespace berg {

TuningWeight tuningWeight(const TvpProblem& problem, double tau)
{
    TuningWeight weight;
    const int n = problem.nodeCount();
    if (n < 2)
        return weight;

    std::vector<double> sorted = problem.sigma_m2;
    std::sort(sorted.begin(), sorted.end());
    for (int i = 0; i < n; ++i)
        weight.f1Max_m2 += sorted[static_cast<std::size_t>(i)] * i;

    double sum_m = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (i != j)
                sum_m += problem.distance_m(i, j);
    const double average_m = sum_m / (static_cast<double>(n) * (n - 1));
    weight.dEst_m = average_m * (n - 1);

    weight.distanceOnly = sorted.back() == 0;
    if (weight.distanceOnly)
        weight.mu = 1;
    else if (weight.dEst_m > 0)
        weight.mu = tau * weight.f1Max_m2 / weight.dEst_m;
    return weight;
}

} // namespace berg
