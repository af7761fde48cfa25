#pragma once

#include "core/tracking/observer.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

// The signs of the map. All sizes are device-independent pixels; each function leaves the painter
// as it found it.

/** Half the width of an iceberg's symbol by size class (WMO: small < 60 m, medium < 120 m long). */
[[nodiscard]] double icebergSymbolRadius_px(double radius_m);

/** How an iceberg is drawn. */
struct IcebergLook
{
    double radius_px = 10; ///< of the symbol
    double ring_px = 0;    ///< radius of the sigma ring; 0: none
    double ringOpacity = 1;
    QColor sigma;                              ///< colour of sigma
    bool inView = false;                       ///< seen now: pure ice, no ring
    QColor bracket{};                          ///< of one seen now; invalid: the UAV's
    bool later = false;                        ///< still to come: faint and dashed
    TrackStatus status = TrackStatus::Tracked; ///< lost: an empty dashed form with a question mark
    unsigned variant = 0;                      ///< which of the forms
};

/**
 * An angular form of ice with a lit and a shaded facet inside its sigma ring. Seen now: white ice
 * with a corner bracket on each side, so that the state is told by shape too. Lost: a dashed
 * outline with a question mark; given up: with a cross.
 */
void drawIceberg(QPainter& painter, const QPointF& centre, const IcebergLook& look,
                 const Theme& theme);

/** UAV as a swept dart; `direction_rad` counter-clockwise from the right of the screen. */
void drawUav(QPainter& painter, const QPointF& centre, double direction_rad, const QColor& colour,
             const Theme& theme);

/** Platform to protect: a square on four legs. */
void drawAsset(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Where a UAV lands: a house of this colour. */
void drawHome(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme);

/** Where the radio link is kept from: a mast. */
void drawStation(QPainter& painter, const QPointF& centre, const Theme& theme);

/** What a point of no return takes with the letters above it, which names keep clear of. */
[[nodiscard]] QRectF noReturnRect(const QPointF& centre);
/** A point of no return on a plan of this colour. */
void drawNoReturn(QPainter& painter, const QPointF& centre, const QColor& colour,
                  const Theme& theme);

/** Where an iceberg is in truth: a small diamond. */
void drawTruth(QPainter& painter, const QPointF& centre, const Theme& theme);

/** A filled triangle with an exclamation mark. */
void drawAlarm(QPainter& painter, const QPointF& centre, const Theme& theme);

/** Straight piece of a fence; its posts are on the right-hand side of who walks along it. */
void drawFence(QPainter& painter, const QLineF& line, const Theme& theme);

/** Inside of an outline that no UAV flies into. */
void drawClosed(QPainter& painter, const QPolygonF& outline, const QRectF& shown,
                const Theme& theme);

/** A UAV alone is to visit this iceberg: a pin of its colour. */
void drawPin(QPainter& painter, const QPointF& tip, const QColor& colour, const Theme& theme);

/** Of the pattern that is flown to find a lost iceberg. */
[[nodiscard]] QPen searchPen(const QColor& uav);
/** Line round icebergs that are planned as one point. */
[[nodiscard]] QPen clusterPen(const QColor& plan);
/** Of the circle that holds 95 %. */
[[nodiscard]] QPen circlePen(const Theme& theme);
/** Of the rings of what is to be protected. */
[[nodiscard]] QPen rangeRingPen(const Theme& theme);
[[nodiscard]] QPen alarmRingPen(const Theme& theme, double width_px = 1.4);

/** Of the range of the radio link. */
[[nodiscard]] QPen linkRingPen(const Theme& theme);

/** Line with a filled head at its end. */
void drawArrow(QPainter& painter, const QLineF& line, const QPen& pen, double head_px);

/** Arrow head in the middle of a line, to show which way it is flown. */
void drawDirectionMark(QPainter& painter, const QLineF& line, const QColor& colour, double size_px);

/** A point that a leg aims at: a small cross. */
void drawAim(QPainter& painter, const QPointF& centre, const QColor& colour, const Theme& theme);

inline constexpr double kSearchPlace_px = 7;
/** A place where a lost iceberg may be: a dotted ring of `kSearchPlace_px`. */
void drawSearchPlace(QPainter& painter, const QPointF& centre, const QColor& colour);

/** The line of what a plan took the place of: thin and dashed. */
[[nodiscard]] QPen formerPlanPen(const QColor& colour);

/** Number in a disk of this colour; invalid: that of a plan. */
void drawOrderDisk(QPainter& painter, const QPointF& centre, double radius_px, int number,
                   const Theme& theme, const QColor& colour = {});

/** Text over the map with a halo of the background's colour. */
void drawHaloText(QPainter& painter, const QRectF& rect, Qt::Alignment alignment,
                  const QString& text, const QColor& colour, const QColor& halo);

/**
 * Text whose digits all take the width of the widest one, so that a running number does not
 * jitter in fonts without tabular figures. Starts at `baseline`.
 */
void drawTabular(QPainter& painter, const QPointF& baseline, const QString& text);
/** Advance of `drawTabular`. */
[[nodiscard]] double tabularWidth(const QFontMetricsF& metrics, const QString& text);

} // namespace berg
