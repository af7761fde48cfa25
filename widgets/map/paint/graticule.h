#pragma once

#include "core/earth/geodesy.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <vector>

namespace berg {

/** A meridian or parallel across the view. */
struct GraticuleLine
{
    bool isMeridian = false;
    double value_deg = 0; ///< longitude in (-180, 180] or latitude
    QPolygonF path_px;
};

/** Meridians and parallels of a view. */
struct Graticule
{
    std::vector<GraticuleLine> lines;
    /** Decimals of minutes in labels; nullopt means whole degrees. */
    std::optional<int> latitudeDecimals;
    std::optional<int> longitudeDecimals;
    QPointF middle_px;   ///< middle of the plane
    double reach_px = 0; ///< radius from `middle_px` within which lines are labelled
};

/**
 * Returns the meridians and parallels in the part of the Earth shown in `rect`, at round steps of
 * about `spacing_px`. Some meridians end before a pole, where they would come too close.
 */
[[nodiscard]] Graticule graticuleOf(const LocalFrame& frame, const MapViewTransform& view,
                                    const QRectF& rect, double spacing_px = 150);

/** Label of one line. */
struct GraticuleLabel
{
    QString text;
    QRectF rect;
};

/**
 * Returns labels in `rect` that overlap neither each other nor `taken`: longitudes at the top edge
 * and latitudes at the right edge if possible, otherwise at another edge or on the line. A line
 * without a free place has no label.
 */
[[nodiscard]] std::vector<GraticuleLabel>
graticuleLabels(const Graticule& graticule, const QRectF& rect, const QFontMetricsF& metrics,
                const QLocale& locale, std::vector<QRectF> taken);

/** Returns the angle of true north at a place of the plane, radians clockwise from straight up;
 * zero at a pole. */
[[nodiscard]] double northAngle_rad(const LocalFrame& frame, const Point& position_m);

} // namespace berg
