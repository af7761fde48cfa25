#pragma once

#include "core/tracking/observer.h"

#include <algorithm>
#include <cmath>

namespace berg {

/**
 * What one iceberg costs while it is not looked at, and what looks at it take away, in closed form.
 * With the simple observer a look tells all. With measurements the looks of a while are taken as
 * one stream of information about the position, detection / (interval * variance) per second: the
 * limit of the Kalman filter for many looks (Bar-Shalom, Li and Kirubarajan 2001, section 5.2).
 * Against the filter look by look sigma is right within 2 %. The wait for the first look, half an
 * interval, is left out: it is the same for every visit.
 */
class CovarianceAccount
{
public:
    /** All variances are those of the track times `weight`. */
    CovarianceAccount(const Track& track, const ObserverSpec& observer, double weight);

    [[nodiscard]] const DriftVariances& start() const { return m_start; }
    /** Along one axis, metres, of a covariance of this account. */
    [[nodiscard]] double deviation_m(double sigma_m2) const
    {
        return std::sqrt(std::max(0.0, sigma_m2) / m_weight);
    }
    /** Whether the deviation is surely less: without its root, which takes long. */
    [[nodiscard]] bool deviatesLess(double sigma_m2, double than_m) const
    {
        constexpr double kRounding = 0.99;
        constexpr double kLeast_m = 1e-6;
        return than_m > kLeast_m && sigma_m2 < kRounding * m_weight * than_m * than_m;
    }

    /** The covariance after `unseen_s`, and the integral of sigma until then. */
    struct Growth
    {
        double sigma_m2 = 0;
        double cost_m2s = 0;
    };
    [[nodiscard]] Growth growth(const DriftVariances& from, double unseen_s) const
    {
        if (m_process.velocityTime_s > 0)
            return fadingGrowth(from, unseen_s);
        const double grown_m2 = (m_process.q_m2ps + 2 * from.mixed_m2ps) * unseen_s;
        const double drifted_m2 = from.velocity_m2ps2 * unseen_s * unseen_s;
        return {.sigma_m2 = from.position_m2 + grown_m2 + drifted_m2,
                .cost_m2s = unseen_s * (from.position_m2 + grown_m2 / 2 + drifted_m2 / 3)};
    }

    /** Not looked at for that long; the integral of sigma. */
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

    /** In view for that long; the integral of sigma, m2 s. */
    double look(DriftVariances& known, double seen_s) const
    {
        if (m_information_1pm2s > 0)
            return filter(known, seen_s);
        known.position_m2 = 0;
        return 0;
    }

    /** Where a lost iceberg is believed to be is in view, and it is found with this chance: the
     * mean of both. */
    void lookForLost(DriftVariances& known, double chance) const;

private:
    /** Where the velocity fades. Takes a copy, so that what others know stays in registers. */
    [[nodiscard]] Growth fadingGrowth(DriftVariances from, double unseen_s) const
    {
        return {.sigma_m2 = grown(from, m_process, unseen_s).position_m2,
                .cost_m2s = positionIntegral_m2s(from, m_process, unseen_s)};
    }
    double filter(DriftVariances& known, double seen_s) const;

    DriftVariances m_start;
    DriftProcess m_process; ///< times the weight
    double m_weight;
    double m_information_1pm2s = 0; ///< of looks, per second; 0: one look tells all
};

} // namespace berg
