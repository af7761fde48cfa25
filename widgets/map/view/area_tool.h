#pragma once

#include "widgets/map/view/map_handles.h"
#include "widgets/map/view/map_tools.h"

namespace berg {

/**
 * Draws an area corner by corner. Clicking the first corner, Enter, a double click or the right
 * button closes it: the new area replaces the monitored one, or is added as a no-fly area. With
 * fewer than three corners, or if the outline would cross itself, the drawing stays open and
 * `status` gives the reason. Corners and edge middles of existing areas can be dragged.
 */
class AreaTool final : public MapTool
{
public:
    /** Creates a tool of `kind` Area or NoFly. */
    AreaTool(const MapToolContext& context, MapToolKind kind)
        : MapTool(context), m_isNoFly(kind == MapToolKind::NoFly)
    {
    }

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    bool hover(const MapPointer& pointer) override;
    [[nodiscard]] bool isBusy() const override { return m_isPressed; }
    void cancel() override;
    [[nodiscard]] bool isDrawing() const override { return !m_corners_m.empty(); }
    void finishDrawing() override;
    void undoLastPoint() override;
    bool cancelDrawing() override;
    bool removePart() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QCursor cursor(const std::string& over) const override;
    [[nodiscard]] QString status() const override;

protected:
    [[nodiscard]] bool isApplying() const override { return m_drag && m_drag->isApplying(); }
    void drop() override;
    void checkPart() override;

private:
    /** Reason why the last corner or the closing edge was rejected. */
    enum class Fault
    {
        None,
        Crossing,
        TooFew,
        TooMany
    };

    void click(const MapPointer& pointer);
    void addCorner(const MapPointer& pointer);
    [[nodiscard]] bool closesAt(const QPointF& at_px) const;
    [[nodiscard]] QString faultText() const;
    void paintDrawing(QPainter& painter) const;
    void paintNextEdge(QPainter& painter, const QPolygonF& outline) const;

    /** Handles of the area, or of all no-fly areas. */
    [[nodiscard]] std::vector<MapHandle> handles() const;
    /** Returns whether `key` is that of an area of the tool's kind. */
    [[nodiscard]] bool isOwn(const std::string& key) const;

    bool m_isNoFly;
    std::vector<Point> m_corners_m; ///< corners drawn so far
    MapPointer m_now;
    bool m_isHovering = false; ///< `m_now` is the place of the next corner
    Fault m_fault = Fault::None;

    bool m_isPressed = false;
    MapPointer m_press;
    std::optional<MapHandle> m_handle; ///< pressed, or under the cursor
    std::optional<MapHandle> m_corner;
    std::unique_ptr<HandleDrag> m_drag;
};

} // namespace berg
