#pragma once

#include "core/scenario/scenario.h"
#include "widgets/map/view/edit_gesture.h"

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
    Asset,   ///< place what is to be protected
    Area,    ///< draw the area, move its corners
    NoFly,   ///< the same of no-fly areas
    Measure, ///< distances, bearings and times of flight; changes nothing
    Pan
};

/** True for tools that change the scenario: they are left at take-off. */
[[nodiscard]] bool isEditing(MapToolKind kind);
/** True for those of them that are not taken up in flight. */
[[nodiscard]] bool isLockedInFlight(MapToolKind kind);

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

[[nodiscard]] std::unique_ptr<EditGesture> makeGesture(const MapToolContext& context,
                                                       const QString& text);

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
    /** Without a button down; true when there is something to be painted anew. */
    virtual bool hover(const MapPointer& /*pointer*/) { return false; }
    /** A key that the map has no meaning for itself; true when the tool has one. */
    virtual bool key(const QKeyEvent& /*event*/) { return false; }

    /** Between press and release. */
    [[nodiscard]] virtual bool isBusy() const = 0;
    /** Takes back what is under way between press and release. */
    virtual void cancel() = 0;
    /**
     * The scenario has changed. What is pressed belongs to the one before: when the change is not
     * the tool's own, it ends as far as it got.
     */
    void documentChanged();
    /** Another scenario altogether: nothing is kept. */
    void documentReplaced();

    // Tools that draw point by point have something half drawn between presses.

    /** Half drawn: the calls below belong to the drawing and not to the scenario. */
    [[nodiscard]] virtual bool isDrawing() const { return false; }
    /** Enter, double click or right button. */
    virtual void finishDrawing() {}
    /** Backspace or undo: the last point. */
    virtual void takeLastBack() {}
    /** Esc: all that is drawn; false when there is nothing. */
    virtual bool dropDrawing() { return false; }
    /** Del: a part of an object that is current, e.g. a corner; false when there is none. */
    virtual bool removePart() { return false; }

    /** Marks above the picture, device-independent pixels. */
    virtual void paint(QPainter& /*painter*/) const {}
    /** Cursor above the object of this key; empty: above water. */
    [[nodiscard]] virtual QCursor cursor(const std::string& over) const = 0;
    /** What the tool expects, one sentence for the status bar. */
    [[nodiscard]] virtual QString status() const = 0;

protected:
    [[nodiscard]] const MapToolContext& context() const { return m_context; }
    /** The change that is being told is an edit of this tool's gesture. */
    [[nodiscard]] virtual bool isApplying() const { return false; }
    /** Ends what is pressed without an edit. */
    virtual void drop() = 0;
    /** The part that is current may be gone. */
    virtual void checkPart() {}

private:
    MapToolContext m_context;
};

[[nodiscard]] std::unique_ptr<MapTool> makeMapTool(MapToolKind kind, const MapToolContext& context);

/** Name of the undo step that moves these objects. */
[[nodiscard]] QString moveText(const Scenario& scenario, std::span<const std::string> ids);

/** True when the pointer has gone far enough from the press to mean a drag. */
[[nodiscard]] bool isDragDistance(const QPointF& from, const QPointF& to);

// What is placed by hand is rounded far below what a screen shows, so that numbers stay short.
inline constexpr double kPositionStep_m = 0.1;

/** Where a thing put at the pointer is. */
[[nodiscard]] Point placeOf(const MapPointer& pointer);
/** The pointer of somebody who places things by keyboard. */
[[nodiscard]] MapPointer middleOf(const MapScene& scene);
[[nodiscard]] bool isEnter(const QKeyEvent& event);

} // namespace berg
