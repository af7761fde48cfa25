#pragma once

#include "widgets/map/paint/label_placement.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

/** Steps of directions while Shift is down. */
inline constexpr double kDirectionStep_deg = 15;

// Marks that the interactive map adds to its picture: what is selected, meant or being done. All
// are told by shape, not by colour alone; each function leaves the painter as it found it.

/** Selected: a ring with four handles round the symbol. */
void paintSelectionMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme);

/** The place of a later visit in a plan of this colour: like that of the first, and fainter. */
void paintLaterDisk(QPainter& painter, const QPointF& centre, int number, const QColor& colour,
                    const Theme& theme);
/** Under the cursor or meant by a row of a list: a thin ring. */
void paintHoverMark(QPainter& painter, const LabelDisk& symbol, const Theme& theme);

/** The frame that selects what is inside. */
void paintRubberBand(QPainter& painter, const QRectF& band, const Theme& theme);

/** From where something was taken to where it is now. */
void paintDragTrail(QPainter& painter, const QLineF& path, const Theme& theme);

/** Where an iceberg truly was, by its record; faint. Points on the screen, in the order of time. */
void paintRecordedTrack(QPainter& painter, const QPolygonF& path, const Theme& theme);

/** Selected or under the cursor: the outline of the area is thicker. */
void paintAreaMark(QPainter& painter, const QPolygonF& outline, bool isSelected,
                   const Theme& theme);

/** A few words in the middle of a line, on a panel. */
void paintTag(QPainter& painter, const QPointF& centre, const QString& text, const Theme& theme);

/** Lines of words beside the cursor, inside `area`, on a panel. */
void paintBubble(QPainter& painter, const QPointF& at, const QString& text, const QRectF& area,
                 const Theme& theme);

/** A frame inside the edge: this widget has the keys. */
void paintFocusFrame(QPainter& painter, const QRectF& rect, const Theme& theme);

} // namespace berg
