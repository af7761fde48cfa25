#pragma once

#include "core/tracking/observer.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

// Symbols of the map. All sizes are device-independent pixels; each function but `drawSearchPlace`
// restores the painter's state.

/** Returns half the width of an iceberg's symbol by WMO size class (small < 60 m, medium < 120 m
 * long). */
[[nodiscard]] double icebergSymbolRadius_px(double radius_m);

/** Style of an iceberg's symbol. */
struct IcebergStyle
{
    double radius_px = 10; ///< half width of the symbol
    double ring_px = 0;    ///< radius of the sigma ring; zero draws none
    double ringOpacity = 1;
    QColor sigma;        ///< colour of sigma
    bool inView = false; ///< in view now: white ice without ring
    QColor bracket{};    ///< brackets of an iceberg in view; if invalid, the colour of UAVs
    bool later = false;  ///< appears later: faint and dashed
    TrackStatus status =
        TrackStatus::Tracked; ///< lost icebergs are a dashed outline with a question mark
    unsigned variant = 0;     ///< selects one of the forms
};

/**
 * Draws an angular form of ice with a lit and a shaded facet inside its sigma ring. In view: white
 * ice with corner brackets, so that the shape shows the state, too. Lost: a dashed outline with a
 * question mark; search given up: with a cross.
 */
void drawIceberg(QPainter& painter, const QPointF& centre, const IcebergStyle& style,
                 const Theme& theme);

/** Draws a UAV as a swept dart; `direction_rad` counter-clockwise from the right of the screen. */
void drawUav(QPainter& painter, const QPointF& centre, double direction_rad, const QColor& colour,
             const Theme& theme);

/** Draws the protected asset: a platform on four legs. */
void drawAsset(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Draws a landing place: a house. */
void drawHome(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme);

/** Draws the ground station of the radio link: a mast. */
void drawStation(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Returns the area of a point of no return with its letters, which names avoid. */
[[nodiscard]] QRectF noReturnRect(const QPointF& centre);
/** Draws a point of no return on a plan of this colour. */
void drawNoReturn(QPainter& painter, const QPointF& centre, const QColor& colour,
                  const Theme& theme);

/** Draws the true position of an iceberg: a small diamond. */
void drawTruth(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Draws a filled triangle with an exclamation mark. */
void drawAlarm(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Draws a straight piece of fence with posts to the right of the direction of `line`. */
void drawFence(QPainter& painter, const QLineF& line, const Theme& theme);

/** Draws the outline of a no-fly area and hatches the part inside `shown`. */
void drawClosed(QPainter& painter, const QPolygonF& outline, const QRectF& shown,
                const Theme& theme);

/** Draws the pin of an iceberg that is assigned to the UAV of this colour. */
void drawPin(QPainter& painter, const QPointF& tip, const QColor& colour, const Theme& theme);

/** Returns the line style of the search pattern for a lost iceberg. */
[[nodiscard]] QPen searchPen(const QColor& uav);
/** Returns the line style around icebergs that are planned as one point. */
[[nodiscard]] QPen clusterPen(const QColor& plan);
/** Returns the line style of the 95 % position circle. */
[[nodiscard]] QPen circlePen(const Theme& theme);
/** Returns the line style of the protected asset's outer ring. */
[[nodiscard]] QPen rangeRingPen(const Theme& theme);
/** Returns the line style of the protected asset's inner ring. */
[[nodiscard]] QPen alarmRingPen(const Theme& theme, double width_px = 1.4);

/** Returns the line style of the radio range. */
[[nodiscard]] QPen linkRingPen(const Theme& theme);

/** Draws a line with a filled head at its end. */
void drawArrow(QPainter& painter, const QLineF& line, const QPen& pen, double head_px);

/** Draws an arrow head in the middle of a line; nothing on a line shorter than five heads. */
void drawDirectionMark(QPainter& painter, const QLineF& line, const QColor& colour, double size_px);

/** Draws an aim point of a leg: a small cross. */
void drawAim(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme);

inline constexpr double kSearchPlace_px = 7;
/** Draws a possible position of a lost iceberg: a dotted ring of `kSearchPlace_px`. It leaves its
 * pen and brush in the painter. */
void drawSearchPlace(QPainter& painter, const QPointF& centre, const QColor& colour);

/** Returns the line style of a replaced plan: thin and dashed. */
[[nodiscard]] QPen formerPlanPen(const QColor& colour);

/** Draws a number in a disk of this colour; an invalid colour means that of a plan. */
void drawOrderDisk(QPainter& painter, const QPointF& centre, double radius_px, int number,
                   const Theme& theme, const QColor& colour = {});

/** Draws text over the map with a halo in the background colour. */
void drawHaloText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment,
                  const QString& text, const QColor& colour, const QColor& halo);

/**
 * Draws text from `baseline` with digits of equal width, so that a running number does not jitter
 * in fonts without tabular figures.
 */
void drawTabular(QPainter& painter, const QPointF& baseline, const QString& text);
/** Returns the advance width of `drawTabular`. */
[[nodiscard]] double tabularWidth(const QFontMetricsF& metrics, const QString& text);

} // namespace berg
