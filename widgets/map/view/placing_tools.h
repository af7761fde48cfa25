#pragma once

#include "widgets/map/view/drift_arrow.h"

namespace berg {

/** What places something where one clicks; Enter places it in the middle of the map. */
class PlacingTool : public MapTool
{
public:
    using MapTool::MapTool;

    bool key(const QKeyEvent& event) override;
    [[nodiscard]] bool isBusy() const override { return m_gesture != nullptr; }
    void cancel() override { end(true); }
    [[nodiscard]] QCursor cursor(const std::string& over) const override;

protected:
    [[nodiscard]] bool isApplying() const override { return m_gesture && m_gesture->isApplying(); }
    void drop() override { m_gesture.reset(); }
    /** Of what is pressed. */
    void end(bool takeBack);

    MapPointer m_press;
    MapPointer m_now;
    std::unique_ptr<EditGesture> m_gesture;
};

/**
 * A click adds an iceberg and selects it; dragging from it on sets its drift over ground by the
 * arrow of the map, whose tip follows the cursor. Dragging from an iceberg that is there sets the
 * drift of that one. In flight it adds icebergs only, which are told to the flight.
 */
class IcebergTool final : public PlacingTool
{
public:
    using PlacingTool::PlacingTool;

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    [[nodiscard]] bool isBusy() const override { return m_isPressed; }
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString status() const override;

protected:
    void drop() override;

private:
    /** Adds the iceberg unless it is there already, and sets its drift when one is drawn. */
    void apply();
    void beginDrift();
    void pressInFlight(const MapPointer& pointer, const std::string& object);

    bool m_isPressed = false;
    Iceberg m_iceberg;                   ///< as it was pressed on, or as it is to be added
    std::unique_ptr<DriftArrow> m_arrow; ///< while a drift is drawn
};

/**
 * A click places the UAV selected, else the first one, with Ctrl another one; dragging on turns it
 * towards the cursor. Dragging from a UAV turns that one where it is.
 */
class UavTool final : public PlacingTool
{
public:
    using PlacingTool::PlacingTool;

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QString status() const override;

protected:
    void drop() override;

private:
    [[nodiscard]] const Uav* meantUav() const;
    void apply();

    Uav m_uav; ///< as it is to be
    bool m_isTurning = false;
};

/**
 * A click places what is to be protected, or moves it here; it follows the cursor until the button
 * is let go.
 */
class AssetTool final : public PlacingTool
{
public:
    using PlacingTool::PlacingTool;

    void press(const MapPointer& pointer) override;
    void move(const MapPointer& pointer) override;
    void release(const MapPointer& pointer) override;
    void paint(QPainter& painter) const override;
    [[nodiscard]] QCursor cursor(const std::string& over) const override;
    [[nodiscard]] QString status() const override;

private:
    Point m_grip_m = Point::Zero(); ///< from its centre to where it was taken
    Asset m_asset;                  ///< as it is to be
    bool m_isMoving = false;        ///< not while a press on it may still be a click
};

} // namespace berg
