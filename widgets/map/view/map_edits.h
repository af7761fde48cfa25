#pragma once

#include "widgets/map/view/map_tools.h"

#include <QCoreApplication>

namespace berg {

/**
 * What the map does to the scenario beside its tools: what menus and keys ask for. An edit ends
 * what a tool has under way, and is none while the map is locked. What cannot be done is said by
 * `MapView::refused`.
 */
class MapEdits
{
    Q_DECLARE_TR_FUNCTIONS(MapEdits)

public:
    /** All of it must outlive this. */
    explicit MapEdits(const MapToolContext& context) : m_context(context) {}

    /** What is selected, but the last UAV; or the part that a tool has current. */
    void deleteSelected();
    void selectAll();
    /** Moves the selection, metres east and north; calls that follow each other are one undo step.
     */
    void nudge(double east_m, double north_m);

    /** The icebergs selected onto the clipboard; false when there are none. */
    bool copySelected() const;
    void cutSelected();
    /** Icebergs of the clipboard round the cursor; beside where they were when it is elsewhere. */
    void paste();
    void pasteAt(const std::optional<Point>& place_m);
    /** Icebergs; when none is selected, UAVs. */
    void duplicateSelected();
    /** In flight it is told to the flight. */
    void addIcebergAt(const Point& place_m);
    /** One more, as the first, in an altitude layer of its own. */
    void addUavAt(const Point& place_m);
    /** Where the cursor is, else in the middle. */
    void addUav();

private:
    bool begin();
    [[nodiscard]] QString removalText(const std::vector<std::string>& ids) const;
    void addCopiesOf(const std::vector<Iceberg>& icebergs, const std::optional<Point>& place_m,
                     const QString& undoText);
    void duplicateUavs(const std::vector<Uav>& uavs);
    [[nodiscard]] bool hasRoomForUavs(std::size_t count);
    [[nodiscard]] Point copyStep_m() const;

    MapToolContext m_context;
};

} // namespace berg
