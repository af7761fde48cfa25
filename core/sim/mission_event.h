#pragma once

#include "core/plan/policy/policy.h"
#include "core/sim/world_state.h"

#include <string>
#include <vector>

namespace berg {

/** What the log of a mission names. */
enum class EventKind
{
    Planned,
    Reached,
    Sighted,
    Appeared,
    PlannerFailed, ///< it threw; the last plan is flown on
    Alarm,         ///< found to be on its way into the inner ring of the asset
    Intervention,
    Left, ///< the area
    Lost,
    Found,
    GivenUp,
    HomeBound,
    Landed,
    TookOff,
    LateHome,  ///< home cannot be reached in time any more: another wind, or it had to wait
    Close,     ///< two UAVs of one altitude layer have come near each other
    LeftFence, ///< a UAV has left the geofence
    BackInside ///< it is inside again
};

/** What an intervention that the log names has changed. */
enum class ChangedPart
{
    Planner, ///< tau or policy
    Wind,
    Asset,
    Assignment, ///< of an iceberg to a UAV
    Removal,    ///< of an iceberg
    Order       ///< to a UAV
};

/** One line of the event log: what happened, without words. Sentences are made where it is shown.
 */
struct MissionEvent
{
    double time_s = 0;
    EventKind kind = EventKind::Planned;
    int iceberg = -1;      ///< index; -1: none in particular
    int uav = -1;          ///< likewise
    int otherUav = -1;     ///< Close: the other one
    double distance_m = 0; ///< Close: between them
    double entry_s = 0;    ///< Alarm: until it is in the ring
    bool reported = false; ///< Sighted: not by a UAV, by somebody else; Appeared: added in flight
    std::vector<int> together;                ///< Reached: the others of its cluster
    AnswerSource source = AnswerSource::None; ///< Planned
    bool fellBack = false;                    ///< Planned: the last plan is kept
    std::string failure;                      ///< PlannerFailed: the reason, in English
    ChangedPart changed{};                    ///< Intervention
    PolicyKind policy{};                      ///< Intervention in the planner: in force since then
    double tau = 0;                           ///< likewise
    FlightOrder order{};                      ///< Intervention by an order: that one
};

} // namespace berg
