#pragma once

#include "core/coverage/flight_picture.h"
#include "core/plan/policy/policy.h"
#include "core/tracking/lost_search.h"
#include "core/vehicle/return_path.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace berg {

/** An iceberg that has come into view. */
struct SeenIceberg
{
    int iceberg = -1;
    int uav = -1; ///< the first one that has it in view; -1: reported by somebody else
};

/** What the autopilot is doing. */
enum class FlightMode
{
    Idle,   ///< no iceberg at all: holding
    Leg,    ///< to the target
    RunOut, ///< passed a target too close to turn onto: straight on before turning back
    Circle, ///< every iceberg in view: round the last one reached
    Search, ///< for a lost iceberg
    Home,   ///< on the way home
    Ground, ///< at home between two sorties
    Hold    ///< as ordered: round a place
};

/** What an operator has told a UAV to do, until it is told to resume. */
enum class FlightOrder
{
    None,
    ReturnNow, ///< home, to stay there
    HoldHere   ///< round the place where it was told
};

inline constexpr std::array<Named<FlightOrder>, 3> kFlightOrderNames{
    {{FlightOrder::None, "resume"},
     {FlightOrder::ReturnNow, "return"},
     {FlightOrder::HoldHere, "hold"}}};

/** The search for a lost iceberg. */
struct Search
{
    int iceberg = -1;
    LostSearch path;
    bool operator==(const Search&) const = default;
};

/** What changes about one UAV, as it is put on record: the parts of `Simulation` hold it. */
struct UavState
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0; ///< through the air
    FlightMode mode = FlightMode::Idle;
    int target = -1; ///< index into the icebergs; -1: none
    int lastReached = -1;
    bool isAlone = false; ///< planned by itself until all are planned again: see `PlanTrigger`
    LosGuidance guidance;
    double runOut_m = 0;         ///< left to fly straight in mode RunOut
    int misses = 0;              ///< times the target was passed without reaching it
    std::optional<AimedLeg> aim; ///< flown in mode Leg instead of the way to the target's estimate
    std::vector<int> members;    ///< the target is the middle of these; empty: it is one iceberg
    double membersBy_s = 0;      ///< when they are overdue
    std::optional<Search> search;
    double aloft_s = 0;         ///< since take-off
    double ground_s = 0;        ///< left to stand in mode Ground
    double withheld_s = 0;      ///< of the endurance, for its recovery slot
    std::optional<Point> via_m; ///< corner flown to, round which the geofence leads
    /** With fence and endurance: a proven path home from the next command on. */
    std::optional<ReturnPath> returnPath;
    FlightOrder order = FlightOrder::None;
    Point hold_m = Point::Zero(); ///< in mode Hold: what it circles

    /** Not on its way home, on the ground or holding: there no plan is asked for or taken. */
    [[nodiscard]] bool isPlanned() const
    {
        return mode != FlightMode::Home && mode != FlightMode::Ground && mode != FlightMode::Hold;
    }
    bool operator==(const UavState&) const = default;
};

/** Everything that changes while flying, as it is put on record. */
struct WorldState
{
    std::int64_t step = 0;
    std::vector<UavState> uavs; ///< one per UAV of the scenario
    std::vector<Track> tracks;  ///< one per iceberg of the scenario, the not yet appeared included
    double sigmaSum_m2 = 0;
    double zeta_m2s = 0;
    std::vector<int> unclustered; ///< in no cluster until seen: one was passed without them
    /** Of icebergs given up: where they may be, for when the rest is fresh. */
    std::vector<Search> givenUp;
    /** Least horizontal distance so far of two UAVs aloft in one altitude layer. */
    std::optional<double> closest_m;

    /** Through the air, all UAVs. */
    [[nodiscard]] double flown_m() const
    {
        double sum_m = 0;
        for (const UavState& uav : uavs)
            sum_m += uav.flown_m;
        return sum_m;
    }
    bool operator==(const WorldState&) const = default;
};

[[nodiscard]] inline std::size_t toIndex(int i)
{
    return static_cast<std::size_t>(i);
}

} // namespace berg
