#pragma once

#include "widgets/map/view/map_tools.h"

#include <QCoreApplication>

namespace berg {

/**
 * Edits of the scenario from menus and keys rather than tools. An edit first cancels the tool's
 * gesture. While the map is locked it does not change the document; `deleteSelected` and
 * `addIcebergAt` then emit a request instead. `MapView::refused` reports why an edit was not
 * possible.
 */
class MapEdits
{
    Q_DECLARE_TR_FUNCTIONS(MapEdits)

public:
    /** The context must outlive this object. */
    explicit MapEdits(const MapToolContext& context) : m_context(context) {}

    /** Deletes the tool's current part if there is one, otherwise the selection (but never the last
     * UAV). In flight it emits `MapView::removalRequested` instead. */
    void deleteSelected();
    /** Selects all icebergs. */
    void selectAll();
    /** Moves the selection, metres east and north; consecutive calls are one undo step. */
    void nudge(double east_m, double north_m);

    /** Copies the selected icebergs to the clipboard; returns false if there are none. */
    bool copySelected() const;
    /** Copies the selected icebergs to the clipboard and deletes them. */
    void cutSelected();
    /** Pastes icebergs around the cursor, or beside the originals if it is not over the map. */
    void paste();
    /** Pastes icebergs around `place_m`; nullopt places them beside the originals. */
    void pasteAt(const std::optional<Point>& place_m);
    /** Duplicates the selected icebergs, or the selected UAVs if no iceberg is selected. */
    void duplicateSelected();
    /** Adds an iceberg unless the scenario is full; in flight it emits `MapView::icebergPlaced`
     * instead. */
    void addIcebergAt(const Point& place_m);
    /** Adds a copy of the first UAV in an altitude layer of its own, at `place_m` or at a free
     * place beside it. */
    void addUavAt(const Point& place_m);
    /** Adds a UAV at the cursor, or in the middle of the map. */
    void addUav();

private:
    bool begin();
    [[nodiscard]] QString removalText(const std::vector<std::string>& ids) const;
    void addCopiesOf(const std::vector<Iceberg>& icebergs, const std::optional<Point>& place_m,
                     const QString& undoText);
    void duplicateUavs(const std::vector<Uav>& uavs);
    [[nodiscard]] bool hasRoomForIcebergs(std::size_t count);
    [[nodiscard]] bool hasRoomForUavs(std::size_t count);
    [[nodiscard]] Point copyStep_m() const;

    MapToolContext m_context;
};

} // namespace berg
