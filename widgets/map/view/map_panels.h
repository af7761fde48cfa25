#pragma once

#include "widgets/map/view/map_camera.h"

namespace berg {

/**
 * The panels over the map, such as the legend and the wind, as the user arranges them: each can be
 * folded to an icon and moved. A widget can be set in below them. GUI thread.
 */
class MapPanels : public QObject
{
    Q_OBJECT

public:
    /** Borrows all; `map` is the widget that shows the scene. */
    MapPanels(MapScene& scene, MapCamera& camera, QWidget& map);

    [[nodiscard]] const MapPanelStates& states() const { return m_scene.panels(); }
    /** Sets the panels; emits nothing. */
    void setStates(const MapPanelStates& states);
    /** Sets the height at the top covered by another widget; panels are placed below it. */
    void setCover(int cover_px);
    /** Shows a widget with its size hint below the north arrow if there is room; null for none. */
    void setInset(QWidget* inset);
    [[nodiscard]] bool hasInset() const { return m_inset != nullptr; }
    /** Places the inset where the present layout has room for it. */
    void placeInset();

    /** Returns the panel at a point of the map, also if it is folded to its icon; nullopt if there
     * is none. */
    [[nodiscard]] std::optional<MapPanel> at(const QPointF& at) { return m_scene.panelAt(at); }
    /** Returns true if only the icon is shown: folded by the user, or for lack of room. */
    [[nodiscard]] bool isFolded(MapPanel panel) { return m_scene.isFolded(panel); }
    /** Folds a panel to its icon or opens it, as by mouse. */
    void fold(MapPanel panel);

    /** Handles a press of the left button: folds a panel, opens it or starts to move it. Returns
     * false if no part of a panel is there. */
    bool press(const QPointF& at);
    [[nodiscard]] bool isMoving() const { return m_moved.has_value(); }
    void move(const QPointF& at);
    void release();

signals:
    /** A panel was folded, opened or moved by the user. */
    void changed();

private:
    MapScene& m_scene;
    MapCamera& m_camera;
    QWidget& m_map;
    QWidget* m_inset = nullptr; ///< null if not shown
    std::optional<MapPanel> m_moved;
    QPointF m_from; ///< cursor position minus the offset of the moved panel
};

} // namespace berg
