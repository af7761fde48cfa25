#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

#include <QColor>
#include <QImage>

#include <span>

namespace berg {

/** View and colour of the image of the water seen. */
struct SweptStyle
{
    MapViewTransform view;
    QRectF rect;      ///< map rectangle
    double ratio = 1; ///< device pixels per unit of `rect`
    QColor tint;      ///< translucent colour of the water seen
    bool operator==(const SweptStyle&) const = default;
};

/** Poses of a UAV in time order (borrowed), and its sensor. */
struct SweptTrail
{
    std::span<const MapPose> poses;
    SensorSpec sensor;
};

/**
 * Image of the water that the fields of view have passed over, in one tint without overlaps,
 * accurate to about a pixel. Between two poses a UAV is assumed to turn evenly. While the view
 * stays and the flight continues, only new poses are painted.
 */
class SweptMask
{
public:
    /**
     * Completes the image for these trails and returns it; draw it at the top left of the map.
     * After a change of view it takes about a microsecond per pose in sight.
     */
    [[nodiscard]] const QImage& updated(const std::vector<SweptTrail>& trails,
                                        const SweptStyle& style);

    /** Paints for about `budget_ms` at most; returns false if there is more to paint. */
    bool advance(const std::vector<SweptTrail>& trails, const SweptStyle& style, double budget_ms);
    /** Returns the image painted so far; draw it at the top left of the map. */
    [[nodiscard]] const QImage& image() const { return m_image; }
    [[nodiscard]] const SweptStyle& style() const { return m_style; }
    /** Returns true if something is painted and all of it belongs to these trails. */
    [[nodiscard]] bool isOf(const std::vector<SweptTrail>& trails) const;

private:
    /** Pixels of one row that are known to be painted; empty if `last` < `first`. */
    struct PaintedRun
    {
        int first = 0;
        int last = -1;
    };
    /** Painted part of a trail. */
    struct Progress
    {
        SensorSpec sensor;
        std::size_t count = 0; ///< number of painted poses that will not change
        MapPose anchor;        ///< last of these poses
        double until_s = 0;    ///< time of the last painted pose

        [[nodiscard]] bool isOf(const SweptTrail& trail) const;
    };
    class Brush;

    void restart(const std::vector<SweptTrail>& trails, const SweptStyle& style);
    bool advance(const SweptTrail& trail, Progress& progress, double budget_ms);

    SweptStyle m_style;
    QImage m_image;
    std::vector<PaintedRun> m_rows;
    std::vector<Progress> m_progress; ///< by trail
};

} // namespace berg
