#pragma once

#include "widgets/map/paint/map_layout.h"

#include <QLineF>

#include <cmath>
#include <vector>

namespace berg::test {

inline const QLocale kLocale(QLocale::English);

inline MapLayout layoutOf(const MapPicture& picture, const QSize& size)
{
    const Theme theme = Theme::light();
    return arrangeMap(picture, {.theme = theme, .locale = kLocale},
                      QRectF(QPointF(0, 0), QSizeF(size)));
}

/** Returns straight legs as lines. */
inline std::vector<QLineF> linesOf(const std::vector<QPolygonF>& legs)
{
    std::vector<QLineF> lines;
    for (const QPolygonF& leg : legs)
        lines.push_back(leg.isEmpty() ? QLineF() : QLineF(leg.front(), leg.back()));
    return lines;
}

/** Returns two paths: from the UAV a quarter circle and a line, then another line. */
inline std::vector<MapPath> twoPaths(const Point& from_m)
{
    MapPath first{.path_m = {from_m}, .aim_m = from_m + Point(1500, 2500)};
    for (int i = 1; i <= 10; ++i) {
        const double angle_rad = i * M_PI / 20;
        first.path_m.emplace_back(from_m +
                                  1000 * Point(std::sin(angle_rad), 1 - std::cos(angle_rad)));
    }
    first.path_m.emplace_back(from_m + Point(1000, 2000));
    MapPath second{.path_m = {first.path_m.back(), from_m + Point(3000, 2000)},
                   .aim_m = from_m + Point(3400, 2000)};
    return {std::move(first), std::move(second)};
}

} // namespace berg::test
