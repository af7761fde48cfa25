#pragma once

#include "core/io/export/content/export_content.h"

namespace berg {

/**
 * Returns the `QGC WPL 110` waypoint text of the content's only UAV, in the ArduPilot dialect: row
 * 0 is home, 12 columns separated by one tab, LF, '.' decimals in any locale, nine decimals for
 * degrees. It has no comments or blank lines, which QGroundControl rejects. Throws as `mavMission`.
 */
[[nodiscard]] std::string wplText(const ExportContent& content);

} // namespace berg
