#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/map/picture/map_picture.h"

namespace berg {

/** Returns the map of an export: the UAVs' paths as written to the file, and the icebergs, with
 * printable names. */
[[nodiscard]] MapPicture exportPicture(const ExportContent& content);

/** Returns the wind at the time of the export, for maps that stand alone. */
[[nodiscard]] MapAir exportAir(const ExportContent& content);

/** Returns the time until the iceberg enters the asset's inner ring, s; zero inside. Returns
 * nullopt if it does not enter within the horizon, if it is not present, or if there is no asset.
 */
[[nodiscard]] std::optional<double> ringEntry_s(const ExportContent& content,
                                                const ExportIceberg& iceberg);

} // namespace berg
