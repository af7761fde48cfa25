#pragma once

#include "widgets/map/view/map_handles.h"
#include "widgets/map/view/map_tools.h"

namespace berg {

/**
 * Draws an area corner by corner; a click on the first one, Enter, a double click or the right
 * button closes it. The area then takes the place of the one there was, a no-fly area is one more.
 * Corners and middles of edges of the present ones can be dragged.
 */
class AreaTool final : public MapTool
{
public:
    /** `kind`: Area or NoFly. */
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
    void takeLastBack() override;
    bool dropDrawing() override;
    bool removePart() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QCursor cursor(const std::string& over) const override;
    [[nodiscard]] QString status() const override;

protected:
    [[nodiscard]] bool isApplying() const override { return m_drag && m_drag->isApplying(); }
    void drop() override;
    void checkPart() override;

private:
    /** Why the last corner or the closing edge was not taken. */
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

    /** Of the area, or of all no-fly areas. */
    [[nodiscard]] std::vector<MapHandle> handles() const;
    /** Whether the key is that of one that the tool draws. */
    [[nodiscard]] bool isOwn(const std::string& key) const;

    bool m_isNoFly;
    std::vector<Point> m_corners_m; ///< half drawn
    MapPointer m_now;
    bool m_isHovering = false; ///< `m_now` is where the next corner would be
    Fault m_fault = Fault::None;

    bool m_isPressed = false;
    MapPointer m_press;
    std::optional<MapHandle> m_handle; ///< pressed on, or under the cursor
    std::optional<MapHandle> m_corner;
    std::unique_ptr<HandleDrag> m_drag;
};

} // namespace berg
