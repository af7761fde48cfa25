#pragma once

#include "core/checks/weather_gate.h"
#include "core/mission/mission.h"

#include <vector>

namespace berg {

/** Collects where the UAVs of a run are in the air, about once a minute, for `weatherAlong`. */
class FlightPlaces
{
public:
    /** Adds the present places if a minute has passed since the last ones. */
    void note(const Simulation& simulation);
    /** Adds the places of a recorded sample if a minute has passed since the last ones. */
    void note(const Sample& sample);
    /** Adds the present places; call it at the end of the run. */
    void finish(const Simulation& simulation);

    /** Returns the places by UAV, times rising; empty before the first call. */
    [[nodiscard]] const std::vector<std::vector<FlightPlace>>& flights() const { return m_flights; }

private:
    [[nodiscard]] bool isDue(double time_s) const;
    void add(std::size_t uav, const FlightPlace& place, bool isOnGround);
    void addAll(const Simulation& simulation);

    std::optional<double> m_last_s;
    std::vector<std::vector<FlightPlace>> m_flights;
};

/**
 * Returns the predicted flight of each UAV of a plan from the start (`planFromStart`): straight to
 * each iceberg of its order as `forecastPlan` predicts it, and then at the last one until the end
 * of the run or of the UAV's endurance.
 */
[[nodiscard]] std::vector<std::vector<FlightPlace>> plannedFlights(const Scenario& scenario,
                                                                   const Plan& plan);

} // namespace berg
