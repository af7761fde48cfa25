#pragma once

#include "core/plan/solve/names.h"
#include "core/plan/solve/solver.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace berg {

/** How the next iceberg is chosen. Names: `kPolicyNames`. */
enum class PolicyKind
{
    Visitation,
    Path,
    Tour,
    Nearest,
    Uncertainty,
    Latency,
    Coverage
};

inline constexpr std::array<Named<PolicyKind>, 7> kPolicyNames{{
    {PolicyKind::Visitation, "visitation"},
    {PolicyKind::Path, "path"},
    {PolicyKind::Tour, "tour"},
    {PolicyKind::Nearest, "nearest"},
    {PolicyKind::Uncertainty, "uncertainty"},
    {PolicyKind::Latency, "latency"},
    {PolicyKind::Coverage, "coverage"},
}};

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

/** What a request says of one UAV of several. */
struct UavRequest
{
    int uav = 0; ///< the caller's own number of it
    /** As `PlanRequest::problem`, row and column 0 the UAV; in one unit for the fleet: flight time
     * times `PlanRequest::speed_mps`. */
    Eigen::MatrixXd distance_m;
    std::vector<bool> available;                  ///< N-1: may be planned for this UAV
    std::shared_ptr<const FlightPicture> picture; ///< of this UAV
    /** What remains of its last answer (available ids), the warm start; the planner's part. */
    std::vector<int> lastRest = {};
};

/** The picture at the instant of planning. Ids are the caller's own numbers of icebergs. */
struct PlanRequest
{
    TvpProblem problem;          ///< UAV and every iceberg there is; `mu` and `route` are not read
    std::vector<int> ids;        ///< N-1: id of iceberg node k+1
    std::vector<bool> available; ///< N-1: may be planned, i.e. neither in view nor just reached
    double speed_mps = 0;        ///< airspeed
    /**
     * Icebergs that share a node, which is planned as one: two or more ids each, ascending, of
     * which `ids` holds the first.
     */
    std::vector<std::vector<int>> clusters;
    /** For policies that predict the flight itself; the others do without. */
    std::shared_ptr<const FlightPicture> picture;
    /**
     * Of several UAVs that are planned together, two or more: then they stand for the distances of
     * `problem`, for `available` and for `picture`, which are those of the first one.
     */
    std::vector<UavRequest> fleet;
    /** Distances between the UAVs, in the unit of `UavRequest::distance_m`; for Eq. (14). */
    Eigen::MatrixXd betweenUavs_m;
};

/** What one UAV of several is to fly. */
struct UavAnswer
{
    std::vector<int> order;     ///< ids in visiting order, the first one available; may be empty
    std::vector<AimedLeg> legs; ///< how to fly it; empty: straight to the first
    std::optional<AimedOutlook> outlook; ///< of `legs`
};

struct PlanAnswer
{
    std::vector<int> order; ///< ids in visiting order, the first one available; may be empty
    std::vector<std::vector<int>> clusters; ///< of the request; all in `order`, one after another
    SolveOutcome outcome;       ///< of the solve behind it; its nodes are those of `problem`
    TvpProblem problem;         ///< what was solved; empty when no solve was needed
    std::vector<int> solvedIds; ///< id of node k+1 of `problem`
    bool fellBack = false;      ///< no order from the solver: the rest of the last plan is flown
    std::string failure;        ///< why, when the policy threw; English
    std::vector<AimedLeg> legs; ///< how to fly it; empty: straight to the first of `order`
    std::optional<double> predictedZeta_m2s; ///< what `legs` were judged by
    std::optional<AimedOutlook> outlook;     ///< of `legs`
    /**
     * One for each of `PlanRequest::fleet`, no iceberg the first one of two of them; then `order`,
     * `legs` and the order of `outcome` are empty, and `problem` has criterion and mu alone.
     */
    std::vector<UavAnswer> fleet;
    std::optional<double> gap; ///< relative, of a fleet
    /** Of a fleet: the sum over its orders, in the unit of `UavRequest::distance_m`; ways back on
     * closed routes included. */
    double distance_m = 0;
};

/** What the policies `visitation` and `latency` solve in answer to a request; `mu` is 0. */
struct VisitationProblem
{
    TvpProblem problem;   ///< the UAV and the available icebergs
    std::vector<int> ids; ///< id of iceberg node k+1
};

[[nodiscard]] VisitationProblem visitationProblem(const PlanRequest& request, Route route);

/** Chooses the order in which icebergs are flown to. One object serves one mission. */
class Policy
{
public:
    Policy() = default;
    Policy(const Policy&) = delete;
    Policy& operator=(const Policy&) = delete;
    virtual ~Policy() = default;

    /**
     * The order to fly now. `lastRest` is what remains of the last answer (available ids), the
     * warm start; of several UAVs it is `UavRequest::lastRest`. An answer without order means that
     * a limit came before any plan, or that there is nothing to plan (no iceberg available).
     * `options.onProgress` is told orders in ids.
     */
    [[nodiscard]] virtual PlanAnswer plan(const PlanRequest& request, std::span<const int> lastRest,
                                          const SolveOptions& options) = 0;
};

/**
 * The policy of the settings, which solves with `solver` (borrowed, must outlive the policy).
 * Throws `Error{Unsupported}` for policies this version does not fly, or not with that back end.
 */
[[nodiscard]] std::unique_ptr<Policy> makePolicy(const PlannerSettings& settings,
                                                 const TvpSolver& solver);

/** `makePolicy`, or a function of another module that knows more policies. */
using PolicyMaker = std::unique_ptr<Policy> (*)(const PlannerSettings&, const TvpSolver&);

} // namespace berg
