#pragma once

#include "core/tracking/observer.h"

namespace berg {

/** What is known of one iceberg along each axis, as `Track` has it. */
struct Covariance
{
    double sigma_m2 = 0;
    double mixed_m2ps = 0;     ///< of position and velocity
    double velocity_m2ps2 = 0; ///< variance of the velocity
    bool operator==(const Covariance&) const = default;
};

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

    [[nodiscard]] const Covariance& start() const { return m_start; }
    /** Along one axis, metres, of a covariance of this account. */
    [[nodiscard]] double deviation_m(double sigma_m2) const;

    /** The covariance after `unseen_s`, and the integral of sigma until then. */
    struct Growth
    {
        double sigma_m2 = 0;
        double cost_m2s = 0;
    };
    [[nodiscard]] Growth growth(const Covariance& from, double unseen_s) const
    {
        const double grown_m2 = (m_q_m2ps + 2 * from.mixed_m2ps) * unseen_s;
        const double drifted_m2 = from.velocity_m2ps2 * unseen_s * unseen_s;
        return {.sigma_m2 = from.sigma_m2 + grown_m2 + drifted_m2,
                .cost_m2s = unseen_s * (from.sigma_m2 + grown_m2 / 2 + drifted_m2 / 3)};
    }

    /** Not looked at for that long; the integral of sigma. */
    double grow(Covariance& known, double unseen_s) const
    {
        const Growth grown = growth(known, unseen_s);
        known.sigma_m2 = grown.sigma_m2;
        known.mixed_m2ps += known.velocity_m2ps2 * unseen_s;
        return grown.cost_m2s;
    }

    /** In view for that long; the integral of sigma, m2 s. */
    double look(Covariance& known, double seen_s) const
    {
        if (m_information_1pm2s > 0)
            return filter(known, seen_s);
        known.sigma_m2 = 0;
        return 0;
    }

    /** Where a lost iceberg is believed to be is in view, and it is found with this chance: the
     * mean of both. */
    void lookForLost(Covariance& known, double chance) const;

private:
    double filter(Covariance& known, double seen_s) const;

    Covariance m_start;
    double m_q_m2ps;
    double m_weight;
    double m_information_1pm2s = 0; ///< of looks, per second; 0: one look tells all
};

} // namespace berg
