#pragma once

#include "core/io/export/export_content.h"
#include "core/io/text/text_sink.h"

namespace berg {

/**
 * CZML 1.0 for Cesium: a packet for each iceberg (what is known of it as `properties`), for the
 * area, asset and homes, and for each UAV, which moves along its way when the scenario has a start
 * time; without one its way is a line.
 */
void writeCzml(const ExportContent& content, const TextSink& put);

} // namespace berg
