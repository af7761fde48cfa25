#pragma once

#include "widgets/model/mission_snapshot.h"

namespace berg {

/**
 * What map, charts and panels show of one mission: its scenario, how it stands, what it was like
 * at the instant the user looks at, and the history so far. Made from a finished mission, or grown
 * from the snapshots of one that is being flown.
 */
struct FlightRecord
{
    Scenario scenario;
    MissionSnapshot now;                    ///< newest; its news are in the history
    std::optional<MissionSnapshot> instant; ///< looked back at; none: the newest is shown
    MissionHistory history;

    /** What is to be drawn. */
    [[nodiscard]] const MissionSnapshot& shown() const { return instant ? *instant : now; }

    /** Forgets everything: another scenario, or the same one from its start. */
    void begin(const Scenario& flown);
    /** Takes the snapshot over; one of a new generation starts the history anew. */
    void take(MissionSnapshot snapshot);

    /** Under way, paused or at its end: the scenario is not to be edited. */
    [[nodiscard]] bool inFlight() const;
    /** At the time shown. */
    [[nodiscard]] Point estimate_m(std::size_t iceberg) const;
    /** So many events had come by the time shown. */
    [[nodiscard]] std::size_t eventsShown() const;
};

[[nodiscard]] FlightRecord recordOf(const Mission& mission);

/**
 * How a flight to be watched is recorded: a sample each second, on long flights of many icebergs
 * fewer, but one in 5 s at least, so that a day with a hundred icebergs stays small and is drawn
 * as fast as a short one. How the mission is flown does not depend on it.
 */
[[nodiscard]] MissionOptions recordingOf(const Scenario& scenario);

} // namespace berg
