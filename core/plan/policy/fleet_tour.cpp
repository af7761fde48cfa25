#include "core/plan/policy/fleet_tour.h"

#include "core/plan/policy/fleet_task.h"
#include "core/plan/solve/assignment.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace berg {

namespace {

/** Nodes of the request round the cycle. */
using Cycle = std::vector<int>;

/** Where UAVs enter a cycle: places in it, by UAV, and sum sigma_i t_i. */
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
        return m_request.fleet[static_cast<std::size_t>(m_uavs[k])];
    }

    /** From the first place to each, and all the way round. */
    [[nodiscard]] std::vector<double> lengths(const Cycle& cycle) const
    {
        std::vector<double> lengths_m{0};
        for (std::size_t k = 0; k < cycle.size(); ++k)
            lengths_m.push_back(lengths_m.back() +
                                m_distance_m(cycle[k], cycle[(k + 1) % cycle.size()]));
        return lengths_m;
    }

    /** Places from `base` on, the first free ones after equal shares of the cycle's length. */
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
                const double from_base_m = lengths_m[(base + steps) % n] - lengths_m[base];
                return from_base_m < 0 ? from_base_m + lengths_m[n] : from_base_m;
            };
            step = k == 0 ? 0 : step + 1;
            while (step + 1 < n && flown_m(step) < share_m)
                ++step;
            places.push_back((base + std::min(step, n - 1)) % n);
        }
        return places;
    }

    /** `places` in turn along the cycle, given to the UAVs. */
    [[nodiscard]] Entries enter(const Cycle& cycle, const std::vector<std::size_t>& places) const
    {
        const auto count = static_cast<Eigen::Index>(m_uavs.size());
        Eigen::MatrixXd way_m(count, count);
        for (Eigen::Index k = 0; k < count; ++k)
            for (Eigen::Index place = 0; place < count; ++place)
                way_m(place, k) =
                    uav(static_cast<std::size_t>(k))
                        .distance_m(0, cycle[places[static_cast<std::size_t>(place)]]);
        Entries entries{.cycle = cycle, .places = std::vector<std::size_t>(m_uavs.size())};
        const std::vector<int> placeOf = cheapestAssignment(way_m);
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

    /** sum sigma_i t_i over so many places, times the speed. */
    [[nodiscard]] double waiting(const UavRequest& uav, const Cycle& cycle, std::size_t begin,
                                 std::size_t steps) const
    {
        double distance_m = 0;
        double sum = 0;
        int from = 0;
        for (std::size_t k = 0; k < steps; ++k) {
            const int node = cycle[(begin + k) % cycle.size()];
            distance_m += uav.distance_m(from, node);
            sum += m_request.problem.sigma_m2[static_cast<std::size_t>(node)] * distance_m;
            from = node;
        }
        return sum;
    }

    const PlanRequest& m_request;
    const Eigen::MatrixXd& m_distance_m;
    const std::vector<int>& m_uavs;
};

class FleetTour final : public Policy
{
public:
    explicit FleetTour(const TvpSolver& solver) : m_solver(solver) {}

    PlanAnswer plan(const PlanRequest& request, std::span<const int>,
                    const SolveOptions& options) override
    {
        const FleetTask task = fleetTask(request);
        if (task.uavs.empty()) {
            PlanAnswer answer = fleetAnswer(request, {request.fleet.size(), std::vector<int>{}});
            answer.outcome = {.status = SolveStatus::Optimal, .bound = 0.0, .backend = "route"};
            return answer;
        }
        const Eigen::MatrixXd distance_m = meanDistances(request, task.uavs);
        if (m_ids != request.ids) {
            SolveOutcome outcome = makeCycle(request, distance_m, options);
            if (outcome.status == SolveStatus::None || outcome.reason == StopReason::Cancelled) {
                PlanAnswer answer =
                    fleetAnswer(request, {request.fleet.size(), std::vector<int>{}});
                answer.outcome = std::move(outcome);
                return answer;
            }
        }
        const bool allIn = std::ranges::all_of(task.uavs, [&](int k) {
            return m_places.contains(request.fleet[static_cast<std::size_t>(k)].uav);
        });
        if (!allIn)
            enter(request, distance_m, task.uavs);
        PlanAnswer answer = fleetAnswer(request, rounds(request, task.uavs));
        answer.outcome = m_made.outcome;
        answer.gap = m_made.gap;
        return answer;
    }

private:
    /** Between icebergs, of these UAVs. */
    [[nodiscard]] static Eigen::MatrixXd meanDistances(const PlanRequest& request,
                                                       const std::vector<int>& uavs)
    {
        Eigen::MatrixXd sum_m = request.fleet[static_cast<std::size_t>(uavs.front())].distance_m;
        for (std::size_t k = 1; k < uavs.size(); ++k)
            sum_m += request.fleet[static_cast<std::size_t>(uavs[k])].distance_m;
        return sum_m / static_cast<double>(uavs.size());
    }

    /** The first iceberg takes the UAV's place as the node to return to. Nothing is kept when no
     * cycle was found, or when it was cut short by a cancellation. */
    SolveOutcome makeCycle(const PlanRequest& request, const Eigen::MatrixXd& distance_m,
                           SolveOptions options)
    {
        const auto n = static_cast<Eigen::Index>(request.ids.size());
        const TvpProblem round{.distance_m = distance_m.bottomRightCorner(n, n),
                               .sigma_m2 = std::vector<double>(request.ids.size(), 0.0),
                               .mu = 1,
                               .route = Route::Closed};
        options.hint.clear();
        options.onProgress = {}; // the UAVs' parts in it are not known yet
        SolveOutcome outcome = m_solver.solve(round, options);
        const VisitOrder order = std::exchange(outcome.order, {});
        if (outcome.status == SolveStatus::None || outcome.reason == StopReason::Cancelled)
            return outcome;
        m_made = {.outcome = outcome};
        if (outcome.bound)
            m_made.gap = relativeGap(round, outcome.objective, *outcome.bound);
        m_cycle = {1};
        for (const int node : order)
            m_cycle.push_back(node + 1);
        m_ids = request.ids;
        m_places.clear();
        return outcome;
    }

    void enter(const PlanRequest& request, const Eigen::MatrixXd& distance_m,
               const std::vector<int>& uavs)
    {
        Entries entries = EntryChooser(request, distance_m, uavs).best(m_cycle);
        m_cycle = std::move(entries.cycle);
        m_places.clear();
        for (std::size_t k = 0; k < uavs.size(); ++k)
            m_places[request.fleet[static_cast<std::size_t>(uavs[k])].uav] = entries.places[k];
    }

    /** Once round the cycle for each UAV, from the place where it is. Those whose iceberg is still
     * to be visited keep it. */
    [[nodiscard]] std::vector<std::vector<int>> rounds(const PlanRequest& request,
                                                       const std::vector<int>& uavs)
    {
        std::vector<std::vector<int>> rounds(request.fleet.size());
        std::set<std::size_t> firsts;
        for (const bool keeping : {true, false})
            for (const int k : uavs) {
                const UavRequest& uav = request.fleet[static_cast<std::size_t>(k)];
                std::vector<int>& round = rounds[static_cast<std::size_t>(k)];
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
                    round.push_back(request.ids[static_cast<std::size_t>(m_cycle[at] - 1)]);
                }
            }
        return rounds;
    }
    [[nodiscard]] bool isAvailableAt(const UavRequest& uav, std::size_t place) const
    {
        return uav.available[static_cast<std::size_t>(m_cycle[place] - 1)];
    }

    const TvpSolver& m_solver;
    Cycle m_cycle;
    std::vector<int> m_ids;              ///< of the request that the cycle is for
    PlanAnswer m_made;                   ///< outcome and gap of the cycle
    std::map<int, std::size_t> m_places; ///< by number of the UAV: where in the cycle its next is
};

} // namespace

std::unique_ptr<Policy> makeFleetTour(const TvpSolver& solver)
{
    return std::make_unique<FleetTour>(solver);
}

} // namespace berg
