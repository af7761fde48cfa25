#pragma once

#include "core/coverage/coverage_search.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace berg {

/** A plan for each UAV, and what they cost together. */
struct FleetCoverage
{
    std::vector<CoveragePlan> plans;
    double total_m2s = 0; ///< Predicted cost; an iceberg is seen when any UAV sees it.
};

/** Model and limits of one UAV in the search. */
struct CoverageFlyer
{
    CoverageModel model; ///< Model with the horizon, icebergs and weights of all UAVs.
    /** Neither list is empty for several UAVs; both may be empty for a UAV that is alone. */
    CoverageLimits limits;
};

/**
 * Improves the plans of several UAVs by one simulated annealing. The UAVs take turns: the plan of
 * one changes as in `CoverageSearch` while the others' plans stay unchanged. No two first legs go
 * to one iceberg; a UAV for which that leaves no iceberg gets no legs. Work is counted over all
 * searches. A UAV that is alone takes no turns.
 */
class FleetCoverageSearch
{
public:
    /**
     * Starts with empty plans. There must be at least one flyer; `seed` and `stream` set all random
     * decisions. `tails` are the patrols after the plans, which are borrowed; null means that the
     * plans end with their legs.
     */
    FleetCoverageSearch(std::vector<CoverageFlyer> flyers, std::uint64_t seed, std::uint64_t stream,
                        const PatrolTails* tails = nullptr);
    ~FleetCoverageSearch();

    /**
     * Returns the plans, one for each UAV, completed as by `CoverageSearch::completed`. Each UAV in
     * turn considers the completed plans before its own and the given ones after it.
     */
    [[nodiscard]] FleetCoverage completed(std::span<const CoveragePlan> plans);

    /**
     * Returns better plans of all UAVs, found as by `CoverageSearch::improved` with the same
     * arguments.
     */
    [[nodiscard]] FleetCoverage improved(const FleetCoverage& start, std::int64_t untilWork,
                                         double heat, const SolveWatch& watch);

    /** Returns the work done so far by all searches. */
    [[nodiscard]] std::int64_t work() const;
    /** Returns the number of UAVs. */
    [[nodiscard]] std::size_t uavCount() const { return m_members.size(); }

    /**
     * Sets the function that is called with better plans, though not with all of them. It does not
     * influence the search.
     */
    void setListener(std::function<void(const FleetCoverage&)> listener)
    {
        m_listener = std::move(listener);
    }

private:
    struct Member;

    void fix(std::size_t member, CoveragePlan plan);
    void updateOthers(std::size_t member);
    [[nodiscard]] FleetCoverage improvedAlone(const FleetCoverage& start, std::int64_t untilWork,
                                              double heat, const SolveWatch& watch);
    void turnOf(std::size_t member, const CoverageCooling& cooling, const SolveWatch& watch,
                FleetCoverage& best);
    [[nodiscard]] std::vector<CoveragePlan> plans() const;
    void report(const FleetCoverage& better);

    std::vector<std::unique_ptr<Member>> m_members;
    const PatrolTails* m_tails;
    std::function<void(const FleetCoverage&)> m_listener;
    double m_reported_m2s = std::numeric_limits<double>::infinity();
};

/**
 * Returns the predicted cost in m2 s of plans, one for each model, with the patrols after them
 * unless `tails` is null. The models must be without views of other UAVs.
 */
[[nodiscard]] double fleetTotal_m2s(std::span<const CoverageModel> models,
                                    std::span<const CoveragePlan> plans,
                                    const PatrolTails* tails = nullptr);

} // namespace berg
