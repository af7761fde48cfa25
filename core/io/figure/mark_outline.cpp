#include "core/io/figure/mark_outline.h"

#include <cmath>
#include <numbers>

namespace berg {

namespace {

/** Polygon whose first corner is `turn_rad` clockwise from the top; `inner` < 1 makes a star. */
struct Corners
{
    double scale = 1; ///< of the mark's radius
    int count = 4;
    double turn_rad = 0;
    double inner = 1;
};

std::vector<Pixel> cornersAt(const Pixel& at, double radius_px, const Corners& corners)
{
    const bool isStar = corners.inner < 1;
    const int points = isStar ? 2 * corners.count : corners.count;
    std::vector<Pixel> outline;
    for (int k = 0; k < points; ++k) {
        const double angle_rad = corners.turn_rad + 2 * std::numbers::pi * k / points;
        const double away_px =
            corners.scale * radius_px * (isStar && k % 2 == 1 ? corners.inner : 1);
        outline.push_back(
            {at.x + away_px * std::sin(angle_rad), at.y - away_px * std::cos(angle_rad)});
    }
    return outline;
}

} // namespace

std::vector<Pixel> markOutline(const PlotMark& mark, const Pixel& at)
{
    switch (mark.shape) {
    case MarkShape::Disk:
    case MarkShape::Ring:
        break;
    case MarkShape::Diamond:
        return cornersAt(at, mark.radius_px, {.scale = 1.25});
    case MarkShape::Square:
        return cornersAt(at, mark.radius_px, {.scale = 1.25, .turn_rad = std::numbers::pi / 4});
    case MarkShape::Triangle:
        return cornersAt(at, mark.radius_px, {.scale = 1.3, .count = 3});
    case MarkShape::TriangleDown:
        return cornersAt(at, mark.radius_px,
                         {.scale = 1.3, .count = 3, .turn_rad = std::numbers::pi});
    case MarkShape::Hexagon:
        return cornersAt(at, mark.radius_px, {.scale = 1.15, .count = 6});
    case MarkShape::Star:
        return cornersAt(at, mark.radius_px, {.scale = 1.5, .count = 5, .inner = 0.5});
    }
    return {};
}

} // namespace berg
