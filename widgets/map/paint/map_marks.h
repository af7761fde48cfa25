#pragma once

#include "widgets/map/paint/label_placement.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

struct MapPaint;

/** Direction step while Shift is pressed. */
inline constexpr double kDirectionStep_deg = 15;

// Marks of the interactive map for selection and gestures. They differ in shape, not only in
// colour; each function restores the painter's state.

/** Marks a selected symbol by a ring with four handles. */
void paintSelectionMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme);

/** Draws the number of a later visit: like that of the first visit, but fainter. */
void paintLaterDisk(QPainter& painter, const QPointF& centre, int number, const QColor& colour,
                    const Theme& theme);
/** Marks the symbol under the cursor or of a hovered table row by a thin ring. */
void paintHoverMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme);

/** Draws the frame of a box selection. */
void paintRubberBand(QPainter& painter, const QRectF& band, const Theme& theme);

/** Draws a line from the start of a drag to its present place. */
void paintDragTrail(QPainter& painter, const QLineF& path, const Theme& theme);

/** Draws the recorded true track of an iceberg, faintly; points on the screen in time order. */
void paintRecordedTrack(QPainter& painter, const QPolygonF& path, const Theme& theme);

/** Marks an area that is selected or under the cursor by a thicker outline. */
void paintAreaMark(QPainter& painter, const QPolygonF& outline, bool isSelected,
                   const Theme& theme);

/** Draws a short text on a panel, centred at a point. */
void paintTag(QPainter& painter, const QPointF& centre, const QString& text, const Theme& theme);

/** Draws lines of text on a panel beside the cursor, inside `area`. */
void paintBubble(QPainter& painter, const QPointF& at, const QString& text, const QRectF& area,
                 const Theme& theme);

/**
 * Returns the places of labels, in order: to the right of their anchor, else to the left, below,
 * above or beside a corner of it, the first that touches no solid, no disk, no other anchor and no
 * earlier label. If there is no such place, it is to the right.
 */
[[nodiscard]] std::vector<QRectF> placesBeside(std::span<const LabelRequest> requests,
                                               const LabelSurroundings& surroundings);

/** Draws aircraft, traffic and expected contacts of the live link, with their tracks. */
void paintLive(const MapPaint& p);

/** Draws a frame inside the edge of a widget with keyboard focus. */
void paintFocusFrame(QPainter& painter, const QRectF& rect, const Theme& theme);

} // namespace berg
