#pragma once

#include "core/base/random.h"
#include "core/coverage/model_place.h"
#include "core/coverage/patrol_problem.h"
#include "core/plan/solve/solve_watch.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace berg {

/**
 * The icebergs that each UAV visits, in order, as rows of `PatrolProblem::icebergs`: the numbers of
 * their places in a model (`ModelPlace`).
 */
using PatrolRoutes = std::vector<std::vector<int>>;

/**
 * Improves a patrol by simulated annealing. A patrol is one sequence of visits for each UAV, over
 * all icebergs with repetitions; its cost is the integral of the sum of all sigmas to the end of
 * the problem. The evaluation of a change takes time for the changed visits only: the visits after
 * them are shifted, and their derivatives (`slope`, `bend` of a route) give the cost of that. Costs
 * of accepted changes are exact. A move takes about a microsecond. The same moves give the same
 * patrol on every machine.
 */
class PatrolSearch
{
public:
    /**
     * Starts with empty routes. The problem must have at least one iceberg and one UAV; `random`
     * sets all random decisions.
     */
    PatrolSearch(PatrolProblem problem, const Random& random);

    /**
     * Sets the routes, one for each UAV, without visits that are not allowed or come after the end.
     */
    void set(PatrolRoutes routes);
    /**
     * Extends the routes to the end of the problem by greedy visits. The UAV that is free first
     * visits the iceberg whose sigma is largest for the flight time to it.
     */
    void extend();
    /**
     * Improves the present patrol by an annealing of this number of moves, and ends with the best
     * patrol found. `heat` is the temperature at the beginning, as a share of the mean cost of a
     * visit. The watch may stop it early.
     */
    void improve(std::int64_t moves, double heat, const SolveWatch& watch);

    /** Returns the problem. */
    [[nodiscard]] const PatrolProblem& problem() const { return m_problem; }
    /** Returns the present routes. */
    [[nodiscard]] PatrolRoutes routes() const;
    /** Returns the icebergs that a UAV visits, in order. */
    [[nodiscard]] std::span<const int> visits(std::size_t uav) const
    {
        return m_routes[uav].visits;
    }
    /** Returns the state of a UAV after each of its visits. */
    [[nodiscard]] std::span<const PatrolStop> stops(std::size_t uav) const
    {
        return m_routes[uav].stops;
    }
    /** Returns the cost of the present patrol. */
    [[nodiscard]] double cost_m2s() const { return m_cost_m2s; }
    /** Returns the number of moves that `improve` has made so far. */
    [[nodiscard]] std::int64_t moves() const { return m_moves; }

    /** A change that replaces the visits [begin, end) of a UAV's route by others. */
    struct Change
    {
        std::size_t uav = 0;
        int begin = 0;
        int end = 0;
        std::vector<int> visits;
    };
    /**
     * Returns the predicted change of the cost in m2 s. The range of visits must be within the
     * UAV's route; whether the new visits are allowed is not checked.
     */
    [[nodiscard]] double changeOfCost_m2s(const Change& change);
    /**
     * Applies a change to the present patrol and recalculates its cost. Visits that come too late
     * are cut.
     */
    void apply(const Change& change);

private:
    /**
     * Times by which a visit and the others up to the next landing may come later or earlier,
     * compared with the end of the sortie, before that landing moves to another visit.
     */
    struct Leeway
    {
        double later_s = std::numeric_limits<double>::infinity();
        double earlier_s = std::numeric_limits<double>::infinity();
    };
    struct Route
    {
        std::vector<int> visits;
        std::vector<PatrolStop> stops;
        /**
         * First and half the second derivative of the cost when a visit and all after it come
         * later. There is one entry more than visits.
         */
        std::vector<double> slope_m2;
        std::vector<double> bend_m2ps;
        std::vector<Leeway> leeways; ///< One for each visit of a UAV with sorties.
    };
    /** One visit of an iceberg by any UAV. */
    struct Seen
    {
        double time_s = 0;
        std::size_t uav = 0;
        int place = 0; ///< Index of the visit in the route.
    };
    /** The gaps of one iceberg, followed forward in time. */
    struct Chain
    {
        double last_s = 0;
        std::size_t visits = 0;
        std::size_t next = 0; ///< First entry of `m_seen` that has not been followed yet.
    };

    [[nodiscard]] const PatrolIceberg& iceberg(int i) const
    {
        return m_problem.icebergs[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] PatrolStop flown(std::size_t uav, const PatrolStop& from, int to,
                                   std::optional<int> next) const
    {
        return patrolLeg(m_problem.uavs[uav], from, iceberg(to).place,
                         next ? &iceberg(*next).place : nullptr);
    }
    [[nodiscard]] double end_s(std::size_t uav) const
    {
        return std::min(m_problem.length_s, m_problem.uavs[uav].until_s);
    }
    void fly(std::size_t uav, std::size_t from);
    void measureLeeways(Route& route) const;
    [[nodiscard]] bool isOnlyShifted(const Route& route, int place, const PatrolStop& now) const;
    void account();
    void accountFor(int iceberg);
    double follow(Chain& chain, int iceberg, std::size_t uav, double time_s, double others_s) const;
    void touch(int iceberg, std::size_t uav, int begin);
    [[nodiscard]] double changeOfRest_m2s(int iceberg, const Change& change, int end,
                                          double shift_s);
    /** The effect of a change on the visits before and after it. */
    struct Shift
    {
        /** Change of cost of the gaps that end with changed visits, and of the shift. */
        double cost_m2s = 0;
        double shift_s = 0;
        int end = 0; ///< First visit that is shifted, or the number of visits.
        /** The UAV would land after other visits from here on, which the cost leaves out. */
        bool isGuess = false;
    };
    /** The landings after a change that is evaluated. */
    enum class Landings
    {
        Flown,
        AsBefore ///< The UAV is assumed to land after the same visits as before.
    };
    Shift flyChanged(const Change& change, int begin, Landings landings);
    [[nodiscard]] Shift changeOfCost_m2s(const Change& change, Landings landings);
    [[nodiscard]] double detour_m(const Change& change) const;
    [[nodiscard]] bool costsLess(const Change& change, double limit_m2s);
    [[nodiscard]] static std::optional<int> formerPlace(const Route& route,
                                                        std::pair<int, int> visits, int near);
    [[nodiscard]] static std::optional<PatrolStop> shiftedStop(const Route& route, int place,
                                                               const PatrolStop& now);

    // These propose changes (patrol_moves.cpp).
    [[nodiscard]] const std::vector<int>& neighbours(int iceberg, double time_s);
    [[nodiscard]] int neighbour(int iceberg, double time_s);
    [[nodiscard]] std::optional<int> placeIn(std::size_t uav, int iceberg, int near);
    [[nodiscard]] std::optional<int> partnerOf(std::size_t uav, int place);
    [[nodiscard]] bool propose(Change& change, std::size_t uav);
    void proposeOne(Change& change, int place, std::uint64_t dice);
    [[nodiscard]] bool proposeTwo(Change& change, int a, int b, std::uint64_t dice);
    [[nodiscard]] bool isAllowed(const Change& change) const;
    /** Tries one move. Returns false if the patrol has not changed. */
    bool step(double limit_m2s);
    bool transfer(double limit_m2s);

    PatrolProblem m_problem;
    Random m_random;
    std::vector<Route> m_routes;
    std::vector<std::vector<Seen>> m_seen; ///< Visits of each iceberg, ascending in time.
    double m_cost_m2s = 0;
    std::int64_t m_moves = 0;
    /**
     * Neighbours for each part of the time and each iceberg, nearest first. A list is empty until
     * it is needed.
     */
    std::vector<std::vector<std::vector<int>>> m_near;
    double m_slice_s = 0;
    std::vector<std::pair<double, int>> m_distances; ///< Buffer for the search for neighbours.
    // These members belong to the change that is being evaluated.
    Change m_change;
    std::vector<int> m_window;
    std::vector<int> m_touched;
    std::vector<Chain> m_old; ///< Chains of each iceberg before the change.
    std::vector<Chain> m_new;
    std::vector<char> m_isTouched;
};

} // namespace berg
