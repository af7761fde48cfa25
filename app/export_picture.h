#pragma once

#include "widgets/map/map_picture.h"
#include "widgets/model/export_preview.h"

namespace berg {

/** Map of what is exported: the ways of the UAVs as they are written, and the icebergs. */
[[nodiscard]] MapPicture exportPicture(const ExportPreview& preview);

} // namespace berg
