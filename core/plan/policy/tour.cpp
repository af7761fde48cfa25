#include "core/plan/policy/tour.h"

#include "core/plan/policy/fleet_task.h"
#include "core/plan/problem/assignment.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace berg {

namespace {

/** Nodes of the request in the order of the cycle. */
using Cycle = VisitOrder;

/** Entries of UAVs into a cycle: by UAV the position in the cycle, and sum sigma_i t_i. */
struct Entries
{
    Cycle cycle;
    std::vector<std::size_t> places;
    double waiting = 0;
};

/** Chooses the entries of those UAVs of a request that have something to visit. */
class EntryChooser
{
public:
    EntryChooser(const PlanRequest& request, const Eigen::MatrixXd& distance_m,
                 const std::vector<int>& uavs)
        : m_request(request), m_distance_m(distance_m), m_uavs(uavs)
    {
    }

    [[nodiscard]] Entries best(Cycle cycle) const
    {
        std::optional<Entries> best;
        for (int direction = 0; direction < 2; ++direction) {
            const std::vector<double> lengths_m = lengths(cycle);
            for (std::size_t base = 0; base < cycle.size(); ++base) {
                Entries entries = enter(cycle, spread(lengths_m, base));
                if (!best || entries.waiting < best->waiting)
                    best = std::move(entries);
            }
            std::ranges::reverse(cycle);
        }
        return *best;
    }

private:
    [[nodiscard]] const UavRequest& uav(std::size_t k) const
    {
        return m_request.uavs[toIndex(m_uavs[k])];
    }

    /**
     * Returns the lengths along the cycle from its first place to each, and the whole length last.
     */
    [[nodiscard]] std::vector<double> lengths(const Cycle& cycle) const
    {
        std::vector<double> lengths_m{0};
        for (std::size_t k = 0; k < cycle.size(); ++k)
            lengths_m.push_back(lengths_m.back() +
                                legBetween(m_distance_m, cycle[k], cycle[(k + 1) % cycle.size()]));
        return lengths_m;
    }

    /**
     * Returns one place for each UAV: from `base` on, the first free places after equal shares of
     * the length of the cycle.
     */
    [[nodiscard]] std::vector<std::size_t> spread(const std::vector<double>& lengths_m,
                                                  std::size_t base) const
    {
        const std::size_t n = lengths_m.size() - 1;
        std::vector<std::size_t> places;
        std::size_t step = 0;
        for (std::size_t k = 0; k < m_uavs.size(); ++k) {
            const double share_m =
                lengths_m[n] * static_cast<double>(k) / static_cast<double>(m_uavs.size());
            const auto flown_m = [&](std::size_t steps) {
                const double fromBase_m = lengths_m[(base + steps) % n] - lengths_m[base];
                return fromBase_m < 0 ? fromBase_m + lengths_m[n] : fromBase_m;
            };
            step = k == 0 ? 0 : step + 1;
            while (step + 1 < n && flown_m(step) < share_m)
                ++step;
            places.push_back((base + std::min(step, n - 1)) % n);
        }
        return places;
    }

    /** Assigns the UAVs to `places` with the least total distance. */
    [[nodiscard]] Entries enter(const Cycle& cycle, const std::vector<std::size_t>& places) const
    {
        const auto count = static_cast<Eigen::Index>(m_uavs.size());
        Eigen::MatrixXd path_m(count, count);
        for (Eigen::Index k = 0; k < count; ++k)
            for (Eigen::Index place = 0; place < count; ++place)
                path_m(place, k) = legBetween(uav(static_cast<std::size_t>(k)).distance_m, 0,
                                              cycle[places[static_cast<std::size_t>(place)]]);
        Entries entries{.cycle = cycle, .places = std::vector<std::size_t>(m_uavs.size())};
        const std::vector<int> placeOf = cheapestAssignment(path_m);
        for (std::size_t k = 0; k < m_uavs.size(); ++k) {
            const auto place = static_cast<std::size_t>(placeOf[k]);
            entries.places[k] = places[place];
            const std::size_t end = places[(place + 1) % places.size()];
            const std::size_t n = cycle.size();
            const std::size_t steps = (end + n - places[place]) % n;
            const bool alone = m_uavs.size() == 1;
            entries.waiting += waiting(uav(k), cycle, places[place], alone ? n : steps);
        }
        return entries;
    }

    /** Returns sum sigma_i t_i over `steps` places of the cycle, times the speed. */
    [[nodiscard]] double waiting(const UavRequest& uav, const Cycle& cycle, std::size_t begin,
                                 std::size_t steps) const
    {
        double distance_m = 0;
        double sum = 0;
        NodeIndex from;
        for (std::size_t k = 0; k < steps; ++k) {
            const NodeIndex node = cycle[(begin + k) % cycle.size()];
            distance_m += legBetween(uav.distance_m, from, node);
            sum += m_request.sigma_m2[toIndex(node)] * distance_m;
            from = node;
        }
        return sum;
    }

    const PlanRequest& m_request;
    const Eigen::MatrixXd& m_distance_m;
    const std::vector<int>& m_uavs;
};

/**
 * A cycle over all icebergs, in nodes of the request; the first iceberg takes the UAV's place as
 * the node to return to.
 */
struct MadeCycle
{
    Cycle cycle; ///< empty if none was found, or if the solve was cancelled
    Plan answer; ///< answer about the cycle problem, without orders
};

MadeCycle makeCycle(const PlanRequest& request, const Eigen::MatrixXd& distance_m,
                    const TvpSolver& solver, const SolveOptions& options)
{
    MadeCycle made;
    const auto n = static_cast<Eigen::Index>(request.ids.size());
    const TvpProblem round{.distance_m = distance_m.bottomRightCorner(n, n),
                           .sigma_m2 = std::vector<double>(request.ids.size(), 0.0),
                           .mu = 1,
                           .route = Route::Closed};
    SolveOutcome& outcome = made.answer.outcome;
    outcome = solver.solve(round, options);
    if (outcome.status != SolveStatus::None && outcome.reason != StopReason::Cancelled) {
        made.cycle = {1};
        for (const NodeIndex node : outcome.order())
            made.cycle.push_back(NodeIndex::of(node.number() + 1));
        made.answer.distance_m = flownDistance(round, outcome.order());
        if (outcome.bound)
            made.answer.gap = relativeGap(round, outcome.objective, *outcome.bound);
    }
    made.answer.problem = problemOf(round);
    made.answer.solvedIds.assign(request.ids.begin() + 1, request.ids.end());
    return made;
}

/** Returns the answer about the cycle with these orders. */
Plan withOrders(Plan answer, std::vector<IcebergList> orders)
{
    answer.uavs.clear();
    for (IcebergList& order : orders)
        answer.uavs.emplace_back().order = std::move(order);
    return answer;
}

/**
 * Keeps the rest of the round and flies it iceberg by iceberg; icebergs in view are passed over. A
 * new round begins only when this one is used up or the set of icebergs has changed.
 */
class TourOfOne
{
public:
    Plan plan(const PlanRequest& request, const TvpSolver& solver, const SolveOptions& options)
    {
        const std::vector<IcebergList> none(1);
        if (request.ids.empty())
            return withOrders({.outcome = {.status = SolveStatus::Optimal}}, none);
        m_rest = request.ids == m_known ? fromFirstAvailable(request, m_rest) : IcebergList();
        m_known = request.ids;
        if (!m_rest.empty()) {
            Plan answer = answerOf(request, std::span(&m_rest, 1));
            answer.outcome = {.status = SolveStatus::Feasible, .source = AnswerSource::KeptRoute};
            return answer;
        }
        if (m_cycleIds != request.ids) {
            MadeCycle made = makeCycle(request, request.uavs.front().distance_m, solver,
                                       inIds(request, options));
            if (made.cycle.empty())
                return withOrders(std::move(made.answer), none);
            enter(request, std::move(made.cycle));
            m_cycleIds = request.ids;
            m_made = std::move(made.answer);
        }
        m_rest = fromFirstAvailable(request, m_cycle);
        return withOrders(m_made, {m_rest});
    }

private:
    /** Returns options that report progress as ids of the cycle. */
    [[nodiscard]] static SolveOptions inIds(const PlanRequest& request, SolveOptions options)
    {
        if (options.onProgress)
            options.onProgress = [&request, report = options.onProgress](SolveProgress progress) {
                progress.orders.clear();
                for (const VisitOrder& order : progress.plan) {
                    IcebergList& icebergs = progress.orders.emplace_back();
                    for (const NodeIndex node : order)
                        icebergs.push_back(request.ids[toIndex(node)]);
                }
                report(progress);
            };
        return options;
    }

    void enter(const PlanRequest& request, Cycle cycle)
    {
        const Entries entries =
            EntryChooser(request, request.uavs.front().distance_m, {0}).best(std::move(cycle));
        m_cycle.clear();
        for (std::size_t step = 0; step < entries.cycle.size(); ++step) {
            const std::size_t at = (entries.places.front() + step) % entries.cycle.size();
            m_cycle.push_back(icebergOf(request.ids, entries.cycle[at]));
        }
    }

    [[nodiscard]] static IcebergList fromFirstAvailable(const PlanRequest& request,
                                                        const IcebergList& ids)
    {
        const auto first = std::ranges::find_if(
            ids, [&](IcebergIndex id) { return isAvailable(request, request.uavs.front(), id); });
        return {first, ids.end()};
    }

    IcebergList m_cycle;    ///< from the entry on
    IcebergList m_cycleIds; ///< icebergs of the request that the cycle was made for
    Plan m_made;
    IcebergList m_rest; ///< rest of the present round
    IcebergList m_known;
};

class TourOfSeveral
{
public:
    Plan plan(const PlanRequest& request, const TvpSolver& solver, SolveOptions options)
    {
        const FleetTask task = fleetTask(request);
        const std::vector<IcebergList> none(request.uavs.size());
        if (task.uavs.empty())
            return withOrders({.outcome = {.status = SolveStatus::Optimal,
                                           .bound = 0.0,
                                           .source = AnswerSource::KeptRoute}},
                              none);
        const Eigen::MatrixXd distance_m = meanDistances(request, task.uavs);
        if (m_ids != request.ids) {
            options.onProgress = {}; // the parts of the UAVs are not known yet
            MadeCycle made = makeCycle(request, distance_m, solver, options);
            if (made.cycle.empty())
                return withOrders(std::move(made.answer), none);
            m_cycle = std::move(made.cycle);
            m_made = std::move(made.answer);
            m_ids = request.ids;
            m_places.clear();
        }
        const bool allIn = std::ranges::all_of(
            task.uavs, [&](int k) { return m_places.contains(request.uavs[toIndex(k)].uav); });
        if (!allIn)
            enter(request, distance_m, task.uavs);
        return withOrders(m_made, rounds(request, task.uavs));
    }

private:
    /** Returns the mean over these UAVs of the distances between icebergs. */
    [[nodiscard]] static Eigen::MatrixXd meanDistances(const PlanRequest& request,
                                                       const std::vector<int>& uavs)
    {
        Eigen::MatrixXd sum_m = request.uavs[toIndex(uavs.front())].distance_m;
        for (std::size_t k = 1; k < uavs.size(); ++k)
            sum_m += request.uavs[toIndex(uavs[k])].distance_m;
        return sum_m / static_cast<double>(uavs.size());
    }

    void enter(const PlanRequest& request, const Eigen::MatrixXd& distance_m,
               const std::vector<int>& uavs)
    {
        Entries entries = EntryChooser(request, distance_m, uavs).best(m_cycle);
        m_cycle = std::move(entries.cycle);
        m_places.clear();
        for (std::size_t k = 0; k < uavs.size(); ++k)
            m_places[request.uavs[toIndex(uavs[k])].uav] = entries.places[k];
    }

    /**
     * Returns for each UAV one round of the cycle from its present place. UAVs whose iceberg has
     * still to be visited keep that place.
     */
    [[nodiscard]] std::vector<IcebergList> rounds(const PlanRequest& request,
                                                  const std::vector<int>& uavs)
    {
        std::vector<IcebergList> rounds(request.uavs.size());
        std::set<std::size_t> firsts;
        for (const bool keeping : {true, false})
            for (const int k : uavs) {
                const UavRequest& uav = request.uavs[toIndex(k)];
                IcebergList& round = rounds[toIndex(k)];
                std::size_t& place = m_places.at(uav.uav);
                if (!round.empty() ||
                    (keeping && (firsts.contains(place) || !isAvailableAt(uav, place))))
                    continue;
                const std::size_t begin = place;
                for (std::size_t step = 0; step < m_cycle.size(); ++step) {
                    const std::size_t at = (begin + step) % m_cycle.size();
                    if (!isAvailableAt(uav, at) || (round.empty() && firsts.contains(at)))
                        continue;
                    if (round.empty()) {
                        place = at;
                        firsts.insert(at);
                    }
                    round.push_back(icebergOf(request.ids, m_cycle[at]));
                }
            }
        return rounds;
    }
    [[nodiscard]] bool isAvailableAt(const UavRequest& uav, std::size_t place) const
    {
        return uav.available[toIndex(m_cycle[place]) - 1];
    }

    Cycle m_cycle;
    IcebergList m_ids; ///< icebergs of the request that the cycle was made for
    Plan m_made;       ///< answer about the cycle, without orders
    /** By `UavRequest::uav`: place of its next iceberg in the cycle. */
    std::map<int, std::size_t> m_places;
};

class TourPolicy final : public Policy
{
public:
    explicit TourPolicy(const TvpSolver& solver) : m_solver(solver) {}

    Plan plan(const PlanRequest& request, const SolveOptions& options) override
    {
        // A UAV of several may be planned alone later, but keeps its place in the cycle.
        m_isOfSeveral = m_isOfSeveral || request.uavs.size() > 1;
        SolveOptions cycleOptions = options;
        cycleOptions.hint.clear();
        cycleOptions.inFlight = false; // this cycle is kept for a long time
        return m_isOfSeveral ? m_several.plan(request, m_solver, cycleOptions)
                             : m_one.plan(request, m_solver, cycleOptions);
    }

private:
    const TvpSolver& m_solver;
    bool m_isOfSeveral = false;
    TourOfOne m_one;
    TourOfSeveral m_several;
};

} // namespace

std::unique_ptr<Policy> makeTour(const TvpSolver& solver)
{
    return std::make_unique<TourPolicy>(solver);
}

} // namespace berg
