#pragma once

#include "widgets/map/paint/map_marks.h"
#include "widgets/map/view/map_tools.h"

#include <QPointF>

#include <optional>
#include <string>

namespace berg {

/**
 * A drift arrow being drawn by hand. While it exists, the horizon of the map's arrows is fixed, so
 * that the tip stays under the cursor.
 */
class DriftArrow
{
public:
    /** Starts drawing; `grabbed` is the key of an iceberg whose arrow was grabbed. */
    explicit DriftArrow(MapScene& scene, const std::optional<std::string>& grabbed = {});
    ~DriftArrow();
    DriftArrow(const DriftArrow&) = delete;
    DriftArrow& operator=(const DriftArrow&) = delete;

    /**
     * Returns the iceberg's own drift, relative to the current, for an arrow of drift over ground
     * with its tip at the pointer; zero inside the symbol. The drift is clamped to the limits of a
     * scenario and rounded to mm/s; Shift snaps the direction.
     */
    [[nodiscard]] Point velocity_mps(const Iceberg& iceberg, const MapPointer& tip,
                                     const Point& current_mps) const;

    /** Returns a text for the status bar that explains the arrow. */
    [[nodiscard]] QString status() const;

private:
    MapScene& m_scene;
    double m_time_s;
    QPointF m_grip_px; ///< from the tip to the pointer: the grabbed arrow had a longer horizon
};

/** Returns a drift as text, for example "0.31 m/s  045°"; without direction if it is zero. */
[[nodiscard]] QString driftText(const Point& drift_mps, const QLocale& locale);

/** Returns the heading from a place to the pointer in whole degrees, with Shift in larger steps.
 * Returns nullopt if the pointer is at the place. */
[[nodiscard]] std::optional<double> headingTowards_deg(const Point& from_m,
                                                       const MapPointer& pointer);
/** Returns a heading as text, for example "Heading 045°". */
[[nodiscard]] QString headingText(double heading_deg);

/** Returns length and bearing of a displacement as text, for example "1.20 km  045°". */
[[nodiscard]] QString pathText(const Point& path_m, const QLocale& locale);

} // namespace berg
