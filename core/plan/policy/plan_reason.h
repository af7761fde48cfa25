#pragma once

namespace berg {

/** Why a plan is needed at this instant. */
enum class PlanReason
{
    None,
    /** The run starts. */
    Start,
    TargetReached,
    /** The UAV without a target can fly to an iceberg again. */
    OutOfView,
    Appeared,
    Intervention,
    Sighted, ///< on an aimed leg: an iceberg other than the target came into view
    /** On an aimed leg: the predicted sighting has not come; also an overdue cluster. */
    Overdue,
    Left,        ///< an iceberg has left the area
    Lost,        ///< an iceberg is not where it should be
    Found,       ///< a lost iceberg is in view
    GivenUp,     ///< the search for an iceberg has ended without success
    TakeOff,     ///< the next sortie begins
    HoldFlown,   ///< a planned hold has ended
    SeenByOther, ///< another UAV has the target in view
    Fleet        ///< another UAV needs a plan
};

} // namespace berg
