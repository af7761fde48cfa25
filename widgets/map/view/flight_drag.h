#pragma once

#include "widgets/map/view/map_handles.h"

namespace berg {

// What can be dragged in flight, too: there the end of a drag is told to the flight, and what is
// under way is only drawn.

/** Direction and speed of the wind, by the tip of its arrow. */
[[nodiscard]] std::unique_ptr<HandleDrag> makeWindDrag(const MapToolContext& context,
                                                       const MapHandle& handle);

/** Where the asset is now; in flight only. */
[[nodiscard]] std::unique_ptr<HandleDrag> makeAssetDrag(const MapToolContext& context,
                                                        const MapHandle& handle);

} // namespace berg
