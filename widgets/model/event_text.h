#pragma once

#include "core/sim/recorder.h"

#include <QString>

namespace berg {

/** One line of the event list, e.g. "03:21  berg-7 reached". `icebergs` by index. */
[[nodiscard]] QString eventText(const MissionEvent& event, const std::vector<Iceberg>& icebergs);

} // namespace berg
