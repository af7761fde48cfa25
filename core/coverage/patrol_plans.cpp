#include "core/coverage/patrol_plans.h"

#include "core/coverage/coverage_settings.h"
#include "core/coverage/patrol_tours.h"
#include "core/coverage/visit_covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace berg {

namespace {

/** Time of the aimed legs before a patrol, whose mean wind it is planned for. */
constexpr double kAimed_s = 800;

/** Aimed plans of 800 s fly shorter rounds as well, for less work. */
constexpr double kShortestRound_s = 800;
constexpr double kShortestRoundOn_s = 600;
/** Runs of this length at most are planned to their end by aimed plans. */
constexpr double kShortRun_s = 1000;
/** Length of a patrol in rounds. */
constexpr double kRoundsOfPatrol = 2;
constexpr double kLeastOfPatrol_s = 3600;
/** A run that is less than this many times as long as a patrol is planned to its end. */
constexpr double kWholePatrol = 1.25;
/** An iceberg this near, in half extents of the view, is seen. */
constexpr double kReachOfView = 1;
/** Endurance that a patrol leaves unused: the reserve for the path home, and that of some visits.
 */
constexpr double kSortieReserve_s = kHomeReserve_s + 3 * kVisitReserve_s;

/** Duration for which an iceberg is in view, in the mean, when a UAV passes it. */
constexpr double kPass_s = 20;

constexpr std::size_t kStarts = 4;
constexpr PatrolEffort kFirstEffort{.startMoves = 35'000, .moves = 120'000, .headWork = 1'200'000};
constexpr PatrolEffort kNextEffort{.moves = 5'000, .headWork = 200'000};
/** Durations of a move with several UAVs and with sorties, relative to one of a single UAV. */
constexpr double kCostOfFleetMove = 1.5;
constexpr double kCostOfSortieMove = 1.4;
/**
 * Later plans of more icebergs than this have more moves in proportion, up to a limit. Moves of
 * large fields take longer, so their first plans have fewer.
 */
constexpr double kIcebergsOfEffort = 50;
constexpr double kMostEffort = 2;
constexpr double kPowerOfFirst = 0.75;
/** Temperatures at the beginning, as shares of the mean cost of a visit. */
constexpr double kHeatOfStart = 0.2;
constexpr double kHeatOfNext = 0.1;

constexpr std::size_t kLeastLegs = 5;
constexpr std::size_t kMostLegsOfHead = 40;
constexpr double kHead_s = 800;

double runEnd_s(const PredictionInput& input)
{
    return input.laterSorties ? input.laterSorties->runEnd_s : input.until_s;
}

double runLeft_s(std::span<const PredictionInput> inputs)
{
    double longest_s = 0;
    for (const PredictionInput& input : inputs)
        longest_s = std::max(longest_s, runEnd_s(input) - input.time_s);
    return longest_s;
}

/** Returns the ratio of the total time to the time in the air. */
double groundFactor(const PredictionInput& input)
{
    if (!input.laterSorties)
        return 1;
    const SortieSpec& spec = input.laterSorties->spec;
    return 1 + spec.turnaround_s / std::max(1.0, spec.endurance_s - kSortieReserve_s);
}

PatrolUav patrolUav(const PredictionInput& input, const CoverageLimits& limits)
{
    PatrolUav uav{.start = poseOf(input.uav),
                  .speed_mps = input.motion.airspeed_mps,
                  .radius_m = input.motion.airspeed_mps / input.motion.limit_radps,
                  .reach_m = kReachOfView * input.sensor.fov_m.minCoeff() / 2,
                  .until_s = runEnd_s(input) - input.time_s,
                  .first = limits.first,
                  .any = limits.any};
    if (input.reachRadius_m)
        uav.reach_m = std::min(uav.reach_m, *input.reachRadius_m);
    if (input.laterSorties) {
        const SortieSpec& spec = input.laterSorties->spec;
        uav.sorties = {
            .home = {.place_m = spec.home_m, .velocity_mps = -meanWind_mps(input, kAimed_s)},
            .left_s = input.until_s - input.time_s - kSortieReserve_s,
            .length_s = spec.endurance_s - kSortieReserve_s,
            .ground_s = spec.turnaround_s};
    }
    return uav;
}

/** Excludes icebergs that no sortie reaches, because visits after them would never be flown. */
void keepWithinSorties(PatrolUav& uav, std::span<const PatrolIceberg> icebergs, double length_s)
{
    /** This allows for two half circles and the drift. */
    constexpr double kTurns = 6.3;
    if (!uav.sorties)
        return;
    const PatrolSorties& sorties = *uav.sorties;
    if (uav.any.empty())
        uav.any.assign(icebergs.size(), true);
    for (std::size_t i = 0; i < icebergs.size(); ++i) {
        double away_m = 0;
        for (const double time_s : {0.0, std::min(length_s, uav.until_s)})
            away_m =
                std::max(away_m, (icebergs[i].place.at(time_s) - sorties.home.at(time_s)).norm());
        const double there_m = std::max(0.0, away_m - uav.reach_m);
        if ((2 * there_m + kTurns * uav.radius_m) / uav.speed_mps > sorties.length_s)
            uav.any[i] = false;
    }
}

} // namespace

bool needsPatrol(std::span<const PredictionInput> inputs, LastPlan last)
{
    const PredictionInput& input = inputs.front();
    const auto fades = [](const Track& track) { return track.velocityTime_s > 0; };
    if (std::ranges::any_of(input.tracks, fades))
        return false;
    if (input.observer.model != ObserverModel::Simple && last != LastPlan::None)
        return last == LastPlan::Patrol;
    return runLeft_s(inputs) > kShortRun_s &&
           round_s(inputs) > (last == LastPlan::Patrol ? kShortestRoundOn_s : kShortestRound_s);
}

bool knowsVelocities(std::span<const PredictionInput> inputs)
{
    constexpr double kShareOfView = 0.25;
    const PredictionInput& input = inputs.front();
    const double far_m = kShareOfView * input.sensor.fov_m.minCoeff();
    const double round_s = berg::round_s(inputs);
    return std::ranges::all_of(input.tracks, [&](const Track& track) {
        return track.status == TrackStatus::Tracked &&
               std::sqrt(track.velocity_m2ps2) * round_s < far_m;
    });
}

double patrolLength_s(std::span<const PredictionInput> inputs)
{
    const double ahead_s = std::max(kLeastOfPatrol_s, kRoundsOfPatrol * round_s(inputs) *
                                                          groundFactor(inputs.front()));
    const double left_s = runLeft_s(inputs);
    return left_s <= kWholePatrol * ahead_s ? left_s : ahead_s;
}

std::vector<PatrolIceberg> patrolIcebergs(std::span<const PredictionInput> inputs)
{
    const PredictionInput& input = inputs.front();
    const double round_s = berg::round_s(inputs);
    std::vector<PatrolIceberg> icebergs;
    for (std::size_t i = 0; i < input.tracks.size(); ++i) {
        const Track& track = input.tracks[i];
        const double weight = input.weights.empty() ? 1 : input.weights[i];
        const VisitCovariance account(track, input.observer, weight);
        DriftVariances known = account.start();
        PatrolIceberg& iceberg = icebergs.emplace_back();
        iceberg.place = {.place_m = track.estimate_m(input.time_s),
                         .velocity_mps = track.velocity_mps - meanWind_mps(input, kAimed_s)};
        for (std::size_t stage = 0; stage < PatrolIceberg::kStages; ++stage) {
            if (stage > 0) {
                account.grow(known, stage == 1 ? round_s / 2 : round_s);
                account.sample(known, kPass_s);
            }
            iceberg.growth[stage] = {.base_m2 = known.position_m2,
                                     .rate_m2ps = weight * track.q_m2ps + 2 * known.mixed_m2ps,
                                     .bend_m2ps2 = known.velocity_m2ps2};
        }
    }
    return icebergs;
}

PatrolProblem patrolProblem(std::span<const PredictionInput> inputs,
                            std::span<const CoverageLimits> limits)
{
    PatrolProblem problem{.icebergs = patrolIcebergs(inputs), .length_s = patrolLength_s(inputs)};
    for (std::size_t u = 0; u < inputs.size(); ++u) {
        problem.uavs.push_back(patrolUav(inputs[u], limits[u]));
        keepWithinSorties(problem.uavs.back(), problem.icebergs, problem.length_s);
    }
    return problem;
}

PatrolEffort patrolEffort(const PatrolProblem& problem, bool isFirst,
                          std::optional<std::int64_t> workLimit)
{
    PatrolEffort effort = isFirst ? kFirstEffort : kNextEffort;
    const double cost = (problem.uavs.size() > 1 ? kCostOfFleetMove : 1) *
                        (problem.uavs.front().sorties ? kCostOfSortieMove : 1);
    effort.startMoves = std::llround(static_cast<double>(effort.startMoves) / cost);
    effort.moves = std::llround(static_cast<double>(effort.moves) / cost);
    const double large =
        std::max(1.0, static_cast<double>(problem.icebergs.size()) / kIcebergsOfEffort);
    double scale = isFirst ? std::pow(large, -kPowerOfFirst) : std::min(large, kMostEffort);
    if (workLimit) {
        const std::int64_t moves =
            effort.startMoves * static_cast<std::int64_t>(kStarts) + effort.moves;
        const std::int64_t work = moves * PatrolEffort::kWorkOfMove + effort.headWork;
        scale = std::min(scale, static_cast<double>(*workLimit) / static_cast<double>(work));
    }
    for (std::int64_t* part : {&effort.startMoves, &effort.moves, &effort.headWork})
        *part = std::llround(scale * static_cast<double>(*part));
    return effort;
}

void findPatrol(PatrolSearch& search, const PatrolRoutes& start, const Random& random,
                const PatrolEffort& effort, const SolveWatch& watch)
{
    Random tours = random;
    PatrolRoutes best;
    double best_m2s = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kStarts + (start.empty() ? 0 : 1); ++k) {
        if (k == kStarts)
            search.set(start);
        else if (k + 1 == kStarts)
            search.set(PatrolRoutes(search.problem().uavs.size()));
        else
            search.set(patrolRounds(search.problem(), {.reversed = k == 1}, tours));
        search.extend();
        search.improve(effort.startMoves, kHeatOfStart, watch);
        if (search.cost_m2s() < best_m2s) {
            best_m2s = search.cost_m2s();
            best = search.routes();
        }
    }
    search.set(std::move(best));
    search.improve(effort.moves, kHeatOfNext, watch);
}

void improvePatrol(PatrolSearch& search, PatrolRoutes rest, const PatrolEffort& effort,
                   const SolveWatch& watch)
{
    search.set(std::move(rest));
    search.extend();
    search.improve(effort.moves, kHeatOfNext, watch);
}

std::vector<std::size_t> headsOf(const PatrolSearch& search)
{
    // All heads end at one time, so all sightings in a UAV's head are before the others' tails.
    const std::size_t uavs = search.problem().uavs.size();
    double end_s = kHead_s;
    for (std::size_t u = 0; u < uavs; ++u)
        for (const PatrolStop& stop :
             search.stops(u).first(std::min(search.stops(u).size(), kLeastLegs))) {
            if (stop.tookOff)
                break;
            end_s = std::max(end_s, stop.time_s);
        }
    std::vector<std::size_t> heads;
    for (std::size_t u = 0; u < uavs; ++u) {
        const std::span<const PatrolStop> stops = search.stops(u);
        std::size_t head = 0;
        while (head < std::min(stops.size(), kMostLegsOfHead) && stops[head].time_s <= end_s &&
               !stops[head].tookOff)
            ++head;
        heads.push_back(head);
    }
    return heads;
}

CoveragePlan legsOf(const PatrolSearch& search, std::size_t uav, const PatrolPart& part,
                    const CoverageModel& model)
{
    constexpr double kNoLeg_m = 1;
    CoveragePlan plan;
    for (std::size_t k = part.begin; k < part.end; ++k) {
        const PatrolStop& stop = search.stops(uav)[k];
        const int iceberg = search.visits(uav)[k];
        CoverageLeg& leg = plan.emplace_back(CoverageLeg{.iceberg = ModelPlace::of(iceberg)});
        const Point from_m =
            k > 0 ? search.stops(uav)[k - 1].place_m : search.problem().uavs[uav].start.position_m;
        const Point path_m = stop.place_m - from_m;
        if (path_m.norm() < kNoLeg_m)
            continue;
        const DriftingPlace& place =
            search.problem().icebergs[static_cast<std::size_t>(iceberg)].place;
        const Point there_m = place.at(stop.time_s) - from_m;
        leg.offset_m = std::clamp(cross(Point(path_m.normalized()), there_m),
                                  -model.largestOffset_m(), model.largestOffset_m());
    }
    return plan;
}

} // namespace berg
