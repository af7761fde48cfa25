#pragma once

#include "core/mission/recorder.h"
#include "widgets/theme/mission_clock.h"

#include <QLocale>
#include <QString>

namespace berg {

/**
 * Returns a line of the event list in the language and units of the window, e.g. "03:21  berg-7
 * reached". Icebergs and UAVs are looked up by index; the UAV is named if there are several.
 */
[[nodiscard]] QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                                const std::vector<Uav>& uavs, const QLocale& locale,
                                const MissionClock& clock = {});

/** Returns the sentence of the line without the time. */
[[nodiscard]] QString eventSentence(const MissionEvent& event, const std::vector<Iceberg>& icebergs,
                                    const std::vector<Uav>& uavs, const QLocale& locale);

/** Returns the reason for a plan, e.g. "iceberg reached", or an empty text for none. */
[[nodiscard]] QString planReasonText(PlanReason reason);

/** Returns the order of a plan by name: "berg-3, berg-1, berg-2". */
[[nodiscard]] QString planOrderText(const UavPlan& plan, const std::vector<Iceberg>& icebergs);

} // namespace berg
