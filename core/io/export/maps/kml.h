#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * Writes KML 2.2: a folder of icebergs (their data as extended data), one of each UAV with its
 * home, its visits and its path, airspace, the operation volume, area, no-fly areas, stand-off ring
 * and asset. A path or track is a `gx:Track` with times if the scenario has a start time, else a
 * line. Lines and areas are cut at the antimeridian.
 */
void writeKml(const ExportContent& content, const TextSink& put);

/** Writes the KML as `doc.kml` in a zip archive. Throws as `writeZip`. */
void writeKmz(const ExportContent& content, const TextSink& put);

} // namespace berg
