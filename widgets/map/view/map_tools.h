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

/** Function of the left mouse button on the map. */
enum class MapToolKind
{
    Select,  ///< select and move objects
    Iceberg, ///< add an iceberg, set its drift
    Uav,     ///< place the UAV, set its heading
    Asset,   ///< place the protected asset
    Area,    ///< draw the area, move its corners
    NoFly,   ///< draw no-fly areas, move their corners
    Measure, ///< distances, bearings and times of flight; changes nothing
    Pan
};

/** Returns true if the tool changes the scenario; such tools are left at take-off. */
[[nodiscard]] bool isEditing(MapToolKind kind);
/** Returns true if the tool is unavailable in flight. */
[[nodiscard]] bool isLockedInFlight(MapToolKind kind);

/** State of the pointer. */
struct MapPointer
{
    QPointF at_px;
    Point at_m = Point::Zero();
    Qt::KeyboardModifiers modifiers;
    bool isInside = true; ///< inside the map's widget
};

/** Objects that a tool works on; all outlive it. */
struct MapToolContext
{
    ScenarioDocument& document;
    Selection& selection;
    MapScene& scene;
    MapView& view;
};

/** Starts an edit gesture that previews on the map; `text` names its undo step. */
[[nodiscard]] std::unique_ptr<EditGesture> makeGesture(const MapToolContext& context,
                                                       const QString& text);

/**
 * Function of the left button from press to release. A tool has no state but its gesture; it edits
 * through an `EditGesture`, which makes each drag one undo step.
 */
class MapTool
{
public:
    explicit MapTool(const MapToolContext& context) : m_context(context) {}
    virtual ~MapTool() = default;
    MapTool(const MapTool&) = delete;
    MapTool& operator=(const MapTool&) = delete;

    /** The left button was pressed on the map. */
    virtual void press(const MapPointer& pointer) = 0;
    /** The pointer moved with the button down. */
    virtual void move(const MapPointer& pointer) = 0;
    /** The button was released; outside the widget this cancels edits. */
    virtual void release(const MapPointer& pointer) = 0;
    /** The pointer moved without button; returns true if the tool needs a repaint. */
    virtual bool hover(const MapPointer& /*pointer*/) { return false; }
    /** Handles a key that the map itself does not use; returns true if the tool used it. */
    virtual bool key(const QKeyEvent& /*event*/) { return false; }

    /** Returns true between press and release. */
    [[nodiscard]] virtual bool isBusy() const = 0;
    /** Cancels the action between press and release. */
    virtual void cancel() = 0;
    /**
     * The scenario has changed. A pressed action belongs to the old scenario: unless the tool made
     * the change, it ends with what it has done so far.
     */
    void documentChanged();
    /** Another scenario was loaded: drops all state. */
    void documentReplaced();

    // Tools that draw point by point have an unfinished drawing between presses.

    /** Returns true if a drawing is unfinished; the functions below then act on it. */
    [[nodiscard]] virtual bool isDrawing() const { return false; }
    /** Finishes the drawing (Enter, double click or right button), or leaves it open if it is not
     * valid. */
    virtual void finishDrawing() {}
    /** Removes the last point (Backspace or undo). */
    virtual void undoLastPoint() {}
    /** Cancels the drawing (Esc); returns false if there is none. */
    virtual bool cancelDrawing() { return false; }
    /** Removes the current part of an object, for example a corner (Del). Returns false if there is
     * none. */
    virtual bool removePart() { return false; }

    /** Paints marks above the picture, device-independent pixels. */
    virtual void paint(QPainter& /*painter*/) const {}
    /** Returns the cursor above the object with this key; an empty key means water. */
    [[nodiscard]] virtual QCursor cursor(const std::string& over) const = 0;
    /** Returns a text for the status bar that explains the next step. */
    [[nodiscard]] virtual QString status() const = 0;

protected:
    [[nodiscard]] const MapToolContext& context() const { return m_context; }
    /** Returns true if the present document change is made by this tool's gesture. */
    [[nodiscard]] virtual bool isApplying() const { return false; }
    /** Ends a pressed action without an edit. */
    virtual void drop() = 0;
    /** Drops the current part if it no longer exists. */
    virtual void checkPart() {}

private:
    MapToolContext m_context;
};

/** Creates the tool of this kind. */
[[nodiscard]] std::unique_ptr<MapTool> makeMapTool(MapToolKind kind, const MapToolContext& context);

/** Returns the name of the undo step that moves these objects. */
[[nodiscard]] QString moveText(const Scenario& scenario, std::span<const std::string> ids);

/** Returns true if the pointer has moved far enough from the press to start a drag. */
[[nodiscard]] bool isDragDistance(const QPointF& from, const QPointF& to);

// Positions set by hand are rounded, far below screen resolution, so that numbers stay short.
inline constexpr double kPositionStep_m = 0.1;

/** Returns the position of an object placed at the pointer: rounded and within the limits of a
 * scenario. */
[[nodiscard]] Point placeOf(const MapPointer& pointer);
/** Returns a pointer in the middle of the map, for placing by keyboard. */
[[nodiscard]] MapPointer middleOf(const MapScene& scene);
/** Returns true if the key is Return or Enter. */
[[nodiscard]] bool isEnter(const QKeyEvent& event);

} // namespace berg
