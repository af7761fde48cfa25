#pragma once

#include "core/study/drift_tracks.h"

#include <string>
#include <vector>

namespace berg {

/** Predicted drift of the icebergs of a scenario. */
struct DriftTracksReport
{
    const Scenario& scenario;
    std::vector<DriftTrack> tracks;
    /** By track: comparison with a recorded track; empty without one. */
    std::vector<std::vector<DriftLeadError>> errors;
};

/**
 * Returns the report as one JSON document: `tracks` with `id`, `length_m` and `draft_m` (if known),
 * `end` ("complete" or "forecast"), `grounded_h`, `points` and `errors`.
 */
[[nodiscard]] std::string driftTracksJson(const DriftTracksReport& report);

/**
 * Returns the points as CSV:
 * `iceberg,time,hours,latitude_deg,longitude_deg,speed_mps,direction_deg,sd_m,aground,error_m`.
 * `time` is empty if the start of the scenario is unknown, `error_m` without a recorded track.
 */
[[nodiscard]] std::string driftTracksCsv(const DriftTracksReport& report);

/**
 * Returns the tracks as GeoJSON (RFC 7946): a line for each iceberg, and a point with its hours and
 * standard deviation for each time.
 */
[[nodiscard]] std::string driftTracksGeoJson(const DriftTracksReport& report);

} // namespace berg
