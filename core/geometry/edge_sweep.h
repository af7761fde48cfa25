#pragma once

// This header is private to core/base. It finds out which edges of polygons can meet.

#include "core/geometry/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace berg {

/** Edge of a polygon. The caller chooses `index`. */
struct SweptEdge
{
    Point from;
    Point to;
    std::size_t index = 0;
    double begin = 0; ///< extent along the axis of the sweep
    double end = 0;
};

/**
 * Returns true if `meets(a, b)` holds for any two edges. Calls it only for edges that overlap along
 * one axis, the one on which edges are shorter: about n log n calls for outlines of n short edges,
 * n^2 / 2 at worst. Coordinates must be finite.
 */
template <class Meets>
[[nodiscard]] bool anyMeet(std::vector<SweptEdge> edges, const Meets& meets)
{
    Point lengths_m = Point::Zero();
    for (const SweptEdge& edge : edges)
        lengths_m += (edge.to - edge.from).cwiseAbs();
    const Eigen::Index axis = lengths_m.x() <= lengths_m.y() ? 0 : 1;
    for (SweptEdge& edge : edges) {
        edge.begin = std::min(edge.from[axis], edge.to[axis]);
        edge.end = std::max(edge.from[axis], edge.to[axis]);
    }
    std::ranges::sort(edges, {}, &SweptEdge::begin);
    std::vector<SweptEdge> open;
    for (const SweptEdge& edge : edges) {
        std::erase_if(open, [&](const SweptEdge& other) { return other.end < edge.begin; });
        for (const SweptEdge& other : open)
            if (meets(other, edge))
                return true;
        open.push_back(edge);
    }
    return false;
}

} // namespace berg
