#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * Writes an RFC 7946 FeatureCollection. Each feature has a `kind`: "uav" (start of its path),
 * "iceberg" (now; for scope `Track` its true position, else the estimate), "visit" (place of a
 * visit, in order), "plan", "path" or "track" (the line flown), "area", "no-fly", "stand-off",
 * "airspace", the parts of the operation volume (`kVolumePartIds`, with `ceiling_m` if they have
 * one), "asset" and "home" (if it is not the start). Lines have `coordinateProperties` with `times`
 * (ISO 8601) if the scenario has a start time, else `times_s`, one per position. Positions are
 * longitude, latitude; altitudes are properties. `velocity_mps` is the iceberg's own velocity,
 * `drift_mps` includes the current; both are east, north. A visit to a cluster has `cluster`, the
 * ids of all icebergs in view there.
 */
void writeGeoJson(const ExportContent& content, const TextSink& put);

} // namespace berg
