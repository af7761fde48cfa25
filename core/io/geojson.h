#pragma once

#include "core/io/formats.h"

namespace berg {

/**
 * RFC 7946 FeatureCollection. Each feature has `kind`: "uav" (its start), "iceberg" (at t = 0, for
 * a run at its end: true position and sigma there), "visit" (where an iceberg is or was met, in
 * order), "plan" or, for a run, "track" (the line flown over), "area". Lines have
 * `coordinateProperties` with `times` (ISO 8601) when the scenario has a start time, else
 * `times_s`, one per position. Positions are longitude, latitude; altitudes are properties.
 * `velocity_mps` is the iceberg's own, `drift_mps` includes the current; both are east, north. A
 * visit to a cluster has `cluster`, the ids of all that are in view there.
 */
[[nodiscard]] std::string geoJson(const ExportSource& source);

} // namespace berg
