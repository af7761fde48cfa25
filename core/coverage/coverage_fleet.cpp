#include "core/coverage/coverage_fleet.h"

#include "core/coverage/described_fleet.h"
#include "core/coverage/fleet_coverage_search.h"
#include "core/plan/fleet/fleet_solver.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace berg {

namespace {

/** Plans of several UAVs take so much more work than those of one. */
constexpr std::int64_t kFleetFirstWork = kFirstWork * 3 / 2;
constexpr std::int64_t kFleetNextWork = kNextWork * 3 / 2;

using Plans = std::vector<CoveragePlan>;

/** The UAV that has the iceberg in view; none is sure: the one nearest to it. */
std::size_t viewerOf(const PlanRequest& request, std::size_t iceberg)
{
    std::size_t nearest = 0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (std::size_t u = 0; u < request.uavs.size(); ++u) {
        const FlightPicture& picture = *request.uavs[u].picture;
        const Point place_m = picture.tracks[iceberg].estimate_m(picture.time_s);
        const double away_m = (place_m - picture.uav.position_m).norm();
        if (away_m < nearest_m) {
            nearest = u;
            nearest_m = away_m;
        }
    }
    return nearest;
}

bool isInViewOf(const FlightPicture& picture, std::size_t iceberg)
{
    return FieldOfView(picture.sensor, picture.uav.position_m, picture.uav.psi_rad)
        .contains(picture.tracks[iceberg].estimate_m(picture.time_s));
}

/** Tracks say what is in view of any UAV; here each picture says what is in view of its own. */
std::vector<FlightPicture> ownPictures(const PlanRequest& request)
{
    std::vector<FlightPicture> own;
    for (const UavRequest& uav : request.uavs) {
        require(uav.picture != nullptr, "CoverageFleet: a UAV has no picture of its flight");
        own.push_back(*uav.picture);
    }
    for (std::size_t i = 0; i < request.ids.size(); ++i) {
        if (!own.front().tracks[i].inView)
            continue;
        bool isClear = false;
        for (FlightPicture& picture : own) {
            picture.tracks[i].inView = isInViewOf(picture, i);
            isClear = isClear || picture.tracks[i].inView;
        }
        if (!isClear)
            own[viewerOf(request, i)].tracks[i].inView = true;
    }
    return own;
}

/** All are judged by what comes until the last of them ends its flight. */
std::vector<CoverageModel> modelsOf(std::span<const FlightPicture> pictures,
                                    std::optional<double> rest_s = std::nullopt)
{
    FlightPicture longest{.time_s = pictures.front().time_s};
    for (const FlightPicture& picture : pictures)
        longest.until_s = std::max(longest.until_s, picture.until_s);
    CoverageHorizon horizon = horizonOf(longest);
    horizon.rest_s = rest_s.value_or(horizon.rest_s);
    std::vector<CoverageModel> models;
    for (const FlightPicture& picture : pictures) {
        horizon.flown_s = picture.until_s - picture.time_s;
        models.emplace_back(picture, horizon);
    }
    return models;
}

/** What is in view of a UAV now may be visited again later, by any of them. */
CoverageLimits limitsOf(const PlanRequest& request, std::size_t uav)
{
    CoverageLimits limits{.any = availableToAny(request), .first = request.uavs[uav].available};
    for (std::size_t k = 0; k < limits.any.size(); ++k)
        limits.any[k] = !limits.any[k] || limits.first[k];
    return limits;
}

/** All icebergs, as the fleet's orders see them, at tau = 1. */
FleetProblem fleetProblem(const PlanRequest& request)
{
    constexpr double kTau = 1;
    FleetProblem problem{.sigma_m2 = request.sigma_m2};
    problem.allowed.assign(request.uavs.size(), std::vector<bool>(problem.sigma_m2.size(), true));
    for (const UavRequest& uav : request.uavs)
        problem.distance_m.push_back(uav.distance_m);
    for (std::size_t k = 0; k < request.ids.size(); ++k) {
        const auto may = [k](const UavRequest& uav) { return uav.available[k]; };
        if (std::ranges::any_of(request.uavs, may)) // else in view now, and any may come later
            for (std::size_t u = 0; u < request.uavs.size(); ++u)
                problem.allowed[u][k + 1] = request.uavs[u].available[k];
    }
    problem.mu = fleetTuningWeight(problem, request.betweenUavs_m, kTau).mu;
    return problem;
}

/** The shortest tour over those icebergs, from the UAV and back. */
VisitOrder tourOf(TvpProblem problem, const VisitOrder& nodes, const SolveOptions& limits)
{
    problem.route = Route::Closed;
    problem.mu = 1;
    std::fill(problem.sigma_m2.begin(), problem.sigma_m2.end(), 0.0);
    const VisitOrder found =
        makeSolver(Backend::Auto)->solve(restrictedTo(problem, nodes), limits).order();
    VisitOrder tour;
    for (const int node : found)
        tour.push_back(nodes[static_cast<std::size_t>(node - 1)]);
    return tour;
}

/** Greedy, the fleet's orders at tau = 1, and round tours over what these give to each UAV. */
std::vector<Plans> firstPlans(const PlanRequest& request, const SolveOptions& limits)
{
    const FleetProblem problem = fleetProblem(request);
    FleetPlan orders = solveFleet(problem, Backend::Auto, limits).plan;
    orders.resize(request.uavs.size());
    Plans once;
    Plans round;
    for (std::size_t u = 0; u < orders.size(); ++u) {
        once.push_back(straightPlan(orders[u], 1));
        const TvpProblem own = problemOfUav(problem, static_cast<int>(u));
        round.push_back(straightPlan(tourOf(own, orders[u], limits), kRounds));
    }
    return {Plans(request.uavs.size()), once, round};
}

FleetCoverageSearch searchFor(const PlanRequest& request, std::span<const CoverageModel> models)
{
    std::vector<CoverageFlyer> flyers;
    for (std::size_t u = 0; u < models.size(); ++u)
        flyers.push_back({.model = models[u], .limits = limitsOf(request, u)});
    const FlightPicture& picture = *request.uavs.front().picture;
    return {std::move(flyers), picture.seed,
            stableHash("coverage") + static_cast<std::uint64_t>(picture.step)};
}

FleetCoverage first(FleetCoverageSearch& search, const PlanRequest& request,
                    const SolveOptions& options, const SolveWatch& watch)
{
    const std::int64_t work = options.workLimit.value_or(kFleetFirstWork);
    const auto share = static_cast<std::int64_t>(kShareOfStart * static_cast<double>(work));
    const SolveOptions limits{.timeLimit_s = options.timeLimit_s,
                              .workLimit = std::min(kOrderWork, work),
                              .stop = options.stop};
    std::optional<FleetCoverage> best;
    for (const Plans& start : firstPlans(request, limits)) {
        const FleetCoverage found =
            search.improved(search.completed(start), search.work() + share, kHeat, watch);
        if (!best || found.total_m2s < best->total_m2s)
            best = found;
    }
    return search.improved(*best, work, kHeat, watch);
}

FleetCoverage next(FleetCoverageSearch& search, const std::optional<Plans>& warm,
                   const SolveOptions& options, const SolveWatch& watch, std::size_t uavs)
{
    FleetCoverage start = search.completed(Plans(uavs));
    if (warm) {
        FleetCoverage rest = search.completed(*warm);
        if (rest.total_m2s <= start.total_m2s)
            start = std::move(rest);
    }
    return search.improved(start, options.workLimit.value_or(kFleetNextWork), kHeat, watch);
}

/** Predicted, without weights and with what comes after the horizon by `rest_s`. */
double zeta_m2s(std::vector<FlightPicture> pictures, std::optional<double> rest_s,
                std::span<const CoveragePlan> plans)
{
    for (FlightPicture& picture : pictures)
        picture.weights.clear();
    return fleetTotal_m2s(modelsOf(pictures, rest_s), plans);
}

double flown_m(const PlanRequest& request, std::span<const UavAnswer> answers)
{
    double sum_m = 0;
    for (std::size_t u = 0; u < answers.size(); ++u) {
        Eigen::Index from = 0;
        for (const int id : answers[u].order) {
            const auto it = std::find(request.ids.begin(), request.ids.end(), id);
            const Eigen::Index to = it - request.ids.begin() + 1;
            sum_m += request.uavs[u].distance_m(from, to);
            from = to;
        }
    }
    return sum_m;
}

/** The solve that found it is the caller's to tell of. */
PlanAnswer answerOf(const PlanRequest& request, std::span<const FlightPicture> pictures,
                    const FleetCoverage& found)
{
    const std::vector<FlightPicture> all(pictures.begin(), pictures.end());
    PlanAnswer answer{.uavs = describeFleet(modelsOf(pictures), request, found.plans)};
    answer.predictedZeta_m2s =
        isWeighted(all.front()) ? zeta_m2s(all, std::nullopt, found.plans) : found.total_m2s;
    const double outlook_m2s = zeta_m2s(all, 0, found.plans);
    for (UavAnswer& uav : answer.uavs)
        uav.outlook->zeta_m2s = outlook_m2s;
    answer.distance_m = flown_m(request, answer.uavs);
    return answer;
}

/** As `SolveProgress` of one UAV is told: a few tens a second at most. */
class FleetTeller
{
public:
    FleetTeller(std::span<const CoverageModel> models, const PlanRequest& request,
                const SolveOptions& options)
        : m_models(models), m_request(request), m_options(options)
    {
    }

    void operator()(const FleetCoverage& better)
    {
        constexpr double kBetween_s = 0.02;
        const double elapsed_s = m_clock.elapsed_s();
        if (elapsed_s < m_next_s)
            return;
        m_next_s = elapsed_s + kBetween_s;
        SolveProgress progress{.objective = better.total_m2s, .elapsed_s = elapsed_s};
        for (UavAnswer& uav : describeFleet(m_models, m_request, better.plans)) {
            progress.plan.push_back(std::move(uav.order));
            progress.legs.push_back(std::move(uav.legs));
        }
        m_options.onProgress(progress);
    }

private:
    std::span<const CoverageModel> m_models;
    const PlanRequest& m_request;
    const SolveOptions& m_options;
    Stopwatch m_clock;
    double m_next_s = 0;
};

} // namespace

PlanAnswer CoverageFleet::plan(const PlanRequest& request, const SolveOptions& options)
{
    const Stopwatch clock;
    const SolveWatch watch(options);
    const std::vector<FlightPicture> pictures = ownPictures(request);
    const std::vector<bool> any = availableToAny(request);
    PlanAnswer answer{.uavs = std::vector<UavAnswer>(request.uavs.size())};
    if (std::find(any.begin(), any.end(), true) != any.end()) {
        const std::vector<CoverageModel> models = modelsOf(pictures);
        FleetCoverageSearch search = searchFor(request, models);
        const bool isFirst = m_last.empty();
        if (options.onProgress && isFirst)
            search.setListener(FleetTeller(models, request, options));
        std::optional<Plans> warm;
        for (const UavRequest& uav : request.uavs)
            if (!uav.lastRest.empty() && !isFirst)
                warm = Plans();
        if (warm)
            for (const UavRequest& uav : request.uavs)
                warm->push_back(restOf(m_last[uav.uav], request.ids));
        const FleetCoverage found = isFirst
                                        ? first(search, request, options, watch)
                                        : next(search, warm, options, watch, request.uavs.size());
        const std::optional<StopReason> cut = watch.cut();
        if (cut == StopReason::Cancelled)
            return {.outcome = {.reason = StopReason::Cancelled, .backend = "coverage"}};
        answer = answerOf(request, pictures, found);
        answer.outcome.reason = cut.value_or(StopReason::WorkLimit);
        answer.outcome.work = search.work();
        answer.outcome.hintUsed = warm.has_value();
        m_last.clear();
        for (std::size_t u = 0; u < found.plans.size(); ++u)
            m_last[request.uavs[u].uav] = keptPlan(found.plans[u], request.ids);
    }
    answer.outcome.status = SolveStatus::Feasible;
    answer.outcome.backend = "coverage";
    answer.outcome.elapsed_s = clock.elapsed_s();
    return answer;
}

} // namespace berg
