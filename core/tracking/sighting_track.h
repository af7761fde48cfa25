#pragma once

#include "core/geometry/geometry.h"
#include "core/tracking/drift_fit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/**
 * Rules for the use of a track and limits of the results. A window of a day holds about two of the
 * inertial loops that icebergs drift in: on a beacon of the Canadian Ice Service (640 fixes) half a
 * day and two days forecast worse at all leads from 1 h to 24 h, and the square of the error was
 * 0.7 to 1.3 of the 2 q t expected up to 12 h, and 3 times that at 24 h.
 */
struct TrackRules
{
    double window_s = 86400; ///< length of the window before the last fix
    /** If the window holds one fix, the one before it is used up to this gap. */
    double longestGap_s = 14 * 86400.0;
    double fastest_mps = 2.5;        ///< largest speed of an iceberg
    double jumpSlack_m = 2000;       ///< allowance for errors of position between two fixes
    std::size_t fewestForGrowth = 4; ///< minimum number of fixes for an estimate of q
    double stationaryWithin_m = 500; ///< largest distance of three or more fixes from their mean
    /** Time that these fixes must span to count as stationary; 0 turns the test off. */
    double stationaryFor_s = 86400;
    double largestVelocity_mps = 5;  ///< limit of each component of the velocity
    double largestGrowth_m2ps = 1e6; ///< limit of q
    /**
     * Changes of the velocity; if its spread is above 0, `fitDrift` estimates position, velocity
     * and q.
     */
    DriftProcess drift = {};
    Point mean_mps = Point::Zero(); ///< mean velocity for `fitDrift`
    bool operator==(const TrackRules&) const = default;
};

/** Motion of an iceberg, estimated from its fixes. */
struct TrackEstimate
{
    std::size_t last = 0; ///< index of the newest fix used, at which the estimate starts
    std::size_t used = 0; ///< number of fixes used for the velocity
    /** Number of fixes that share their time with another, in the whole track. */
    std::size_t repeated = 0;
    /** Number of fixes in the window at places the iceberg cannot have reached. */
    std::size_t jumped = 0;
    std::optional<Point> velocity_mps; ///< nullopt if there are too few fixes
    /** Nullopt if there are too few fixes or the iceberg is stationary. */
    std::optional<double> q_m2ps;
    std::optional<DriftFit> fit; ///< fit at the last fix used; set only with `TrackRules::drift`
    std::optional<std::size_t> stated; ///< index of the last used fix that states a drift
    bool stationary = false;           ///< the velocity is then zero
    bool velocityClamped = false;
    bool growthClamped = false;
};

/**
 * Fixes that make one consistent track: indices into the fixes, times rising, and counts of those
 * left out.
 */
struct ConsistentFixes
{
    std::vector<std::size_t> indices;
    std::size_t repeated = 0; ///< number of fixes that share their time with another
    std::size_t jumped = 0;   ///< number of fixes at places the iceberg cannot have reached
};
/**
 * Returns the fixes that make one consistent track: one of each time (the last given), without
 * fixes that are not finite and without those that the others exclude. Two neighbours of a chain
 * are within `fastest_mps` x time + `jumpSlack_m` of each other. Chains are built in the order of
 * time: each fix extends the longest chain that it fits, and at most eight chains are followed at
 * once. The longest chain is returned; of equally long chains the one that ends last. Cost: n log
 * n.
 */
[[nodiscard]] ConsistentFixes consistentFixes(std::span<const Fix> fixes, const TrackRules& rules);

/**
 * Estimates velocity and q of one iceberg from at least one fix, for the model of Eq. (17):
 * constant velocity v plus a random walk whose variance grows by q per second along each axis, so
 * that the increments d_k over dt_k are independent, of mean v dt_k and variance q dt_k.
 *
 * v is the least-squares fit to the increments, weighted by 1/dt_k: sum d_k / sum dt_k, the best
 * linear unbiased estimate, of variance q/T per axis over the time T. q is the unbiased moment of
 * the residuals r_k = d_k - v dt_k,
 *
 *      q = (sum |r_k|^2 / 2 - e) / (T - sum dt_k^2 / T),
 *
 * where e is what the variances of the fixes alone would give; never below 0. Weighting the
 * residuals by time rather than each |r_k|^2/dt_k keeps two fixes minutes apart, whose difference
 * is error of position, from deciding it. If the fixes' errors are not given they are part of q.
 *
 * Fixes of the last `window_s` are used; if only the last one lies there, the last two, unless the
 * gap exceeds `longestGap_s`. The model assumes that v is constant over the window: its changes are
 * part of q. With `rules.drift` v may change, and the estimate is that of the last fix. If no fix
 * is finite, `used` is 0. Throws `std::logic_error` if there is no fix.
 */
[[nodiscard]] TrackEstimate estimateTrack(std::span<const Fix> fixes, const TrackRules& rules = {});

/**
 * Returns the track with fewer of its entries, the first and the last included: at the time of each
 * entry left out the result is within `tolerance_m` of it. Returns the whole track if `tolerance_m`
 * is not above 0. Cost: linear (swinging door).
 */
[[nodiscard]] RecordedTrack thinned(const RecordedTrack& track, double tolerance_m);

} // namespace berg
