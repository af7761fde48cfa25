#pragma once

#include "core/scenario/scenario.h"

#include <string_view>

namespace berg {

/**
 * What whoever flies a scenario would want to know before take-off, of one that has no errors:
 * icebergs and UAVs outside the area, icebergs that leave it, at one place, fast or out of reach,
 * UAVs that start near each other in one altitude layer,
 * recorded tracks that do not fit, turns too wide for the field of view, endurance and duration too
 * short, too little room inside the geofence, solvers at their limit, members that are kept but not
 * used. Called by `validate`.
 */
[[nodiscard]] std::vector<Issue> advice(const Scenario& scenario);

/** UAVs whose altitudes differ by less are in one layer, where they have to be kept apart. */
inline constexpr double kLayerHeight_m = 30;

/** Every message of `advice`, and some of `validate`; each is about one field, so they are also the
 * names of findings. */
namespace advised {

inline constexpr std::string_view kUnknownMembers =
    "members that this version does not know are kept, but not used";
inline constexpr std::string_view kAreaNoFence =
    "icebergs outside it are not monitored; the UAV may fly beyond it";
inline constexpr std::string_view kVelocitySdUnused = "is used with the observer kalman only";
inline constexpr std::string_view kSameLayer =
    "starts within separation_m of another UAV of the same altitude layer";
inline constexpr std::string_view kNoWayHome = "is too short for the way home from the start";
inline constexpr std::string_view kNoRoundTrip =
    "is too short for the way to the nearest iceberg and back";
inline constexpr std::string_view kHomeUnused = "is used with a limited endurance only";
inline constexpr std::string_view kHomeNearFence =
    "is so near the geofence that the UAV cannot take off there again and be sure to come home";
inline constexpr std::string_view kNoSafeReturn =
    "has, for this heading, no path home inside the geofence, so that no start is safe";
inline constexpr std::string_view kStartNearFence =
    "is so near the geofence, for this heading, that the UAV cannot turn inside it";
inline constexpr std::string_view kShutOff = "is so near the geofence that the UAV, to be within "
                                             "the acceptance radius, cannot be sent there";
inline constexpr std::string_view kSlowAutopilot =
    "is so long between two commands that the UAV cannot follow a leg";
inline constexpr std::string_view kFenceNoArea = "needs an area, area_m, to stay inside";
inline constexpr std::string_view kOutsideFence = "must be inside the area, which is a geofence";
inline constexpr std::string_view kFenceUnplanned =
    "this policy plans without the geofence; it is kept in flight";
inline constexpr std::string_view kUavOutside = "the UAV starts outside the area";
inline constexpr std::string_view kWideTurn =
    "the turn radius is larger than half the field of view, so that an iceberg may be missed";
inline constexpr std::string_view kReachInsideTurn =
    "is smaller than the turn radius, so that the UAV flies on and comes back";
inline constexpr std::string_view kOutsideArea = "lies outside the area";
inline constexpr std::string_view kLeavesArea = "drifts out of the area before the end of the run";
inline constexpr std::string_view kSamePlace = "lies where another iceberg lies: the same one?";
inline constexpr std::string_view kOutOfReach =
    "is so far away that the UAV cannot get there before the end of the run";
inline constexpr std::string_view kTooShort = "is over before the UAV can get to the first iceberg";
inline constexpr std::string_view kFast = "drifts faster than icebergs do: is the unit right?";
inline constexpr std::string_view kTrackShort =
    "ends before the run does; from then on the iceberg stands still";
inline constexpr std::string_view kTrackFar =
    "begins so far from the estimate that the UAV will not see the iceberg there";
inline constexpr std::string_view kAssetInIce = "lies inside an iceberg";
inline constexpr std::string_view kNoSigma =
    "no iceberg is uncertain at the start, so distance alone makes the first plan";
inline constexpr std::string_view kBeyondProof =
    "more than can be proven optimal; the plan comes with a bound";
inline constexpr std::string_view kClustersIgnored =
    "the policy plans icebergs one by one, so clusters are not made";
inline constexpr std::string_view kClustersOneUav =
    "clusters are planned for one UAV only, so with several they are not made";
inline constexpr std::string_view kSolverUnable =
    "cannot plan so many icebergs; the back end auto can";
inline constexpr std::string_view kLongProof =
    "proving the optimum of so many icebergs can take a minute and more";

} // namespace advised

} // namespace berg
