#pragma once

#include "core/base/geometry.h"
#include "core/tracking/drift_fit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace berg {

/**
 * What is used of a track, and the bounds of what may come out. A window of a day holds about two
 * of the inertial loops that icebergs drift in: on a beacon of the Canadian Ice Service (640 fixes)
 * half a day and two days forecast worse at all leads from 1 h to 24 h, and the square of the error
 * was 0.7 to 1.3 of the 2 q t expected up to 12 h, 3 of it at 24 h.
 */
struct TrackRules
{
    double window_s = 86400;            ///< before the last fix; if it holds but one, see below
    double longestGap_s = 14 * 86400.0; ///< the last two fixes serve alone up to this far apart
    double fastest_mps = 2.5;           ///< no iceberg moves faster ...
    double jumpSlack_m = 2000;          ///< ... than this plus this distance (errors of position)
    std::size_t fewestForGrowth = 4;    ///< fixes without which q is not estimated
    double stationaryWithin_m = 500;    ///< three fixes and more, this near their mean ...
    double stationaryFor_s = 86400;     ///< ... over at least this time: aground; 0: do not ask
    double largestVelocity_mps = 5;     ///< each component is clamped to it
    double largestGrowth_m2ps = 1e6;    ///< q is clamped to it
    /** How velocities change; with a spread, `fitDrift` tells position, velocity and q. */
    DriftProcess drift = {};
    Point mean_mps = Point::Zero(); ///< what velocities are then about
    bool operator==(const TrackRules&) const = default;
};

/** How an iceberg moves, seen from its fixes. */
struct TrackEstimate
{
    std::size_t last = 0;     ///< index of the fix it starts from, the newest that was used
    std::size_t used = 0;     ///< fixes the velocity rests on
    std::size_t repeated = 0; ///< of one time with another, in the whole track
    std::size_t jumped = 0;   ///< in the window, but where the iceberg cannot have been
    std::optional<Point> velocity_mps; ///< none: too few fixes
    std::optional<double> q_m2ps;      ///< none: too few fixes, or stationary
    std::optional<DriftFit> fit;       ///< at the last fix used; none: as for the velocity
    bool stationary = false;           ///< its velocity is zero then
    bool velocityClamped = false;
    bool growthClamped = false;
};

/**
 * The fixes that make one consistent track: by time, one of each time (the last given), without
 * those that the others say are impossible. Returns indices into `fixes`, times rising; counts what
 * was left out. Every two neighbours of the longest such chain are within `fastest_mps` x time +
 * `jumpSlack_m` of each other; of chains of one length the newest wins. Cost: n log n.
 */
struct ConsistentFixes
{
    std::vector<std::size_t> indices;
    std::size_t repeated = 0;
    std::size_t jumped = 0;
};
[[nodiscard]] ConsistentFixes consistentFixes(std::span<const Fix> fixes, const TrackRules& rules);

/**
 * Velocity and q of one iceberg from at least one fix, for the model of Eq. (17): constant velocity
 * v plus a random walk whose variance grows by q per second along each axis, so that the increments
 * d_k over dt_k are independent, of mean v dt_k and variance q dt_k.
 *
 * v is the least-squares fit to the increments, weighted by 1/dt_k: sum d_k / sum dt_k, the best
 * linear unbiased estimate, of variance q/T per axis over the time T. q is the unbiased moment of
 * the residuals r_k = d_k - v dt_k,
 *
 *     q = (sum |r_k|^2 / 2 - e) / (T - sum dt_k^2 / T),
 *
 * where e is what the variances of the fixes alone would give; never below 0. Weighting the
 * residuals by time rather than each |r_k|^2/dt_k keeps two fixes minutes apart, whose difference
 * is error of position, from deciding it. When the fixes' errors are not given they are part of q.
 *
 * Fixes of the last `window_s` are used; when only the last lies there, the last two.
 * Assumes that v is constant over the window: its changes are part of q. With `rules.drift` they
 * are not, and v is that of the last fix.
 */
[[nodiscard]] TrackEstimate estimateTrack(std::span<const Fix> fixes, const TrackRules& rules = {});

/**
 * The track with fewer entries, all of them its own, the first and the last included: at no time of
 * an entry left out is it farther than `tolerance_m` from it. Cost: linear (swinging door).
 */
[[nodiscard]] RecordedTrack thinned(const RecordedTrack& track, double tolerance_m);

} // namespace berg
