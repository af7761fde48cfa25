#pragma once

#include "widgets/map/paint/map_overlays.h"

namespace berg {

// The panel of the map that shows wind and current: an arrow across the middle of a dial to where
// the wind blows to. From the middle to its tip it is as long as the wind is fast; the ring round
// the dial is the airspeed of the slowest UAV, the dashed one where `validate` begins to warn.

/** Empty: there is nothing to show. It does not depend on what the wind is. */
[[nodiscard]] QSizeF windPanelSize(const MapAir& air, const MapStyle& style);
void paintWindPanel(QPainter& painter, const QRectF& rect, const MapAir& air,
                    const MapStyle& style);

/** Where the tip of the arrow is; in calm the middle of the dial. */
[[nodiscard]] QPointF windTip(const QRectF& panel, const MapAir& air);

/**
 * The wind when the tip is there: steps of half a metre a second or a knot and of 5 degrees, or
 * those of `kDirectionStep_deg`; always slower than the UAV flies.
 */
[[nodiscard]] Point windAtTip(const QRectF& panel, const MapAir& air, const QPointF& tip,
                              bool inLargeSteps);

/** The airspeed share from which on the wind is strong. */
[[nodiscard]] bool isStrong(const MapAir& air);

/** "Wind 8.0 m/s from 250°", "Wind 18.0 m/s from 250°, strong", "No wind". */
[[nodiscard]] QString windText(const MapAir& air, const QLocale& locale);

/** All there is to say about the panel, for its tool tip. */
[[nodiscard]] QString windToolTip(const MapAir& air, const QLocale& locale);

} // namespace berg
