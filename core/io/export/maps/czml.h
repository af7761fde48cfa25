#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * Writes CZML 1.0 for Cesium: a packet for each listed iceberg (its data as `properties`), for
 * area, no-fly areas, stand-off ring, asset and homes, and for each UAV. A UAV moves along its path
 * if the scenario has a start time; otherwise its path is a line. Throws as `TrackPoints`.
 */
void writeCzml(const ExportContent& content, const TextSink& put);

} // namespace berg
