#pragma once

#include "core/plan/policy/plan.h"
#include "core/plan/policy/policy_table.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** Planner settings of a scenario. */
struct PlannerSettings
{
    PolicyKind policy = PolicyKind::Visitation;
    /** Trade-off of Eq. (14): 0 visits by uncertainty, large values take the shortest path. */
    double tau = 1;
    Route route = Route::Open;
    Backend backend = Backend::Auto;
    Formulation formulation = Formulation::Position;
    bool operator==(const PlannerSettings&) const = default;
};

struct PredictionInput; // core/coverage

/** The part of a request that concerns one UAV. */
struct UavRequest
{
    int uav = 0; ///< the caller's number of the UAV
    /**
     * Distances, N x N as in `TvpProblem::distance_m`, row and column 0 for the UAV. The unit is
     * the same for all UAVs: flight time times `PlanRequest::speed_mps`.
     */
    Eigen::MatrixXd distance_m;
    /**
     * N-1: whether the iceberg may be planned for this UAV, i.e. is neither in view nor just
     * reached nor assigned to another UAV.
     */
    std::vector<bool> available;
    IcebergList assigned = {}; ///< icebergs assigned to this UAV alone
    /** Input of policies that predict the flight themselves; may be null for the others. */
    std::shared_ptr<const PredictionInput> prediction;
    /** Available icebergs that remain of the last answer: the warm start, set by `Planner`. */
    IcebergList lastRest = {};
};

/** Input of a plan, at the instant of planning. */
struct PlanRequest
{
    std::vector<UavRequest> uavs; ///< at least one UAV; all are planned together
    IcebergList ids;              ///< N-1: iceberg of node k+1, for all icebergs
    std::vector<double> sigma_m2; ///< N values, as in `TvpProblem::sigma_m2`
    double speed_mps = 0;         ///< airspeed of the first UAV of the scenario
    /**
     * Clusters, icebergs that are planned as one node: two or more icebergs each, ascending, of
     * which `ids` holds the first.
     */
    std::vector<IcebergList> clusters;
    /**
     * Distances between the UAVs, in the unit of `UavRequest::distance_m`, for Eq. (14). Not read
     * for a single UAV.
     */
    Eigen::MatrixXd betweenUavs_m;
};

/** Chooses the orders in which icebergs are visited. One object serves one mission. */
class Policy
{
public:
    Policy() = default;
    Policy(const Policy&) = delete;
    Policy& operator=(const Policy&) = delete;
    virtual ~Policy() = default;

    /**
     * Returns the orders to fly now. An answer without orders means that a limit was reached before
     * any plan, that the request was cancelled (`StopReason::Cancelled`), or that no iceberg is
     * available. `options.onProgress` receives `SolveProgress::orders`, one for each UAV of the
     * request.
     * Throws as `solveFleet` and `TvpSolver::solve` do, and `std::logic_error` for an invalid
     * request; the policy latency needs a `speed_mps` above 0.
     */
    [[nodiscard]] virtual Plan plan(const PlanRequest& request, const SolveOptions& options) = 0;
};

/**
 * Returns the policy of the settings, which solves with their back end; problems of one UAV go to
 * `solver` (borrowed, must outlive the policy). UAVs to which no iceberg is available are left out
 * of a plan, as are icebergs that no UAV may visit.
 *
 * - visitation: Eq. (1) with mu of Eq. (14), legs as in `visitationTask`; solved again at every
 *   iceberg reached.
 * - latency: least sum sigma_i t_i, t_i the predicted arrival times; neither tau nor the route has
 *   an effect, and if all sigma are 0 it plans by distance alone, as does Eq. (14). Solved again at
 *   every iceberg reached.
 * - path: least total distance; the plan is kept until every UAV has flown its part or the
 *   icebergs of the request change.
 * - nearest: repeatedly adds the iceberg with the least distance from the end of any order. Ties go
 *   to the smallest node, then to the first UAV. Each UAV gets a first iceberg before any UAV gets
 *   a second one.
 * - uncertainty: largest sigma first, for the UAV whose order ends nearest to it. Ties go to the
 *   smallest node. Each UAV gets a first iceberg before any UAV gets a second one.
 * - tour: `makeTour`.
 *
 * Throws `Error{Unsupported}` for policies that this function does not make, or not with that back
 * end.
 */
[[nodiscard]] std::unique_ptr<Policy> makePolicy(const PlannerSettings& settings,
                                                 const TvpSolver& solver);

/** Type of `makePolicy`, and of functions of other modules that make more policies. */
using PolicyMaker = std::unique_ptr<Policy> (*)(const PlannerSettings&, const TvpSolver&);

} // namespace berg
