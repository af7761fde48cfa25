#pragma once

#include "core/coverage/coverage_model.h"
#include "core/plan/solve/tvp.h"

#include <cstdint>
#include <span>
#include <vector>

namespace berg {

// How much the policy `coverage` does, and from what it starts; the same for one UAV and several.

/** Work of the first plan, and of each one after it: about 200 ms and 5 ms on an idle core with the
 * simple observer. Under load it takes longer, with the Kalman observer up to seconds. */
inline constexpr std::int64_t kFirstWork = 8'000'000;
inline constexpr std::int64_t kNextWork = 200'000;
/** Where looks pay there is more to choose, and the first plan takes so many times as long. */
inline constexpr std::int64_t kWorkOfLooks = 2;
/** Of the first work, for each plan to start from; the best of them gets the rest. */
inline constexpr double kShareOfStart = 0.15;
/** For each order to start from, in the solver's units. */
inline constexpr std::int64_t kOrderWork = 5'000'000;
/** Temperature at which searches begin, of the predicted cost. */
inline constexpr double kHeat = 0.0008;
/** Where looks pay and the rest of the last plan comes to so many times what the plan came to,
 * another order may be far better: the next plan takes so many times as long, and all but the last
 * of it is searched at so many times the temperature. */
inline constexpr double kSetback = 1.02;
inline constexpr std::int64_t kWorkOfSetback = 6;
inline constexpr double kHeatOfSetback = 10;
/** Rounds of a tour: more than a horizon holds, as a rule; greedy legs follow. */
inline constexpr int kRounds = 20;

/**
 * Up to the end of the run of the UAV that flies longest, or of a long one a part: 800 s, and where
 * looks pay as long as two visits to each iceberg take, 40 legs at most. `pictures`: one a UAV, of
 * the same tracks, an iceberg at least.
 */
[[nodiscard]] CoverageHorizon horizonOf(std::span<const FlightPicture> pictures);

[[nodiscard]] bool isWeighted(const FlightPicture& picture);

/** Straight at the icebergs in this order (nodes 1 ..), so many times. */
[[nodiscard]] CoveragePlan straightPlan(const VisitOrder& order, int rounds);

/** A leg with what it goes to, in words that stay the same in flight. */
struct KeptLeg
{
    int id = -1;                    ///< of the iceberg; of a hold: none
    Point offset_m = Point::Zero(); ///< from its estimate, where it is lost
    CoverageLeg leg;                ///< its iceberg is that of the plan it was kept from
};

using KeptPlan = std::vector<KeptLeg>;

/** `ids`: of the model's icebergs. */
[[nodiscard]] KeptPlan keptPlan(const CoveragePlan& plan, const CoverageModel& model,
                                std::span<const int> ids);

/**
 * A plan of before, for the icebergs there are now; of one that is lost to the place that is now
 * nearest. Legs to those that have come into view since are dropped when flown.
 */
[[nodiscard]] CoveragePlan restOf(const KeptPlan& plan, const CoverageModel& model,
                                  std::span<const int> ids);

/** What is left of a plan some time after it was made, when a first leg that is over is cut. */
void shorten(CoveragePlan& plan, const CoverageModel& model, const FlightPicture& picture,
             double flown_s);

} // namespace berg
