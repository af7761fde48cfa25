#pragma once

#include "core/base/geodesy.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPolygonF>
#include <QRectF>

#include <vector>

namespace berg {

/** One meridian or parallel across the view. */
struct GraticuleLine
{
    bool isMeridian = false;
    double value_deg = 0; ///< longitude in (-180, 180] or latitude
    QPolygonF path_px;
};

struct Graticule
{
    std::vector<GraticuleLine> lines;
    int latitudeDecimals = 0; ///< of the minutes in labels; -1: whole degrees
    int longitudeDecimals = 0;
    QPointF middle_px;   ///< of the plane
    double reach_px = 0; ///< from there; lines are not labelled beyond
};

/**
 * Meridians and parallels of the part of the Earth that `rect` shows, at round steps of about
 * `spacing_px`. Towards a pole, where they would come too close, some meridians end.
 */
[[nodiscard]] Graticule graticuleOf(const LocalFrame& frame, const MapViewTransform& view,
                                    const QRectF& rect, double spacing_px = 150);

/** The number of one line. */
struct GraticuleLabel
{
    QString text;
    QRectF rect;
};

/**
 * Numbers in `rect` that cover neither each other nor `taken`: longitudes along the upper edge and
 * latitudes along the right one where that can be, else along another edge or on the line.
 */
[[nodiscard]] std::vector<GraticuleLabel>
graticuleLabels(const Graticule& graticule, const QRectF& rect, const QFontMetricsF& metrics,
                const QLocale& locale, std::vector<QRectF> taken);

/** Angle of true north at a place of the plane, radians clockwise from straight up. */
[[nodiscard]] double northAngle_rad(const LocalFrame& frame, const Point& position_m);

} // namespace berg
