#pragma once

// Private to core/io.

#include "core/io/import/map_shapes.h"
#include "core/io/text/read_budget.h"

namespace berg {

/** What a KML text draws, with its styles; without what is linked or an image. */
[[nodiscard]] std::vector<MapShape> readKmlShapes(std::string_view text, ReadBudget& budget);

/** The memory of a shape. */
[[nodiscard]] std::size_t memoryOf(const MapShape& shape);

} // namespace berg
