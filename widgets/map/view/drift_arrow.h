#pragma once

#include "widgets/map/paint/map_marks.h"
#include "widgets/map/view/map_tools.h"

#include <QPointF>

#include <optional>
#include <string>

namespace berg {

/**
 * A drift arrow that is being drawn by hand: while it lives the arrows of the map stand for one
 * time, so that the tip stays under the cursor.
 */
class DriftArrow
{
public:
    /** `grabbed`: key of the iceberg whose arrow is taken at its tip; empty: a new one is drawn. */
    explicit DriftArrow(MapScene& scene, const std::string& grabbed = {});
    ~DriftArrow();
    DriftArrow(const DriftArrow&) = delete;
    DriftArrow& operator=(const DriftArrow&) = delete;

    /**
     * Own drift of the iceberg when the tip of its arrow, which shows drift over ground, is at the
     * pointer; none inside its symbol. Within the limits of a scenario; Shift keeps to steps of
     * direction.
     */
    [[nodiscard]] Point velocity_mps(const Iceberg& iceberg, const MapPointer& tip,
                                     const Point& current_mps) const;

    /** What the arrow means, for the status bar. */
    [[nodiscard]] QString status() const;

private:
    MapScene& m_scene;
    double m_time_s;
    QPointF m_grip_px; ///< from the tip to the pointer: the arrow taken stood for a longer time
};

/** "0.31 m/s  045°". */
[[nodiscard]] QString driftText(const Point& drift_mps, const QLocale& locale);

/** Whole degrees from a place to the pointer, in steps with Shift; none: it is there. */
[[nodiscard]] std::optional<double> headingTowards_deg(const Point& from_m,
                                                       const MapPointer& pointer);
/** "Heading 045°". */
[[nodiscard]] QString headingText(double heading_deg);

/** "1.20 km  045°". */
[[nodiscard]] QString pathText(const Point& path_m, const QLocale& locale);

} // namespace berg
