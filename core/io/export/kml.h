#pragma once

#include "core/io/export/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * KML 2.2: folders of icebergs (with what is known of them as extended data) and of each UAV with
 * its visits and its way, airspace, the operation volume, the area, home and asset. A path or track
 * is a `gx:Track` with times when the scenario has a start time, else a line. Lines and the area
 * are cut at the antimeridian.
 */
void writeKml(const ExportContent& content, const TextSink& put);

/** The same as `doc.kml` in a zip archive. */
void writeKmz(const ExportContent& content, const TextSink& put);

} // namespace berg
