#pragma once

#include "widgets/map/view/drift_arrow.h"

namespace berg {

/** Base of tools that place an object at a click; Enter places it in the middle of the map. */
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
    /** Ends the pressed action; `takeBack` undoes its edit. */
    void end(bool takeBack);

    MapPointer m_press;
    MapPointer m_now;
    std::unique_ptr<EditGesture> m_gesture;
};

/**
 * A click adds an iceberg and selects it; dragging on sets its drift over ground by the map's drift
 * arrow, whose tip follows the cursor. Dragging from an existing iceberg sets its drift. In flight
 * it only adds icebergs, which the map emits.
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
    /** Adds the iceberg unless it exists already, and sets its drift if one is drawn. */
    void apply();
    void beginDrift();
    void pressInFlight(const MapPointer& pointer, const std::string& object);

    bool m_isPressed = false;
    Iceberg m_iceberg;                   ///< existing iceberg, or the one to add
    std::unique_ptr<DriftArrow> m_arrow; ///< while a drift is drawn
};

/**
 * A click places the selected UAV, otherwise the first one; Ctrl adds another. Dragging on turns it
 * towards the cursor. Dragging from a UAV only turns it.
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
    [[nodiscard]] const Uav* targetUav() const;
    void apply();

    Uav m_uav; ///< edited UAV
    bool m_isTurning = false;
};

/**
 * A click places the protected asset, or moves it to the click; it follows the cursor until
 * release.
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
    Point m_grip_m = Point::Zero(); ///< from the asset's centre to the grabbed point
    Asset m_asset;                  ///< edited asset
    bool m_isMoving = false;        ///< false while a press on the asset may still be a click
};

} // namespace berg
