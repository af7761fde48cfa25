#pragma once

#include "widgets/map/view/map_handles.h"
#include "widgets/map/view/map_tools.h"

namespace berg {

/**
 * Click selects, Ctrl or Shift toggles. Dragging an object moves the selection, dragging on water
 * selects a box, dragging a handle changes drift, heading or outline of the selection. While the
 * map is locked, the tool selects but changes nothing except wind and asset if allowed.
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
        Handle,   ///< pressed on a handle, not yet moved
        Dragging, ///< dragging a handle
        Refused   ///< a drag that would move something while the map is locked
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
    std::string m_object;              ///< object under the press
    bool m_wasSelected = false;        ///< before the press
    std::vector<std::string> m_before; ///< selected before the press
    std::vector<std::string> m_moved;  ///< moved by the present drag
    std::unique_ptr<EditGesture> m_gesture;
    std::optional<MapHandle> m_handle; ///< pressed, or under the cursor
    std::optional<MapHandle> m_corner; ///< current corner of an area, which Del removes
    std::unique_ptr<HandleDrag> m_drag;
};

} // namespace berg
