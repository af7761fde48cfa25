#pragma once

#include "core/io/export/export_content.h"
#include "widgets/map/picture/map_picture.h"

namespace berg {

/** Map of what is exported: the ways of the UAVs as they are written, and the icebergs, with names
 * that can be printed. */
[[nodiscard]] MapPicture exportPicture(const ExportContent& content);

/** Wind of then, for maps that stand alone. */
[[nodiscard]] MapAir exportAir(const ExportContent& content);

/** When the iceberg enters the inner ring of the asset, seconds from then; 0: it is inside; none:
 * not until the horizon, or it is not there. */
[[nodiscard]] std::optional<double> ringEntry_s(const ExportContent& content,
                                                const ExportIceberg& iceberg);

} // namespace berg
