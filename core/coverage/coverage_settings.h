#pragma once

#include "core/base/index.h"
#include "core/coverage/coverage_model.h"
#include "core/plan/problem/tvp.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace berg {

// This file sets the effort of `coverage` and its starting plans, for one UAV and for several.

/**
 * Work of the first plan and of each later one, which take about 200 ms and 5 ms on an idle core
 * with the simple observer. Under load it takes longer, with the Kalman observer up to seconds.
 */
inline constexpr std::int64_t kFirstWork = 8'000'000;
inline constexpr std::int64_t kNextWork = 200'000;
/**
 * The first plan gets this many times the work if keeping icebergs in view pays, because there is
 * more to choose.
 */
inline constexpr std::int64_t kWorkOfSamples = 2;
/** Each start gets this share of the first work; the best of them gets the rest. */
inline constexpr double kShareOfStart = 0.15;
/** Work of each order that the search starts from, in the solver's units. */
inline constexpr std::int64_t kOrderWork = 5'000'000;
/**
 * Work of the orders that are flown while velocities are unknown, in the solver's units: the first
 * one and each later one.
 */
inline constexpr std::int64_t kFirstOrderWork = 150'000'000;
inline constexpr std::int64_t kNextOrderWork = 3'000'000;
/** Temperature at which searches begin, as a share of the predicted cost. */
inline constexpr double kHeat = 0.0008;
/**
 * If keeping icebergs in view pays and the rest of the last plan costs `kSetback` times its
 * predicted cost, another order may be far better. The next plan then gets `kWorkOfSetback` times
 * the work, all but the last part of it at `kHeatOfSetback` times the temperature.
 */
inline constexpr double kSetback = 1.02;
inline constexpr std::int64_t kWorkOfSetback = 6;
inline constexpr double kHeatOfSetback = 10;
/** Number of rounds of a tour, which is more than a horizon usually holds; greedy legs follow. */
inline constexpr int kRounds = 20;

/**
 * Returns the horizon of aimed plans: the longest remaining flight, at most 800 s. If keeping
 * icebergs in view pays, the limit is the duration of two visits to each iceberg or of 40 legs, if
 * that is longer. `inputs` has one entry for each UAV, with the same tracks and at least one
 * iceberg.
 */
[[nodiscard]] CoverageHorizon horizonOf(std::span<const PredictionInput> inputs);

/**
 * Returns an estimate of the time in seconds that the UAVs of the inputs need, together, to fly
 * to each iceberg once; 0 with fewer than two icebergs. The calculation takes time in proportion to
 * the square of the number of icebergs.
 */
[[nodiscard]] double round_s(std::span<const PredictionInput> inputs);

/** Returns whether any weight of the input differs from 1. */
[[nodiscard]] bool isWeighted(const PredictionInput& input);

/**
 * Returns legs straight to the icebergs in this order of nodes, this many times.
 */
[[nodiscard]] CoveragePlan straightPlan(const VisitOrder& order, int rounds);

/** A leg with an identification of its destination that stays valid during the flight. */
struct KeptLeg
{
    std::optional<IcebergIndex> id = {}; ///< Iceberg of the mission; nullopt for a hold.
    Point offset_m = Point::Zero(); ///< Offset of the place from the estimate of a lost iceberg.
    CoverageLeg leg; ///< The leg, with the place number of the plan it was kept from.
};

using KeptPlan = std::vector<KeptLeg>;

/**
 * Returns the legs of a plan with the icebergs and offsets of their destinations. `ids` are the
 * model's icebergs, in its order.
 */
[[nodiscard]] KeptPlan keptPlan(const CoveragePlan& plan, const CoverageModel& model,
                                std::span<const IcebergIndex> ids);

/**
 * Returns an earlier plan in the places of the present model. A leg to a lost iceberg goes to the
 * place that is now nearest, and legs to icebergs that no longer exist are left out. Legs to
 * icebergs that have come into view since are dropped when the plan is flown. `ids` are the
 * model's icebergs, in its order.
 */
[[nodiscard]] CoveragePlan restOf(const KeptPlan& plan, const CoverageModel& model,
                                  std::span<const IcebergIndex> ids);

/** Shortens the first leg by the time flown since the plan was made, and drops it if it is over. */
void shorten(CoveragePlan& plan, const CoverageModel& model, const PredictionInput& input,
             double flown_s);

} // namespace berg
