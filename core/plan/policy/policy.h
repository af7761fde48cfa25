#pragma once

#include "core/plan/fleet/fleet_problem.h"
#include "core/plan/policy/policy_table.h"
#include "core/plan/solve/solver.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** The knobs of planning that a scenario stores. */
struct PlannerSettings
{
    PolicyKind policy = PolicyKind::Visitation;
    double tau = 1; ///< trade-off of Eq. (14); 0 most uncertain first, large shortest path
    Route route = Route::Open;
    Backend backend = Backend::Auto;
    Formulation formulation = Formulation::Position;
    bool operator==(const PlannerSettings&) const = default;
};

struct FlightPicture; // core/coverage

/** What a request says of one UAV. */
struct UavRequest
{
    int uav = 0; ///< the caller's own number of it
    /** N x N as `TvpProblem::distance_m`, row and column 0 the UAV; in one unit for all UAVs:
     * flight time times `PlanRequest::speed_mps`. */
    Eigen::MatrixXd distance_m;
    std::vector<bool> available;    ///< N-1: may be planned for this UAV, i.e. neither in view nor
                                    ///< just reached nor another UAV's
    std::vector<int> assigned = {}; ///< ids of those that are kept for this UAV alone
    /** For policies that predict the flight itself; the others do without. */
    std::shared_ptr<const FlightPicture> picture;
    /** What remains of its last answer (available ids), the warm start; the planner's part. */
    std::vector<int> lastRest = {};
};

/** The picture at the instant of planning. Ids are the caller's own numbers of icebergs. */
struct PlanRequest
{
    std::vector<UavRequest> uavs; ///< planned together, at least one
    std::vector<int> ids;         ///< N-1: id of iceberg node k+1, of every iceberg there is
    std::vector<double> sigma_m2; ///< N, as `TvpProblem::sigma_m2`
    double speed_mps = 0;         ///< airspeed, of the first UAV of the scenario
    /**
     * Icebergs that share a node, which is planned as one: two or more ids each, ascending, of
     * which `ids` holds the first.
     */
    std::vector<std::vector<int>> clusters;
    /** Distances between the UAVs, in the unit of `UavRequest::distance_m`; for Eq. (14). Not read
     * with one UAV. */
    Eigen::MatrixXd betweenUavs_m;
};

/** What one UAV is to fly. */
struct UavAnswer
{
    std::vector<int> order;     ///< ids in visiting order, the first one available; may be empty
    std::vector<AimedLeg> legs; ///< how to fly it; empty: straight to the first
    std::optional<AimedOutlook> outlook; ///< of `legs`
};

struct PlanAnswer
{
    /** One for each of `PlanRequest::uavs`, no iceberg the first one of two of them. */
    std::vector<UavAnswer> uavs;
    std::vector<std::vector<int>> clusters; ///< of the request; all in an order, one after another
    SolveOutcome outcome; ///< of the solve behind it; its nodes are those of `problem`
    FleetProblem problem; ///< what was solved (`visitationTask`); empty when no solve was needed
    std::vector<int> solvedIds; ///< id of node k+1 of `problem`
    bool fellBack = false;      ///< no order from the solver: the rests of the last plan are flown
    std::string failure;        ///< why, when the policy threw; English
    std::optional<double> predictedZeta_m2s; ///< what the legs were judged by
    std::optional<double> gap;               ///< relative, of `outcome`
    /** Of the plan, in the unit of `UavRequest::distance_m`; return legs of closed routes included.
     */
    double distance_m = 0;
};

/** Chooses the orders in which icebergs are flown to. One object serves one mission. */
class Policy
{
public:
    Policy() = default;
    Policy(const Policy&) = delete;
    Policy& operator=(const Policy&) = delete;
    virtual ~Policy() = default;

    /**
     * The orders to fly now. An answer without any means that a limit came before any plan, or
     * that there is nothing to plan (no iceberg available). `options.onProgress` is told orders in
     * ids, one for each UAV of the request.
     */
    [[nodiscard]] virtual PlanAnswer plan(const PlanRequest& request,
                                          const SolveOptions& options) = 0;
};

/**
 * The policy of the settings, which solves with the back end of the settings, for one UAV alone
 * with `solver` (borrowed, must outlive the policy). UAVs to which no iceberg is available have no
 * part in a plan, and icebergs that none may visit are left out.
 *
 * - visitation: Eq. (1) with mu of Eq. (14), legs as in `visitationTask`. latency: least sum
 * sigma_i t_i, t_i the predicted arrival times; neither tau nor the route matters, and with all
 * sigma 0 it is by distance alone, as Eq. (14) has it. Both are solved again at every iceberg
 * reached.
 * - path: least distance in all, kept until every UAV has flown its part.
 * - nearest: again and again the least distance from the end of any order. uncertainty: largest
 *   sigma first, to the UAV that has the least way to it from the end of its order. Ties go to the
 *   smallest node, then to the first UAV.
 * - tour: `makeTour`.
 *
 * Throws `Error{Unsupported}` for policies this version does not fly, or not with that back end.
 */
[[nodiscard]] std::unique_ptr<Policy> makePolicy(const PlannerSettings& settings,
                                                 const TvpSolver& solver);

/** `makePolicy`, or a function of another module that knows more policies. */
using PolicyMaker = std::unique_ptr<Policy> (*)(const PlannerSettings&, const TvpSolver&);

} // namespace berg
