#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

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
};

[[nodiscard]] RouteColours routeColours(const MapPicture& picture, const Theme& theme,
                                        std::size_t uav);

/** Of the brackets round an iceberg in view: of several UAVs the colour that is none of theirs. */
[[nodiscard]] QColor bracketColour(const MapPicture& picture, const Theme& theme);

/** What the legend draws the ways of the UAVs in: of several the colour that is none of theirs. */
[[nodiscard]] RouteColours legendColours(const MapPicture& picture, const Theme& theme);

} // namespace berg
