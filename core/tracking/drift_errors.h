#pragma once

#include "core/earth/geodesy.h"
#include "core/tracking/drift_path.h"

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace berg {

/** A recorded position of an iceberg; times are seconds on the clock of the forcing. */
struct PlacedFix
{
    double time_s = 0;
    LatLon place;
};

/** Positions of one iceberg, times rising. */
using PlacedTrack = std::vector<PlacedFix>;

/**
 * Returns the position at a time, linear between its neighbours, or nullopt if the time is outside
 * the track or between two fixes more than `longestGap_s` apart.
 */
[[nodiscard]] std::optional<LatLon> placeAt(const PlacedTrack& track, double time_s,
                                            double longestGap_s);

/** Rules of a comparison of predicted with recorded drift. */
struct DriftErrorRules
{
    std::vector<double> leads_s{6 * 3600.0, 12 * 3600.0, 24 * 3600.0, 48 * 3600.0}; ///< rising
    double lastVelocityOver_s = 3 * 3600.0; ///< time over which the last velocity is measured
    double longestGap_s = 6 * 3600.0;       ///< between two fixes of a track
    double startsApart_s = 3600;            ///< least time between two predictions
    std::size_t mostStarts = 2000;          ///< more are thinned evenly
};

/** Mean distances after one lead, over the same starts. */
struct DriftLeadError
{
    double lead_s = 0;
    std::size_t starts = 0;    ///< number of predictions; without any the distances are 0
    double moved_m = 0;        ///< distance moved: error of the prediction that it stays
    double drift_m = 0;        ///< error of the law
    double lastVelocity_m = 0; ///< error of the prediction that it keeps its last velocity
    bool operator==(const DriftLeadError&) const = default;
};

/**
 * Predicts the drift from fixes of the tracks and compares it with the position recorded later. A
 * start counts for a lead if the recorded positions before and after it and the forcing up to it
 * are known. Throws `Stopped` if a stop is requested.
 */
[[nodiscard]] std::vector<DriftLeadError> driftErrors(std::span<const PlacedTrack> tracks,
                                                      const DriftLaw& law, const ForcingAt& forcing,
                                                      const DriftErrorRules& rules = {},
                                                      const std::stop_token& stop = {});

} // namespace berg
