#pragma once

#include "core/io/export/content/export_content.h"
#include "core/io/text/text_sink.h"

#include <string>

namespace berg {

// Paths as tables, in the format of core/io/results/result_csv.h.

/**
 * Returns the order with one row per iceberg in visiting order, UAV after UAV:
 * `sequence,iceberg,name,leg_m,arrival_s,latitude_deg,longitude_deg,east_m,north_m,`
 * `sigma_now_m2,sigma_at_arrival_m2,uav,chance_in_view`. A leg is measured over ground. Icebergs of
 * a cluster share number, place and time.
 */
[[nodiscard]] std::string planCsv(const ExportContent& content);

/** Writes the path or track in the format of a flight's trajectory: by time, then by UAV. */
void writeTrackCsv(const ExportContent& content, const TextSink& put);

} // namespace berg
