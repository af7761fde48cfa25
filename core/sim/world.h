#pragma once

#include "core/scenario/scenario.h"
#include "core/sim/world_state.h"
#include "core/tracking/drift.h"

#include <limits>
#include <span>

namespace berg {

/**
 * The noise of each iceberg of the scenario, in its order: to be drawn once for all simulations of
 * scenarios that differ in planner or duration alone. Holds 32 MB at most; of long runs with many
 * icebergs each simulation draws the end by itself.
 */
[[nodiscard]] std::vector<DriftNoise> drawNoise(const Scenario& scenario);

/** What does not change about an iceberg, but for who is to visit it. */
struct IcebergParameters
{
    std::uint64_t stream = 0; ///< of its random numbers
    double radius_m = 0;
    Track start;          ///< what is known of it at its start, the velocity with the current
    int assignedUav = -1; ///< the one that alone is to visit it; -1: any
};

/** The truth: what time it is, and where the icebergs are. */
class World
{
public:
    explicit World(const Scenario& scenario);

    [[nodiscard]] double time_s() const { return static_cast<double>(m_step) * m_dt_s; }
    [[nodiscard]] double dt_s() const { return m_dt_s; }
    [[nodiscard]] std::int64_t step() const { return m_step; }
    [[nodiscard]] std::int64_t lastStep() const { return m_lastStep; }
    [[nodiscard]] std::int64_t stepsPerSecond() const { return m_stepsPerSecond; }
    [[nodiscard]] bool isWholeSecond() const { return m_inSecond == 0; }
    [[nodiscard]] std::uint64_t seed() const { return m_seed; }
    void tick()
    {
        ++m_step;
        m_inSecond = m_inSecond + 1 == m_stepsPerSecond ? 0 : m_inSecond + 1;
    }
    /** The truth at a later step, as far as nothing is added until then. */
    void goTo(std::int64_t step);
    /** Of the looks at it. */
    [[nodiscard]] const ObserverSpec& observer() const { return m_observer; }
    [[nodiscard]] const std::optional<Asset>& asset() const { return m_asset; }
    void setAsset(const Asset& asset) { m_asset = asset; }

    /** `start_s`: when the iceberg is at its `position_m`; `appearsStep`: known from then on. */
    void add(const Iceberg& iceberg, DriftNoise noise, double start_s, std::int64_t appearsStep);
    [[nodiscard]] int icebergCount() const { return static_cast<int>(m_bodies.size()); }
    [[nodiscard]] const IcebergParameters& body(int iceberg) const
    {
        return m_bodies[toIndex(iceberg)];
    }
    /** As if it had never appeared. */
    void remove(int iceberg)
    {
        m_appearsStep[toIndex(iceberg)] = std::numeric_limits<std::int64_t>::max();
    }
    void assign(int iceberg, int uav) { m_bodies[toIndex(iceberg)].assignedUav = uav; }
    /** Steps since it appeared, below 0 before. */
    [[nodiscard]] std::int64_t age(int iceberg) const
    {
        return m_step - m_appearsStep[toIndex(iceberg)];
    }

    /** True position; before it has appeared, that at its start. */
    [[nodiscard]] Point truth_m(int iceberg) const;
    /** The same of one that has appeared; takes the noise until now. */
    [[nodiscard]] Point position_m(int iceberg)
    {
        return m_drift[toIndex(iceberg)].position_m(time_s());
    }
    /** Takes the noise until now of all, so that `truth_m` has little to make up. */
    void advanceDrift();
    [[nodiscard]] double speedLimit_mps(int iceberg) const
    {
        return m_drift[toIndex(iceberg)].speedLimit_mps();
    }
    /** Of look number `look` at it. */
    [[nodiscard]] LookDraw lookDraw(int iceberg, std::int64_t look) const;

private:
    double m_dt_s;
    std::int64_t m_lastStep;
    std::int64_t m_stepsPerSecond;
    std::uint64_t m_seed;
    bool m_noise;
    ObserverSpec m_observer;
    std::optional<Asset> m_asset; ///< what is to be protected
    Point m_current_mps;
    std::vector<std::string> m_uavs; ///< ids
    std::int64_t m_step = 0;
    std::int64_t m_inSecond = 0; ///< steps since the last whole one
    std::vector<IcebergParameters> m_bodies;
    std::vector<DriftModel> m_drift;
    std::vector<std::int64_t> m_appearsStep;
};

} // namespace berg
