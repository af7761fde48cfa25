#pragma once

#include "core/tracking/drift_errors.h"
#include "core/tracking/drift_path.h"

#include <optional>
#include <string>
#include <vector>

namespace berg {

/** Result of the command `drift`. */
struct DriftReport
{
    IcebergDimensions dimensions;
    DriftLaw law;
    /** In a constant wind and current; nullopt with a forecast. */
    std::optional<Point> velocity_mps;
    std::vector<DriftPoint> path;       ///< times in seconds since 1970 UTC; empty without forecast
    std::vector<DriftLeadError> errors; ///< empty without a recorded track
};

/** Returns the report as one JSON document; members without content are left out. */
[[nodiscard]] std::string driftJson(const DriftReport& report);

/**
 * Returns the path as CSV: `time,latitude_deg,longitude_deg,speed_mps,direction_deg`. Imports read
 * it as a track.
 */
[[nodiscard]] std::string driftPathCsv(const std::vector<DriftPoint>& path);

/** Returns the errors as CSV: `lead_h,starts,moved_km,drift_km,last_velocity_km`. */
[[nodiscard]] std::string driftErrorsCsv(const std::vector<DriftLeadError>& errors);

/** Returns the UTC time of seconds since 1970 as ISO 8601 text. */
[[nodiscard]] std::string utcTextOf(double time_s);

} // namespace berg
