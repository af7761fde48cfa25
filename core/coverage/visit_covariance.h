#pragma once

#include "core/tracking/observer.h"

#include <algorithm>
#include <cmath>

namespace berg {

/**
 * Predicts the sigma of one iceberg in closed form: its growth out of view and its reduction in
 * view. With the simple observer sigma is 0 after a sample. With measurements the samples of a
 * visit are treated as one stream of information about the position, detection / (interval *
 * variance) per second: the limit of the Kalman filter for many samples (Bar-Shalom, Li and
 * Kirubarajan 2001, section 5.2). Compared with the filter sample by sample, sigma is right within
 * 2 %. The wait for the first sample, half an interval, is left out because it is the same for
 * every visit.
 */
class VisitCovariance
{
public:
    /**
     * Copies what it needs of the track. All variances of this class are those of the track times
     * `weight`, which must be positive.
     */
    VisitCovariance(const Track& track, const ObserverSpec& observer, double weight);

    /** Returns the weighted variances of the track at the start of the prediction. */
    [[nodiscard]] const DriftVariances& start() const { return m_start; }
    /**
     * Returns the standard deviation along one axis, in metres, that belongs to a weighted variance
     * of this class.
     */
    [[nodiscard]] double deviation_m(double sigma_m2) const
    {
        return std::sqrt(std::max(0.0, sigma_m2) / m_weight);
    }
    /** Returns whether the deviation is surely less than `than_m`, without taking its root. */
    [[nodiscard]] bool deviatesLess(double sigma_m2, double than_m) const
    {
        constexpr double kRounding = 0.99;
        constexpr double kLeast_m = 1e-6;
        return than_m > kLeast_m && sigma_m2 < kRounding * m_weight * than_m * than_m;
    }

    /** Sigma at the end of a time out of view, and its integral over that time. */
    struct Growth
    {
        double sigma_m2 = 0;
        double cost_m2s = 0;
    };
    /** Returns the growth of sigma after `unseen_s` seconds out of view, from these variances. */
    [[nodiscard]] Growth growth(const DriftVariances& from, double unseen_s) const
    {
        if (m_process.velocityTime_s > 0)
            return fadingGrowth(from, unseen_s);
        const double grown_m2 = (m_process.q_m2ps + 2 * from.mixed_m2ps) * unseen_s;
        const double drifted_m2 = from.velocity_m2ps2 * unseen_s * unseen_s;
        return {.sigma_m2 = from.position_m2 + grown_m2 + drifted_m2,
                .cost_m2s = unseen_s * (from.position_m2 + grown_m2 / 2 + drifted_m2 / 3)};
    }

    /**
     * Advances `known` by `unseen_s` seconds out of view. Returns the integral of sigma, in m2 s.
     */
    double grow(DriftVariances& known, double unseen_s) const
    {
        const Growth end = growth(known, unseen_s);
        if (m_process.velocityTime_s > 0)
            known = grown(DriftVariances(known), m_process, unseen_s);
        else
            known.mixed_m2ps += known.velocity_m2ps2 * unseen_s;
        known.position_m2 = end.sigma_m2;
        return end.cost_m2s;
    }

    /**
     * Advances `known` by `seen_s` seconds in view. Returns the integral of sigma, in m2 s; with
     * the simple observer both are 0.
     */
    double sample(DriftVariances& known, double seen_s) const
    {
        if (m_information_1pm2s > 0)
            return filter(known, seen_s);
        known.position_m2 = 0;
        return 0;
    }

    /**
     * Updates `known` for a lost iceberg whose estimate comes into view: the result is the mean
     * over finding it, with probability `chance`, and not finding it.
     */
    void searchLost(DriftVariances& known, double chance) const;

private:
    /** Returns the growth with a fading velocity. Copies `from`: the caller's stays in registers.
     */
    [[nodiscard]] Growth fadingGrowth(DriftVariances from, double unseen_s) const
    {
        return {.sigma_m2 = grown(from, m_process, unseen_s).position_m2,
                .cost_m2s = positionIntegral_m2s(from, m_process, unseen_s)};
    }
    double filter(DriftVariances& known, double seen_s) const;

    DriftVariances m_start;
    DriftProcess m_process; ///< The process noise is multiplied by the weight.
    double m_weight;
    /** Information gained per second in view; 0 with the simple observer. */
    double m_information_1pm2s = 0;
};

} // namespace berg
