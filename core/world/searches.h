#pragma once

#include "core/world/world_state.h"

#include <span>

namespace berg {

/**
 * Searches for lost icebergs: at most one active search for each UAV, and those given up or left to
 * plans.
 */
class Searches
{
public:
    explicit Searches(std::size_t uavs) : m_byUav(uavs) {}

    [[nodiscard]] const std::optional<Search>& of(int uav) const { return m_byUav[toIndex(uav)]; }
    [[nodiscard]] const std::vector<Search>& givenUp() const { return m_givenUp; }
    /** Returns the number of searches active or given up. */
    [[nodiscard]] std::size_t count() const;

    /** Starts the search of the UAV. */
    void begin(int uav, Search search) { m_byUav[toIndex(uav)] = std::move(search); }
    /** Ends the UAV's search and returns it. The UAV must have one. */
    [[nodiscard]] Search take(int uav);
    /** Adds a search to those given up for now. */
    void giveUp(Search search) { m_givenUp.push_back(std::move(search)); }
    /** Ends all searches for the iceberg, which is found or no longer monitored. */
    void end(IcebergIndex iceberg);

    /** Moves the UAV's search, which must exist, on to the next corner of its pattern. */
    void nextCorner(int uav) { m_byUav[toIndex(uav)]->path.nextCorner(); }
    /** Adds growth of the position variance to every search for the iceberg. */
    void grow(IcebergIndex iceberg, double added_m2);
    /**
     * Updates active searches for the iceberg with one camera sample that did not show it.
     * `views` are the fields of view, `estimate_m` its estimate, and `detection` the detection
     * probability.
     */
    void miss(IcebergIndex iceberg, std::span<const FieldOfView> views, const Point& estimate_m,
              double detection);

    /** Updates searches given up or left to plans with one such camera sample (see `miss`). */
    void missOfPlan(IcebergIndex iceberg, std::span<const FieldOfView> views,
                    const Point& estimate_m, double detection);
    /** Returns the search for the iceberg, active or given up, or null if there is none. */
    [[nodiscard]] const Search* ofIceberg(IcebergIndex iceberg) const;

private:
    std::vector<std::optional<Search>> m_byUav;
    std::vector<Search> m_givenUp;
};

} // namespace berg
