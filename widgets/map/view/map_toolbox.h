#pragma once

#include "widgets/map/view/map_tools.h"

#include <QObject>

namespace berg {

/** The present tool of the map, its cursor and its text for the status bar. GUI thread. */
class MapToolbox : public QObject
{
    Q_OBJECT

public:
    /** The context must outlive this object. */
    explicit MapToolbox(const MapToolContext& context);

    /** Cancels the present action and changes the tool. Tools that are locked in flight
     * (`isLockedInFlight`) are ignored while the map is locked. */
    void setKind(MapToolKind kind);
    [[nodiscard]] MapToolKind kind() const { return m_kind; }
    /** Returns the present tool; after a change of its state call `refresh`. */
    [[nodiscard]] MapTool& tool() { return *m_tool; }
    [[nodiscard]] const MapTool& tool() const { return *m_tool; }
    /** Returns true if a tool is drawing; undo then removes its last point only. */
    [[nodiscard]] bool isDrawing() const { return m_tool->isDrawing(); }

    /** Cancels the action between press and release. */
    void cancel();
    /** Handles Esc one step at a time: cancels the action or the drawing, then leaves the tool,
     * then clears the selection. */
    void leave();
    /** Removes the last point of the drawing. */
    void undoLastPoint();
    /** Removes the tool's current part; returns false if there is none. */
    bool removePart();
    /** Selects the measuring tool and starts a measurement at this place, metres. */
    void measureFrom(const Point& from_m);
    /** Ends the present undo step of nudges, unless the tool is within its own step. */
    void endNudges();

    /** Key of the object under the cursor; empty for none. */
    [[nodiscard]] const std::string& hovered() const { return m_hovered; }
    void setHovered(const std::string& id);
    /** Shows the tool's cursor and status, and repaints the map. */
    void refresh();

signals:
    void kindChanged(berg::MapToolKind kind);
    /** The status bar text of the tool has changed. */
    void statusText(const QString& text);
    /** Another object is under the cursor; empty for none. */
    void hoveredChanged(const std::string& id);

private:
    MapToolContext m_context;
    MapToolKind m_kind = MapToolKind::Select;
    std::unique_ptr<MapTool> m_tool;
    std::string m_hovered;
    QString m_status;
};

} // namespace berg
