#pragma once

#include "core/earth/geodesy.h"
#include "widgets/map/view/map_tools.h"

#include <optional>

namespace berg {

/** A measured leg on WGS 84. */
struct MeasuredLeg
{
    double length_m = 0;    ///< length of the geodesic
    double bearing_deg = 0; ///< true bearing at the start of the leg, in [0, 360)
    /** Flight time along a straight path; nullopt if it cannot be flown or has no length. */
    std::optional<double> time_s;
};

/** Measures the leg between two points of the local plane; its time is that of the first UAV in
 * this wind. */
[[nodiscard]] MeasuredLeg measureLeg(const Scenario& scenario, const Point& wind_mps,
                                     const Point& from_m, const Point& to_m);

/**
 * Measures a line: each click adds a point; legs show length and bearing, the end shows the sum and
 * the flight time. It changes nothing, so it works in flight, too.
 */
class MeasureTool final : public MapTool
{
public:
    using MapTool::MapTool;

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    bool hover(const MapPointer& pointer) override;
    [[nodiscard]] bool isBusy() const override { return m_isPressed; }
    void cancel() override { drop(); }
    [[nodiscard]] bool isDrawing() const override { return m_isOpen; }
    void finishDrawing() override;
    void undoLastPoint() override;
    bool cancelDrawing() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QCursor cursor(const std::string& over) const override;
    [[nodiscard]] QString status() const override;

protected:
    void drop() override { m_isPressed = false; }

private:
    [[nodiscard]] std::vector<Point> line() const;
    [[nodiscard]] QString totalText(const std::vector<MeasuredLeg>& legs) const;
    void paintLeg(QPainter& painter, const Point& from_m, const Point& to_m, const MeasuredLeg& leg,
                  bool isLast) const;

    std::vector<Point> m_points_m;
    bool m_isOpen = false; ///< clicks extend the line; otherwise the next click starts another
    bool m_isPressed = false;
    bool m_isHovering = false;
    MapPointer m_now;
};

} // namespace berg
