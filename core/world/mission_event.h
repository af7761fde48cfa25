#pragma once

#include "core/plan/policy/policy.h"
#include "core/world/world_state.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Kinds of events in the log of a mission. */
enum class EventKind
{
    /** A plan came into force. */
    Planned,
    Reached,
    Sighted,
    Appeared,
    PlannerFailed, ///< the planner failed; the previous plan stays in force
    Alarm,         ///< an iceberg is predicted to enter the asset's inner ring
    Intervention,
    Left, ///< an iceberg has left the area
    Lost,
    Found,
    GivenUp,
    HomeBound,
    Landed,
    TookOff,
    /** The UAV will be late at home, because of a new wind or because it had to wait. */
    LateHome,
    Close,     ///< two UAVs of one altitude layer are closer than the separation
    LeftFence, ///< a UAV has left the geofence
    BackInside ///< the UAV is inside the geofence again
};

/** The part of a mission that an intervention has changed. */
enum class ChangedPart
{
    Planner, ///< tau or policy
    Wind,
    Asset,
    Assignment, ///< assignment of an iceberg to a UAV
    Removal,    ///< removal of an iceberg
    Order       ///< operator's order to a UAV
};

/** One entry of the event log. The log text is composed where it is shown. */
struct MissionEvent
{
    double time_s = 0;
    EventKind kind = EventKind::Planned;
    std::optional<IcebergIndex> iceberg; ///< index; nullopt if no iceberg is concerned
    std::optional<int> uav;              ///< index; nullopt if no UAV is concerned
    std::optional<int> otherUav;         ///< Close: index of the other UAV
    double distance_m = 0;               ///< Close: distance between the two
    double entry_s = 0;                  ///< Alarm: time until it enters the ring
    /** Sighted: reported by somebody other than a UAV; Appeared: added in flight. */
    bool reported = false;
    IcebergList together;                     ///< Reached: other members of the cluster
    AnswerSource source = AnswerSource::None; ///< Planned: origin of the answer
    bool fellBack = false;                    ///< Planned: the previous plan is continued
    std::string failure;                      ///< PlannerFailed: reason, in English
    ChangedPart changed{};                    ///< Intervention: changed part
    PolicyKind policy{};                      ///< Intervention in the planner: policy in force
    double tau = 0;                           ///< Intervention in the planner: tau in force
    FlightOrder order{};                      ///< Intervention by an order: that order
};

} // namespace berg
