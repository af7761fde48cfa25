#pragma once

#include "widgets/map/view/map_handles.h"
#include "widgets/map/view/map_tools.h"

namespace berg {

/**
 * Click selects, Ctrl or Shift toggles; a drag of an object moves the selection, a drag on water
 * selects what is inside the frame, a drag of a handle changes drift, heading or outline of what is
 * selected. When the map is locked it selects but does not change anything.
 */
class SelectTool final : public MapTool
{
public:
    using MapTool::MapTool;

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    bool hover(const MapPointer& pointer) override;
    bool key(const QKeyEvent& event) override;
    [[nodiscard]] bool isBusy() const override { return m_phase != Phase::Idle; }
    void cancel() override;
    bool removePart() override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QCursor cursor(const std::string& over) const override;
    [[nodiscard]] QString status() const override;

protected:
    [[nodiscard]] bool isApplying() const override;
    void drop() override;
    void checkPart() override;

private:
    enum class Phase
    {
        Idle,
        Object, ///< pressed on an object, not yet moved
        Water,
        Moving,
        Banding,
        Handle,   ///< pressed on one, not yet moved
        Dragging, ///< a handle
        Refused   ///< would move something, but the map is locked
    };

    void pressObject(const MapPointer& pointer);
    void beginDrag();
    void beginInFlight();
    void clickHandle(const MapPointer& pointer);
    void clickObject(bool adds);
    [[nodiscard]] std::vector<MapHandle> handles() const;
    void moveSelection(const MapPointer& pointer);
    void stretchBand(const MapPointer& pointer);

    Phase m_phase = Phase::Idle;
    MapPointer m_press;
    MapPointer m_now;
    std::string m_object;              ///< pressed on
    bool m_wasSelected = false;        ///< before the press
    std::vector<std::string> m_before; ///< selected before the press
    std::vector<std::string> m_moved;  ///< by the drag under way
    std::unique_ptr<EditGesture> m_gesture;
    std::optional<MapHandle> m_handle; ///< pressed on, or under the cursor
    std::optional<MapHandle> m_corner; ///< of an area: what Del removes
    std::unique_ptr<HandleDrag> m_drag;
};

} // namespace berg
