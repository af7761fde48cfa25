#pragma once

#include "core/io/export_content.h"
#include "widgets/map/map_picture.h"

namespace berg {

/** Map of what is exported: the ways of the UAVs as they are written, and the icebergs, with names
 * that can be printed. */
[[nodiscard]] MapPicture exportPicture(const ExportContent& content);

} // namespace berg
