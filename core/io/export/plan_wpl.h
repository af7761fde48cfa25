#pragma once

#include "core/io/export/export_content.h"

namespace berg {

/**
 * `QGC WPL 110` waypoint text of the only UAV of the content, in the ArduPilot dialect: row 0 is
 * home, 12 columns separated by one tab, LF, '.' decimals in any locale, nine decimals for degrees.
 * No comments and no blank lines, which QGroundControl rejects.
 */
[[nodiscard]] std::string wplText(const ExportContent& content);

} // namespace berg
