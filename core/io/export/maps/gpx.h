#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * Writes GPX 1.1: a waypoint for each iceberg, home and the asset (distinguished by `type`), a
 * route with the future visits of each UAV, and a track for each path or flown track, in segments
 * that do not cross the antimeridian. Times need a start time of the scenario. Data of an iceberg
 * are in `extensions`, in Bergwatch's own namespace.
 */
void writeGpx(const ExportContent& content, const TextSink& put);

} // namespace berg
