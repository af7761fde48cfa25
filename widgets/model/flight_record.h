#pragma once

#include "widgets/model/mission_runner.h"

namespace berg {

/**
 * What map, charts and panels show of one mission: its scenario, the picture now and the history
 * so far. Made from a finished mission, or grown from the snapshots of one that is being flown.
 */
struct FlightRecord
{
    Scenario scenario;
    MissionSnapshot now; ///< without samples: those are in the history
    std::vector<Sample> samples;
    std::vector<std::vector<IcebergSample>> rows; ///< icebergs at each sample, by index

    /** Forgets everything: another scenario, or the same one from its start. */
    void begin(const Scenario& flown);
    /** Takes the snapshot over; one of a new generation starts the history anew. */
    void take(MissionSnapshot snapshot);

    /** Under way, paused or at its end: the scenario is not to be edited. */
    [[nodiscard]] bool inFlight() const;
    [[nodiscard]] Point estimate_m(std::size_t iceberg) const;
};

[[nodiscard]] FlightRecord recordOf(const Mission& mission);

} // namespace berg
