#pragma once

#include "core/sim/recorder.h"

#include <QString>

namespace berg {

/** One line of the event list, e.g. "03:21  berg-7 reached". `icebergs` by index. */
[[nodiscard]] QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs);

/** The same without the time. */
[[nodiscard]] QString eventSentence(const MissionEvent& event,
                                    const std::vector<Iceberg>& icebergs);

/** Why a plan was made, e.g. "iceberg reached". */
[[nodiscard]] QString planReasonText(PlanReason reason);

/** "berg-3, berg-1, berg-2": the order of a plan by name. */
[[nodiscard]] QString planOrderText(const PlanEvent& plan, const std::vector<Iceberg>& icebergs);

} // namespace berg
