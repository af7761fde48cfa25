#pragma once

#include "widgets/map/map_picture.h"
#include "widgets/map/map_view_transform.h"

#include <QColor>
#include <QImage>

#include <span>

namespace berg {

/** How the water seen so far is to be shown. */
struct SweptLook
{
    MapViewTransform view;
    QRectF rect;      ///< of the map
    double ratio = 1; ///< device pixels for each unit of `rect`
    SensorSpec sensor;
    QColor tint; ///< of the water seen, translucent
    bool operator==(const SweptLook&) const = default;
};

/**
 * The water that a field of view has passed over, as an image in one tint without overlaps, true
 * to about a pixel. Between two poses the UAV is taken to turn evenly. While the look stays and
 * the flight goes on, only what is new is painted.
 */
class SweptMask
{
public:
    /**
     * The image for these poses, in order of time, to be drawn at the top left of the map. Cost
     * when the look has changed: about a microsecond for each pose in sight.
     */
    [[nodiscard]] const QImage& updated(std::span<const MapPose> poses, const SweptLook& look);

    /** The same for at most about `budget_ms`; false: there is more to paint. */
    bool advance(std::span<const MapPose> poses, const SweptLook& look, double budget_ms);
    /** What is painted now, to be drawn at the top left of the map. */
    [[nodiscard]] const QImage& image() const { return m_image; }
    [[nodiscard]] const SweptLook& look() const { return m_look; }
    /** Whether all that is painted belongs to these poses. */
    [[nodiscard]] bool isOf(std::span<const MapPose> poses) const;

private:
    /** Pixels of one row that are known to be painted; empty: `last` before `first`. */
    struct PaintedRun
    {
        int first = 0;
        int last = -1;
    };
    class Brush;

    void startAnew(const SweptLook& look);

    SweptLook m_look;
    QImage m_image;
    std::vector<PaintedRun> m_rows;
    std::size_t m_count = 0; ///< poses painted that stay
    MapPose m_anchor;        ///< the last of them
    double m_until_s = 0;    ///< time of the last pose painted
};

} // namespace berg
