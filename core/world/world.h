#pragma once

#include "core/scenario/flight_weather.h"
#include "core/tracking/drift.h"
#include "core/world/world_state.h"

#include <limits>
#include <optional>
#include <span>

namespace berg {

/**
 * Draws the drift noise of each iceberg of the scenario, in its order. Simulations whose scenarios
 * differ only in planner or duration can share it. Memory is limited to 32 MB; in long runs with
 * many icebergs each simulation draws the rest itself.
 */
[[nodiscard]] std::vector<DriftNoise> drawNoise(const Scenario& scenario);

/** Properties of an iceberg that are constant, except its assignment. */
struct IcebergParameters
{
    std::uint64_t stream = 0; ///< stream of its random numbers
    double radius_m = 0;
    Track start; ///< knowledge at its start; the velocity includes the current
    /** Only UAV that may visit it; nullopt if every UAV may. */
    std::optional<int> assignedUav;
};

/** The true state: time and positions of the icebergs. */
class World
{
public:
    /** Starts at step 0 without icebergs, which `add` adds. */
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
    /** Advances the truth to a later step. No iceberg may have been added in between. */
    void goTo(std::int64_t step);
    /** Returns the specification of the camera's measurements. */
    [[nodiscard]] const ObserverSpec& observer() const { return m_observer; }
    [[nodiscard]] const std::optional<Asset>& asset() const { return m_asset; }
    void setAsset(const Asset& asset) { m_asset = asset; }

    /**
     * Adds an iceberg that is at its `position_m` at `start_s` and is monitored from `appearsStep`
     * on. Returns its index, the next one.
     */
    IcebergIndex add(const Iceberg& iceberg, DriftNoise noise, double start_s,
                     std::int64_t appearsStep);
    [[nodiscard]] int icebergCount() const { return static_cast<int>(m_parameters.size()); }
    [[nodiscard]] IcebergRange icebergs() const { return IcebergRange(m_parameters.size()); }
    [[nodiscard]] const IcebergParameters& parameters(IcebergIndex iceberg) const
    {
        return m_parameters[toIndex(iceberg)];
    }
    /** Treats the iceberg as if it had never appeared. */
    void remove(IcebergIndex iceberg)
    {
        m_appearsStep[toIndex(iceberg)] = std::numeric_limits<std::int64_t>::max();
    }
    /** Assigns the iceberg to a UAV, or to every UAV if `uav` is nullopt. */
    void assign(IcebergIndex iceberg, std::optional<int> uav)
    {
        m_parameters[toIndex(iceberg)].assignedUav = uav;
    }
    /** Returns the number of steps since the iceberg appeared; negative before. */
    [[nodiscard]] std::int64_t age(IcebergIndex iceberg) const
    {
        return m_step - m_appearsStep[toIndex(iceberg)];
    }

    /** Returns the true position now, or at its start before the iceberg has appeared, m. */
    [[nodiscard]] Point truth_m(IcebergIndex iceberg) const;
    /**
     * Returns the true position of an iceberg that has appeared, m. Draws its noise up to now, so
     * later calls are cheap.
     */
    [[nodiscard]] Point position_m(IcebergIndex iceberg)
    {
        return m_drift[toIndex(iceberg)].position_m(time_s());
    }
    /** Returns the weather of the run; null without a forecast. */
    [[nodiscard]] const std::shared_ptr<const FlightWeather>& weather() const { return m_weather; }
    /** Returns the changing mean velocity of an iceberg, or null if it is constant. */
    [[nodiscard]] const DriftForcing* forcing(IcebergIndex iceberg) const
    {
        return m_forcing[toIndex(iceberg)].get();
    }
    /** Returns those of all icebergs; empty without a forecast. */
    [[nodiscard]] std::vector<std::shared_ptr<const DriftForcing>> forcings() const
    {
        return m_weather ? m_forcing : std::vector<std::shared_ptr<const DriftForcing>>();
    }
    /** Draws the noise of all icebergs up to now, so that `truth_m` has little left to draw. */
    void advanceDrift();
    /** Returns a speed that the iceberg does not exceed, m/s. */
    [[nodiscard]] double speedLimit_mps(IcebergIndex iceberg) const
    {
        return m_drift[toIndex(iceberg)].speedLimit_mps();
    }
    /** Returns the random draw for camera sample `sample` of the iceberg; the default without
     * noise. */
    [[nodiscard]] SampleDraw sampleDraw(IcebergIndex iceberg, std::int64_t sample) const;

private:
    double m_dt_s;
    std::int64_t m_lastStep;
    std::int64_t m_stepsPerSecond;
    std::uint64_t m_seed;
    bool m_noise;
    ObserverSpec m_observer;
    std::optional<Asset> m_asset; ///< protected asset
    /** Wind, current and observer of the scenario; copies of the world share it. */
    std::shared_ptr<const ScenarioWorld> m_conditions;
    std::shared_ptr<const FlightWeather> m_weather; ///< null without a forecast
    std::vector<std::string> m_uavs;                ///< UAV ids
    std::int64_t m_step = 0;
    std::int64_t m_inSecond = 0; ///< steps since the last whole second
    std::vector<IcebergParameters> m_parameters;
    std::vector<DriftModel> m_drift;
    /** By iceberg: its changing mean velocity, or null if that is constant. */
    std::vector<std::shared_ptr<const DriftForcing>> m_forcing;
    std::vector<std::int64_t> m_appearsStep;
};

} // namespace berg
