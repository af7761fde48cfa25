#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

#include <optional>

namespace berg {

/**
 * Colours of one UAV's lines. A single UAV has different colours for plan and track; in a fleet
 * each UAV uses its own colour for both.
 */
struct RouteColours
{
    QColor uav;    ///< heading and search pattern
    QColor plan;   ///< lines and order numbers of the plan
    QColor former; ///< plan before the last change
    QColor track;  ///< newest part of the track
    QColor home;   ///< landing place
};

/**
 * Returns the colours of UAV `uav`; for nullopt, as in the legend, a fleet gets a neutral colour.
 */
[[nodiscard]] RouteColours routeColours(const MapPicture& picture, const Theme& theme,
                                        std::optional<std::size_t> uav = std::nullopt);

} // namespace berg
