#pragma once

#include "widgets/map/view/map_tools.h"
#include "widgets/theme/theme.h"

#include <optional>
#include <vector>

namespace berg {

/** What is changed by dragging a handle. */
enum class HandleKind
{
    Drift,   ///< velocity of an iceberg, at the tip of its arrow
    Heading, ///< of the UAV
    Corner,  ///< of an area
    Edge,    ///< middle of an edge of an area: a new corner
    Wind,    ///< tip of the arrow in its panel
    Asset    ///< in flight: the asset itself
};

/** A small mark to be dragged, beside what it belongs to. */
struct MapHandle
{
    HandleKind kind = HandleKind::Drift;
    std::string id;        ///< of the iceberg or UAV; the key of the area
    std::size_t index = 0; ///< of the corner, or of the one the edge begins at
    int uav = 0;           ///< `MapUav::place`
    QPointF at_px;

    /** The same handle, wherever it is now. */
    [[nodiscard]] bool isSame(const MapHandle& other) const
    {
        return kind == other.kind && id == other.id && index == other.index;
    }
};

/** None: the panel of the wind has no room. */
[[nodiscard]] std::optional<MapHandle> windHandle(MapScene& scene);
/** Handles of what is selected; those under a panel of the map are left out. */
[[nodiscard]] std::vector<MapHandle> handlesOf(MapScene& scene, const Selection& selection);
/** Corners and middles of edges of the area of this key; edges too short for a handle have none. */
[[nodiscard]] std::vector<MapHandle> areaHandles(MapScene& scene, const std::string& key);

/** The nearest one in reach; corners come before edges. */
[[nodiscard]] std::optional<MapHandle> handleAt(const std::vector<MapHandle>& handles,
                                                const QPointF& at);

/** Which handles stand out. */
struct HandleMarks
{
    std::optional<MapHandle> hovered;
    std::optional<MapHandle> corner; ///< current one: what Del removes
};
void paintHandles(QPainter& painter, const std::vector<MapHandle>& handles,
                  const HandleMarks& marks, const Theme& theme);

/**
 * One drag of a handle: one undo step, taken back by `end(false)`. In flight, where it is one of
 * those that can be dragged then, a draft of the picture and at the end what the map emits.
 */
class HandleDrag
{
public:
    explicit HandleDrag(const MapToolContext& context) : m_context(context) {}
    virtual ~HandleDrag() = default;
    HandleDrag(const HandleDrag&) = delete;
    HandleDrag& operator=(const HandleDrag&) = delete;

    virtual void move(const MapPointer& pointer) = 0;
    /** Live values, beside the cursor; empty: they are elsewhere. */
    [[nodiscard]] virtual QString text() const = 0;
    /** For the status bar. */
    [[nodiscard]] virtual QString status() const = 0;

    virtual void end(bool keep);
    [[nodiscard]] bool isApplying() const { return m_gesture && m_gesture->isApplying(); }

protected:
    [[nodiscard]] const MapToolContext& context() const { return m_context; }
    [[nodiscard]] EditGesture& gesture() { return *m_gesture; }
    /** There is no gesture. */
    [[nodiscard]] bool isInFlight() const { return m_gesture == nullptr; }
    void begin(const QString& undoText) { m_gesture = makeGesture(m_context, undoText); }

private:
    MapToolContext m_context;
    std::unique_ptr<EditGesture> m_gesture;
};

/** The drag of this handle; of a drift handle all icebergs selected get the same drift. */
[[nodiscard]] std::unique_ptr<HandleDrag> makeHandleDrag(const MapToolContext& context,
                                                         const MapHandle& handle);

/** What dragging would do, for the status bar. */
[[nodiscard]] QString handleText(const MapToolContext& context, const MapHandle& handle);

/** Removes a corner of the area; says why not when the rest would be no area. */
void removeCorner(const MapToolContext& context, const MapHandle& corner);
/** Whether the corner is there still. */
[[nodiscard]] bool hasCorner(const MapToolContext& context, const MapHandle& corner);

/** The sentence for an outline that would cross itself. */
[[nodiscard]] QString crossingText();

} // namespace berg
