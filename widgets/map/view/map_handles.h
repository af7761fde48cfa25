#pragma once

#include "widgets/map/view/map_tools.h"
#include "widgets/theme/theme.h"

#include <optional>
#include <vector>

namespace berg {

/** Property changed by dragging a handle. */
enum class HandleKind
{
    Drift,   ///< velocity of an iceberg, at the tip of its arrow
    Heading, ///< heading of a UAV
    Corner,  ///< corner of an area
    Edge,    ///< middle of an edge of an area: dragging adds a corner
    Wind,    ///< wind, at the tip of the arrow in its panel
    Asset    ///< position of the asset, in flight only
};

/** A small mark that can be dragged, beside its object. */
struct MapHandle
{
    HandleKind kind = HandleKind::Drift;
    std::string id;        ///< id of the iceberg or UAV, or key of the area
    std::size_t index = 0; ///< index of the corner, or of the edge's first corner
    int uav = 0;           ///< `MapUav::place`
    QPointF at_px;

    /** Returns true if both are the same handle, regardless of position. */
    [[nodiscard]] bool isSame(const MapHandle& other) const
    {
        return kind == other.kind && id == other.id && index == other.index;
    }
};

/** Returns the handle of the wind; nullopt if the wind panel is not shown, or a forecast decides.
 */
[[nodiscard]] std::optional<MapHandle> windHandle(MapScene& scene);
/** Returns the handles of the selected objects, except those under a panel or outside the map. */
[[nodiscard]] std::vector<MapHandle> handlesOf(MapScene& scene, const Selection& selection);
/** Returns the corners and edge middles of the area with this key, except those under a panel or
 * outside the map; short edges have no middle handle. */
[[nodiscard]] std::vector<MapHandle> areaHandles(MapScene& scene, const std::string& key);

/** Returns the nearest handle within reach of `at`; corners have a larger reach. Returns nullopt if
 * there is none. */
[[nodiscard]] std::optional<MapHandle> handleAt(const std::vector<MapHandle>& handles,
                                                const QPointF& at);

/** Highlighted handles. */
struct HandleMarks
{
    std::optional<MapHandle> hovered;
    std::optional<MapHandle> corner; ///< current corner, which Del removes
};
/** Paints the handles; hovered and current ones stand out. */
void paintHandles(QPainter& painter, const std::vector<MapHandle>& handles,
                  const HandleMarks& marks, const Theme& theme);

/**
 * A drag of a handle as one undo step, which `end(false)` cancels. In flight (wind and asset only)
 * it changes a draft of the picture and emits a signal of the map at the end.
 */
class HandleDrag
{
public:
    explicit HandleDrag(const MapToolContext& context) : m_context(context) {}
    virtual ~HandleDrag() = default;
    HandleDrag(const HandleDrag&) = delete;
    HandleDrag& operator=(const HandleDrag&) = delete;

    /** Applies the value at the pointer. */
    virtual void move(const MapPointer& pointer) = 0;
    /** Returns the live values to show beside the cursor; empty if they are shown elsewhere. */
    [[nodiscard]] virtual QString text() const = 0;
    /** Returns the text for the status bar. */
    [[nodiscard]] virtual QString status() const = 0;

    /** Ends the drag and keeps or cancels its change. */
    virtual void end(bool keep);
    /** Returns true while the drag changes the document. */
    [[nodiscard]] bool isApplying() const { return m_gesture && m_gesture->isApplying(); }

protected:
    [[nodiscard]] const MapToolContext& context() const { return m_context; }
    [[nodiscard]] EditGesture& gesture() { return *m_gesture; }
    /** Returns true if the drag runs in flight, where there is no gesture. */
    [[nodiscard]] bool isInFlight() const { return m_gesture == nullptr; }
    void begin(const QString& undoText) { m_gesture = makeGesture(m_context, undoText); }

private:
    MapToolContext m_context;
    std::unique_ptr<EditGesture> m_gesture;
};

/** Starts the drag of this handle, whose object must exist; a drift handle changes all selected
 * icebergs. */
[[nodiscard]] std::unique_ptr<HandleDrag> makeHandleDrag(const MapToolContext& context,
                                                         const MapHandle& handle);

/** Returns a text for the status bar that explains what dragging would do. */
[[nodiscard]] QString handleText(const MapToolContext& context, const MapHandle& handle);

/** Removes a corner of an existing area. If the rest would not be a valid area, it removes nothing
 * and emits `MapView::refused`. */
void removeCorner(const MapToolContext& context, const MapHandle& corner);
/** Returns true if the corner still exists. */
[[nodiscard]] bool hasCorner(const MapToolContext& context, const MapHandle& corner);

/** Returns the message for an outline that would cross itself. */
[[nodiscard]] QString crossingText();

} // namespace berg
