#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"

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
    QColor tint;      ///< of the water seen, translucent
    bool operator==(const SweptLook&) const = default;
};

/** Where a UAV has been, in order of time, and what it sees from there. Borrowed poses. */
struct SweptTrail
{
    std::span<const MapPose> poses;
    SensorSpec sensor;
};

/**
 * The water that the fields of view have passed over, as an image in one tint without overlaps,
 * true to about a pixel. Between two poses a UAV is taken to turn evenly. While the look stays and
 * the flight goes on, only what is new is painted.
 */
class SweptMask
{
public:
    /**
     * The image for these trails, to be drawn at the top left of the map. Cost when the look has
     * changed: about a microsecond for each pose in sight.
     */
    [[nodiscard]] const QImage& updated(const std::vector<SweptTrail>& trails,
                                        const SweptLook& look);

    /** The same for at most about `budget_ms`; false: there is more to paint. */
    bool advance(const std::vector<SweptTrail>& trails, const SweptLook& look, double budget_ms);
    /** What is painted now, to be drawn at the top left of the map. */
    [[nodiscard]] const QImage& image() const { return m_image; }
    [[nodiscard]] const SweptLook& look() const { return m_look; }
    /** Something is painted, and all of it belongs to these trails. */
    [[nodiscard]] bool isOf(const std::vector<SweptTrail>& trails) const;

private:
    /** Pixels of one row that are known to be painted; empty: `last` before `first`. */
    struct PaintedRun
    {
        int first = 0;
        int last = -1;
    };
    /** How far a trail is painted. */
    struct Progress
    {
        SensorSpec sensor;
        std::size_t count = 0; ///< poses painted that stay
        MapPose anchor;        ///< the last of them
        double until_s = 0;    ///< time of the last pose painted

        [[nodiscard]] bool isOf(const SweptTrail& trail) const;
    };
    class Brush;

    void startAnew(const std::vector<SweptTrail>& trails, const SweptLook& look);
    bool advance(const SweptTrail& trail, Progress& progress, double budget_ms);

    SweptLook m_look;
    QImage m_image;
    std::vector<PaintedRun> m_rows;
    std::vector<Progress> m_progress; ///< by trail
};

} // namespace berg
