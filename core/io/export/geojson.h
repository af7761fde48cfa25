#pragma once

#include "core/io/export/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * RFC 7946 FeatureCollection. Each feature has `kind`: "uav" (where its way starts), "iceberg" (as
 * of now: of a track its true position, else the estimate), "visit" (where an iceberg is or was
 * met, in order), "plan", "path" or "track" (the line flown over), "area", "no-fly",
 * "stand-off", "airspace", the parts of the operation volume (`kVolumePartIds`, with `ceiling_m`
 * where they have one), "asset", "home" (where
 * it is not the start). Lines have `coordinateProperties` with `times` (ISO 8601) when the scenario
 * has a start time, else `times_s`, one per position. Positions are longitude, latitude; altitudes
 * are properties. `velocity_mps` is the iceberg's own, `drift_mps` includes the current; both are
 * east, north. A visit to a cluster has `cluster`, the ids of all that are in view there.
 */
void writeGeoJson(const ExportContent& content, const TextSink& put);

} // namespace berg
