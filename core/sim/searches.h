#pragma once

#include "core/sim/world_state.h"

#include <span>

namespace berg {

/** Who searches for which lost iceberg, one each, and what has been given up or is left to plans.
 */
class Searches
{
public:
    explicit Searches(std::size_t uavs) : m_byUav(uavs) {}

    [[nodiscard]] const std::optional<Search>& of(int uav) const { return m_byUav[toIndex(uav)]; }
    [[nodiscard]] const std::vector<Search>& givenUp() const { return m_givenUp; }
    /** Those under way and those given up. */
    [[nodiscard]] std::size_t count() const;

    void begin(int uav, Search search) { m_byUav[toIndex(uav)] = std::move(search); }
    /** Of a UAV that leaves it to somebody else; it must have one. */
    [[nodiscard]] Search take(int uav);
    /** For now. */
    void giveUp(Search search) { m_givenUp.push_back(std::move(search)); }
    /** The iceberg is found, or gone. */
    void end(int iceberg);

    /** The UAV has passed the corner it flew to. */
    void nextCorner(int uav) { m_byUav[toIndex(uav)]->path.nextCorner(); }
    /** The variance of the iceberg's place has grown. */
    void grow(int iceberg, double added_m2);
    /** Looks showed no iceberg: told to whoever searches for it. */
    void miss(int iceberg, std::span<const FieldOfView> views, const Point& estimate_m,
              double detection);

    /** The same of one that nobody searches for but by the plan. */
    void missOfPlan(int iceberg, std::span<const FieldOfView> views, const Point& estimate_m,
                    double detection);
    /** Whoever searches for it, or did; null: nobody. */
    [[nodiscard]] const Search* ofIceberg(int iceberg) const;

private:
    std::vector<std::optional<Search>> m_byUav;
    std::vector<Search> m_givenUp;
};

} // namespace berg
