#pragma once

#include "core/base/index.h"
#include "core/coverage/prediction_input.h"
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
    IcebergIndex iceberg;
    /** First UAV that has it in view; nullopt if somebody else reported it. */
    std::optional<int> uav;
};

/** Present activity of an autopilot. */
enum class FlightMode
{
    Idle, ///< holding, because no iceberg is known
    Leg,  ///< flying to the target
    /** Flying straight on past a target that was too close to turn onto, before turning back. */
    RunOut,
    Circle, ///< circling the last iceberg reached, because every iceberg is in view
    Search, ///< searching for a lost iceberg
    Home,   ///< flying home
    Ground, ///< on the ground between two sorties
    Hold    ///< circling a place by order
};

/** An operator's order to a UAV, in force until an order to resume. */
enum class FlightOrder
{
    /** Fly as planned. */
    None,
    ReturnNow, ///< fly home and stay there
    HoldHere   ///< circle the place where the order was received
};

/** Names of the orders in run files. */
inline constexpr std::array<Named<FlightOrder>, 3> kFlightOrderNames{
    {{FlightOrder::None, "resume"},
     {FlightOrder::ReturnNow, "return"},
     {FlightOrder::HoldHere, "hold"}}};

/** The search for a lost iceberg. */
struct Search
{
    IcebergIndex iceberg;
    LostSearch path;
    bool operator==(const Search&) const = default;
};

/** Recorded state of one UAV; the parts of `Simulation` hold these values. */
struct UavState
{
    DubinsState pose;
    double u_radps = 0;
    double crossTrack_m = 0;
    double flown_m = 0; ///< distance flown through the air
    FlightMode mode = FlightMode::Idle;
    std::optional<IcebergIndex> target; ///< index of the target iceberg; nullopt without a target
    std::optional<IcebergIndex> lastReached; ///< index of the last iceberg reached; nullopt before
    bool isAlone = false; ///< planned separately until the next plan for all: see `PlanTrigger`
    LosGuidance guidance;
    double runOut_m = 0; ///< distance left to fly straight in mode RunOut
    int misses = 0;      ///< number of times the target was passed without reaching it
    /** Leg to fly in mode Leg in place of the straight leg to the target's estimate. */
    std::optional<AimedLeg> aim;
    IcebergList members;    ///< icebergs of the target cluster; empty for a single iceberg
    double membersBy_s = 0; ///< run time from which the cluster is overdue, s
    std::optional<Search> search;
    double aloft_s = 0;         ///< time since take-off
    double ground_s = 0;        ///< time left on the ground
    double withheld_s = 0;      ///< endurance withheld for its recovery slot
    std::optional<Point> via_m; ///< fence corner that the UAV flies to now
    /** With fence and endurance: the proven path home from the next command on. */
    std::optional<ReturnPath> returnPath;
    FlightOrder order = FlightOrder::None;
    Point hold_m = Point::Zero(); ///< in mode Hold: centre of the circle

    /**
     * Returns true if plans are made for the UAV: it neither flies home, nor holds, nor is on the
     * ground.
     */
    [[nodiscard]] bool isPlanned() const
    {
        return mode != FlightMode::Home && mode != FlightMode::Ground && mode != FlightMode::Hold;
    }
    bool operator==(const UavState&) const = default;
};

/** Recorded state of everything that changes in flight. */
struct WorldState
{
    std::int64_t step = 0;
    std::vector<UavState> uavs; ///< by UAV of the scenario
    /** By iceberg of the scenario, icebergs that have yet to appear included. */
    std::vector<Track> tracks;
    double sigmaSum_m2 = 0;
    double zeta_m2s = 0;
    /** Icebergs that a pass over their cluster missed; in no cluster until seen. */
    IcebergList unclustered;
    /** Searches given up, with the remaining probabilities, for later plans. */
    std::vector<Search> givenUp;
    /** Least horizontal distance so far of two UAVs aloft in one altitude layer. */
    std::optional<double> closest_m;

    /** Returns the distance flown through the air by all UAVs, m. */
    [[nodiscard]] double flown_m() const
    {
        double sum_m = 0;
        for (const UavState& uav : uavs)
            sum_m += uav.flown_m;
        return sum_m;
    }
    bool operator==(const WorldState&) const = default;
};

} // namespace berg
