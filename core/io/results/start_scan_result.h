#pragma once

#include "core/study/start_scan.h"

#include <string>

namespace berg {

/**
 * Returns the scan as one JSON document: `starts` with `start_utc`, `delay_h`, `zeta_m2s` (null if
 * it cannot be flown), `visits`, `weather` and, unless it is "go", `reason` with `uav`, `limit`,
 * `value`, `limit_value` and `time`; `best` is the time of the best start or null.
 */
[[nodiscard]] std::string startScanJson(const StartScan& scan);

/**
 * Returns the scan as CSV:
 * `start_utc,delay_h,zeta_m2s,visits,weather,uav,limit,value,limit_value,time,best`.
 */
[[nodiscard]] std::string startScanCsv(const StartScan& scan);

/** Returns the reason and time of the weather of a start in words, or an empty text for "go". */
[[nodiscard]] std::string startReasonText(const StartScan& scan, const StartOutcome& start);

} // namespace berg
