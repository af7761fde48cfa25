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
    double total_m2s = 0; ///< predicted, an iceberg being seen when any UAV sees it
};

/** One UAV as the search sees it. */
struct CoverageFlyer
{
    CoverageModel model;   ///< horizon, icebergs and weights are those of all
    CoverageLimits limits; ///< of several neither list empty; none for a UAV that is alone
};

/**
 * Improves the plans of several UAVs by one simulated annealing: by turns, each UAV's plan changes
 * as in `CoverageSearch` while those of the others stand. No two first legs are to one iceberg; a
 * UAV for which that leaves none gets no legs. Work is that of all searches. A UAV that is alone
 * takes no turns.
 */
class FleetCoverageSearch
{
public:
    FleetCoverageSearch(std::vector<CoverageFlyer> flyers, std::uint64_t seed,
                        std::uint64_t stream);
    ~FleetCoverageSearch();

    /** As `CoverageSearch::completed`, UAV after UAV, each knowing those before and the plans. */
    [[nodiscard]] FleetCoverage completed(std::span<const CoveragePlan> plans);

    /** As `CoverageSearch::improved`. */
    [[nodiscard]] FleetCoverage improved(const FleetCoverage& start, std::int64_t untilWork,
                                         double heat, const SolveWatch& watch);

    [[nodiscard]] std::int64_t work() const;
    [[nodiscard]] std::size_t uavCount() const { return m_members.size(); }

    /** As `CoverageSearch::setListener`, now and then. */
    void setListener(std::function<void(const FleetCoverage&)> listener)
    {
        m_listener = std::move(listener);
    }

private:
    struct Member;

    void fix(std::size_t member, CoveragePlan plan);
    void lookAtOthers(std::size_t member);
    [[nodiscard]] FleetCoverage improvedAlone(const FleetCoverage& start, std::int64_t untilWork,
                                              double heat, const SolveWatch& watch);
    void turnOf(std::size_t member, const CoverageCooling& cooling, const SolveWatch& watch,
                FleetCoverage& best);
    [[nodiscard]] std::vector<CoveragePlan> plans() const;
    void tell(const FleetCoverage& better);

    std::vector<std::unique_ptr<Member>> m_members;
    std::function<void(const FleetCoverage&)> m_listener;
    double m_told_m2s = std::numeric_limits<double>::infinity();
};

/** Predicted cost of plans by models that know nothing of each other. */
[[nodiscard]] double fleetTotal_m2s(std::span<const CoverageModel> models,
                                    std::span<const CoveragePlan> plans);

} // namespace berg
