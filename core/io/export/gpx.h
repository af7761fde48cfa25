#pragma once

#include "core/io/export/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * GPX 1.1: a waypoint for each iceberg, home and the asset (`type` says which), a route for each
 * UAV with the visits to come, a track for each path or flown track, in segments that do not cross
 * the antimeridian. Times only when the scenario has a start time. What is known of an iceberg is
 * in `extensions`, in a namespace of our own.
 */
void writeGpx(const ExportContent& content, const TextSink& put);

} // namespace berg
