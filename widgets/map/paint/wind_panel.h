#pragma once

#include "widgets/map/paint/map_overlays.h"

namespace berg {

// Panel of the map that shows wind and current. An arrow across a dial points downwind; half its
// length is the wind speed, the ring is the airspeed of the slowest UAV, and the dashed ring is the
// limit of strong wind (see `validate`).

/** Returns the size of the panel, independent of the present wind; empty if there is nothing to
 * show. */
[[nodiscard]] QSizeF windPanelSize(const MapAir& air, const MapStyle& style);
/** Paints the panel into `rect`. */
void paintWindPanel(QPainter& painter, const QRectF& rect, const MapAir& air,
                    const MapStyle& style);

/** Returns the position of the arrow's tip; the middle of the dial in calm. */
[[nodiscard]] QPointF windTip(const QRectF& panel, const MapAir& air);

/**
 * Returns the wind for an arrow tip dragged to `tip`: rounded to 0.5 m/s or one knot and to 5
 * degrees, or to `kDirectionStep_deg` if `inLargeSteps`; always below the slowest airspeed.
 */
[[nodiscard]] Point windAtTip(const QRectF& panel, const MapAir& air, const QPointF& tip,
                              bool inLargeSteps);

/** Returns true if the wind reaches the share of the airspeed from which it counts as strong. */
[[nodiscard]] bool isStrong(const MapAir& air);

/**
 * Returns a text such as "Wind 8.0 m/s from 250°", "Wind 18.0 m/s from 250°, strong" or "No wind".
 */
[[nodiscard]] QString windText(const MapAir& air, const QLocale& locale);

/** Returns the tool tip of the panel. */
[[nodiscard]] QString windToolTip(const MapAir& air, const QLocale& locale);

} // namespace berg
