#pragma once

// This header is private to core/land. The files of resources/map are part of the program.

#include "core/land/land_data.h"

namespace berg {

/** Returns the bytes of the file for this detail. */
[[nodiscard]] std::span<const std::uint8_t> landBytes(LandDetail detail);

} // namespace berg
