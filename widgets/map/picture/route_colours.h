#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

#include <optional>

namespace berg {

/**
 * What the ways of one UAV are drawn in. Of a UAV by itself plan and track have colours of their
 * own; of several each has all its lines in its own.
 */
struct RouteColours
{
    QColor uav;    ///< heading, search
    QColor plan;   ///< lines and numbers
    QColor former; ///< what the plan took the place of
    QColor track;  ///< where it is newest
    QColor home;   ///< where it lands
};

/** None: of no single UAV, as in the legend; of several the colour that is none of theirs. */
[[nodiscard]] RouteColours routeColours(const MapPicture& picture, const Theme& theme,
                                        std::optional<std::size_t> uav = std::nullopt);

} // namespace berg
