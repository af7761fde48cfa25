#pragma once

#include "core/sim/recorder.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>
#include <QString>

namespace berg {

/**
 * One line of the event list, e.g. "03:21  berg-7 reached". Icebergs and UAVs by index; of several
 * UAVs it is said which one it was. In the language and the units of the window.
 */
[[nodiscard]] QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                                const std::vector<Uav>& uavs, const QLocale& locale,
                                const MissionClock& clock = {});

/** The same without the time. */
[[nodiscard]] QString eventSentence(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                                    const std::vector<Uav>& uavs, const QLocale& locale);

/** Why a plan was made, e.g. "iceberg reached". */
[[nodiscard]] QString planReasonText(PlanReason reason);

/** "berg-3, berg-1, berg-2": the order of a plan by name. */
[[nodiscard]] QString planOrderText(const PlanEvent& plan, const std::vector<Iceberg>& icebergs);

} // namespace berg
