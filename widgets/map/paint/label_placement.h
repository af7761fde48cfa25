#pragma once

#include <QLineF>
#include <QRectF>

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A round object on the map that labels must not cover. */
struct LabelDisk
{
    QPointF centre_px;
    double radius_px = 0;
};

/** Result for one label. */
struct PlacedLabel
{
    QRectF rect;              ///< null if there is no free place
    bool needsLeader = false; ///< far enough from its anchor to need a leader line
};

/** A text to be placed beside the object it names. */
struct LabelRequest
{
    LabelDisk anchor;
    QSizeF size_px;
    /** Place in the previous frame, moved with the anchor; kept unless another is clearly better.
     */
    std::optional<PlacedLabel> previous;
};

/** Obstacles for labels. */
struct LabelSurroundings
{
    QRectF area;                  ///< labels stay inside
    std::vector<QRectF> solids;   ///< overlays, which are never covered
    std::vector<LabelDisk> disks; ///< symbols, which are never covered
    std::vector<QLineF> lines;    ///< legs and arrows, which are covered only as a last resort
};

/**
 * Places labels, in the order of the requests: each at the nearest place that touches no other
 * label, disk or overlay, and if possible no line. A label without a free place gets a null
 * rectangle. Method: greedy with repair sweeps over rings of candidate places; deterministic.
 * Cost: about requests x 80 x objects within 160 px.
 */
[[nodiscard]] std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests,
                                                   const LabelSurroundings& surroundings);

/** Returns the rectangle of the previous frame, which must exist, for a text that may have grown;
 * the side at the anchor stays. */
[[nodiscard]] QRectF stayingRect(const LabelRequest& request);

/** Returns true if the disk and the rectangle have a point in common. */
[[nodiscard]] bool overlaps(const QRectF& rect, const LabelDisk& disk);

/** Returns the length of the part of `line` inside `rect`. */
[[nodiscard]] double lengthInside(const QRectF& rect, const QLineF& line);

} // namespace berg
