#pragma once

#include "core/plan/policy/tau_curve.h"

#include <initializer_list>

namespace berg::test {

/** Returns a proven curve from 0 through these interval ends; distance and reward fall along it. */
inline TauCurve curveThrough(std::initializer_list<double> ends)
{
    TauCurve curve{.intervals = {}, .complete = true};
    double from = 0;
    for (const double end : ends) {
        const auto k = static_cast<double>(curve.intervals.size());
        curve.intervals.push_back({.tauFrom = from,
                                   .tauTo = end,
                                   .plan = {{1}},
                                   .distance_m = 30000 - 3000 * k,
                                   .reward_m2 = 500 - 10 * k * k,
                                   .proven = true});
        from = end;
    }
    return curve;
}

} // namespace berg::test
