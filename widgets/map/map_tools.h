#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/edit_gesture.h"

#include <QCursor>
#include <QPainter>

#include <memory>
#include <optional>
#include <span>

class QKeyEvent;

namespace berg {

class MapScene;
class MapView;
class Selection;

/** What the left button does on the map. */
enum class MapToolKind
{
    Select,  ///< select, move
    Iceberg, ///< add an iceberg, set its drift
    Uav,     ///< place the UAV, set its heading
    Pan
};

/** Where the pointer is. */
struct MapPointer
{
    QPointF at_px;
    Point at_m = Point::Zero();
    Qt::KeyboardModifiers modifiers;
    bool isInside = true; ///< of the map's widget
};

/** What a tool works on; all outlive it. */
struct MapToolContext
{
    ScenarioDocument& document;
    Selection& selection;
    MapScene& scene;
    MapView& view;
};

/**
 * Meaning of the left button from press to release. A tool holds what is under way and nothing
 * else; it edits through an `EditGesture`, which makes each drag one undo step.
 */
class MapTool
{
public:
    explicit MapTool(const MapToolContext& context) : m_context(context) {}
    virtual ~MapTool() = default;
    MapTool(const MapTool&) = delete;
    MapTool& operator=(const MapTool&) = delete;

    virtual void press(const MapPointer& pointer) = 0;
    /** With the button down. */
    virtual void move(const MapPointer& pointer) = 0;
    /** Outside the widget: as `cancel` for everything that edits. */
    virtual void release(const MapPointer& pointer) = 0;
    /** A key that the map has no meaning for itself; true when the tool has one. */
    virtual bool key(const QKeyEvent& event);

    /** Between press and release. */
    [[nodiscard]] virtual bool isBusy() const = 0;
    /** Takes back what is under way. */
    virtual void cancel() = 0;
    /** The scenario has changed: when not by this tool, what is under way is dropped as it is. */
    virtual void documentChanged() = 0;

    /** Marks above the picture, device-independent pixels. */
    virtual void paint(QPainter& painter) const;
    /** Cursor above the object of this key; empty: above water. */
    [[nodiscard]] virtual QCursor cursor(const std::string& over) const = 0;
    /** What the tool expects, one sentence for the status bar. */
    [[nodiscard]] virtual QString status() const = 0;

protected:
    [[nodiscard]] const MapToolContext& context() const { return m_context; }
    [[nodiscard]] std::unique_ptr<EditGesture> newGesture(const QString& text) const;

private:
    MapToolContext m_context;
};

[[nodiscard]] std::unique_ptr<MapTool> makeMapTool(MapToolKind kind, const MapToolContext& context);

/** Name of the undo step that moves these objects. */
[[nodiscard]] QString moveText(const Scenario& scenario, std::span<const std::string> ids);

/** True when the pointer has gone far enough from the press to mean a drag. */
[[nodiscard]] bool isDragDistance(const QPointF& from, const QPointF& to);

/** Direction of a way as navigators write it: "045°", clockwise from north. */
[[nodiscard]] QString bearingText(const Point& way_m);

} // namespace berg
