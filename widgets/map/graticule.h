#pragma once

#include "core/base/geodesy.h"
#include "widgets/map/map_view_transform.h"

#include <QPolygonF>
#include <QRectF>

#include <vector>

namespace berg {

/** One meridian or parallel across the view. */
struct GraticuleLine
{
    bool isMeridian = false;
    double value_deg = 0; ///< longitude in [-180, 180) or latitude
    QPolygonF path_px;
};

struct Graticule
{
    std::vector<GraticuleLine> lines;
    int latitudeDecimals = 0; ///< of the minutes in labels; -1: whole degrees
    int longitudeDecimals = 0;
};

/**
 * Meridians and parallels of the part of the Earth that `rect` shows, at round steps of about
 * `spacing_px`. Works at the poles and across the antimeridian.
 */
[[nodiscard]] Graticule graticuleOf(const LocalFrame& frame, const MapViewTransform& view,
                                    const QRectF& rect, double spacing_px = 150);

/** Angle of true north at a place of the plane, radians clockwise from straight up. */
[[nodiscard]] double northAngle_rad(const LocalFrame& frame, const Point& position_m);

} // namespace berg
