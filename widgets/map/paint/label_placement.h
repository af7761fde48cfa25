#pragma once

#include <QLineF>
#include <QRectF>

#include <optional>
#include <span>
#include <vector>

namespace berg {

/** A round thing on the map that labels must not cover. */
struct LabelDisk
{
    QPointF centre_px;
    double radius_px = 0;
};

/** Where a label went. */
struct PlacedLabel
{
    QRectF rect;        ///< null: there is no free place
    bool apart = false; ///< far enough from its anchor to need a leader line
};

/** A text to be placed beside the thing it names. */
struct LabelRequest
{
    LabelDisk anchor;
    QSizeF size_px;
    /** Where it was in the frame before, moved along with its anchor: left only for a gain. */
    std::optional<PlacedLabel> previous;
};

/** What labels have to keep clear of. */
struct LabelSurroundings
{
    QRectF area;                  ///< labels stay inside
    std::vector<QRectF> solids;   ///< overlays: never covered
    std::vector<LabelDisk> disks; ///< symbols: never covered
    std::vector<QLineF> lines;    ///< legs and arrows: covered only when there is no better place
};

/**
 * A place for each label, in the order of the requests: the nearest one that touches no other
 * label, disk or overlay, if possible no line. Greedy with repair sweeps over rings of candidate
 * places; deterministic. A label without a free place gets a null rectangle: better none than
 * two on top of each other.
 * Cost: about requests x 80 x things within 160 px.
 */
[[nodiscard]] std::vector<PlacedLabel> placeLabels(std::span<const LabelRequest> requests,
                                                   const LabelSurroundings& surroundings);

/** The place of the frame before for a text that may have grown: its side at the anchor stays. */
[[nodiscard]] QRectF stayingRect(const LabelRequest& request);

/** True when the disk and the rectangle have a point in common. */
[[nodiscard]] bool overlaps(const QRectF& rect, const LabelDisk& disk);

/** Length of the part of the line inside the rectangle. */
[[nodiscard]] double lengthInside(const QRectF& rect, const QLineF& line);

} // namespace berg
