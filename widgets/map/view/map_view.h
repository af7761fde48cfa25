#pragma once

#include "widgets/map/view/map_edits.h"
#include "widgets/map/view/map_scene.h"
#include "widgets/map/view/map_tools.h"
#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"

#include <QTimer>
#include <QWidget>

class QGestureEvent;
class QHelpEvent;
class QNativeGestureEvent;

namespace berg {

/**
 * The map one works with: shows a picture in a view that mouse, wheel, pinch and keys move, and
 * edits the scenario with tools. While it is not locked it shows what can be edited as the document
 * has it, so that edits are seen in the next frame; everything else comes from the picture. GUI
 * thread.
 */
class MapView : public QWidget
{
    Q_OBJECT

public:
    /** Both must outlive the view. */
    explicit MapView(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);

    /** The first one, and the first one after another scenario was opened, is fitted. */
    void setPicture(MapPicture picture);
    void setTheme(const Theme& theme);
    /** In flight: the picture is shown as it is, tools that edit are left, a click still selects.
     */
    void setLocked(bool locked);
    [[nodiscard]] bool isLocked() const { return m_isLocked; }
    /** Whether the flight can be told now of what is dragged: wind and asset. */
    void setMayIntervene(bool may);
    [[nodiscard]] bool mayIntervene() const { return m_mayIntervene; }
    /** While locked: what is being done, as a change of the picture; null: nothing. */
    void setDraft(std::function<void(MapPicture&)> draft);

    /** Leaves what was under way. A tool that edits is not taken up while the map is locked. */
    void setTool(MapToolKind kind);
    [[nodiscard]] MapToolKind tool() const { return m_toolKind; }

    void fit();
    /** At the top something lies over the map: panels on it are below that. */
    void setCover(int cover_px);
    /** Shows a widget of its size hint below the north arrow, where there is room; null: none. */
    void setInset(QWidget* inset);
    [[nodiscard]] bool hasInset() const { return m_inset != nullptr; }
    [[nodiscard]] const MapPanelStates& panels() const { return m_scene.panels(); }
    /** As the user wants them; tells nobody. */
    void setPanels(const MapPanelStates& panels);
    /** How strongly its layers are painted. */
    void setLayers(const MapLayers& layers);
    [[nodiscard]] const MapLayers& layers() const { return m_scene.layers(); }
    /** To its icon or back, as by mouse. */
    void foldPanel(MapPanel panel);
    /** Only its icon is shown: the user has folded it, or there is no room. */
    [[nodiscard]] bool isFolded(MapPanel panel) { return m_scene.isFolded(panel); }
    /** The panel or icon at this place of the screen. */
    [[nodiscard]] std::optional<MapPanel> panelAt(const QPoint& globalPos);
    /** What is shown: corners, and points between them, all the way round. */
    [[nodiscard]] std::vector<LatLon> outline() const;
    /** With the tool for it, from this place. */
    void measureFrom(const Point& from_m);
    /** Shows this place in the middle, or the next one that a scenario can have something at. */
    void centreOn(const LatLon& place);
    /** Waits until all the land of the view last painted can be painted: for pictures. */
    void finishLand();
    void zoomBy(double factor, const QPointF& at);
    /** Brings this iceberg to the middle; nothing when it is not in the picture. */
    void showIceberg(const std::string& id);
    /** Shows all of these icebergs and UAVs and the asset, near; nothing when none is there. */
    void showObjects(const std::vector<std::string>& ids);
    /** Moves what is shown by `offset_px`. */
    void panBy(const QPointF& offset_px);
    /** Keeps the UAV in the middle part of the view until the map is moved by hand. */
    void setFollowUav(bool follow);
    [[nodiscard]] bool followsUav() const { return m_followsUav; }

    /** Place, scale and following of another map. */
    void showAs(const MapView& other);

    [[nodiscard]] MapViewTransform view() const { return m_scene.view(); }
    [[nodiscard]] Point toWorld(const QPointF& p_px) const { return m_scene.view().toWorld(p_px); }
    [[nodiscard]] QPointF toScreen(const Point& p_m) const { return m_scene.view().toPixel(p_m); }

    /** Marks an object that a list or chart points at; empty: none. */
    void setHighlight(const std::string& id);

    /** Shows this scenario in place of that of the document; null: the document's again. */
    void setPreview(const Scenario* scenario);

    [[nodiscard]] QSize sizeHint() const override { return {900, 600}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }

    /** What menus and keys ask for. */
    [[nodiscard]] MapEdits& edits() { return m_edits; }
    /** Of the cursor; none: not over the map. */
    [[nodiscard]] std::optional<Point> cursor_m() const;
    /** Removes the part that the tool has current, if it has one. */
    bool removePart();

    /** A tool is drawing: undo is to take back its last point and nothing else. */
    [[nodiscard]] bool isDrawing() const;

public slots:
    /** Takes back what is under way between press and release. */
    void cancelGesture();
    /** The last point of what is being drawn. */
    void takeLastBack();

signals:
    /** A panel was folded, unfolded or moved by mouse. */
    void panelsChanged();
    /** Another part of the Earth is shown. */
    void outlineChanged();
    /** Why something that was asked for was not done. */
    void refused(const QString& text);
    void cursorMoved(const berg::Point& position_m);
    void cursorLeft();
    void toolChanged(berg::MapToolKind kind);
    void followUavChanged(bool follows);
    /** What the tool expects now. */
    void statusText(const QString& text);
    /** The object under the cursor; empty: none. */
    void hovered(const std::string& id);
    void editRequested(const std::string& id);

    // What the user wants of a flight under way: from now on, here and now.
    void windEdited(const berg::Point& wind_mps);
    void assetMoved(const berg::Point& position_m);
    /** Without an id. */
    void icebergPlaced(const berg::Iceberg& iceberg);
    /** In flight: of icebergs among them. */
    void removalRequested(const std::vector<std::string>& ids);

    /** At objects, the first of which is selected then, or on water: none. */
    void contextMenuRequested(const QPoint& globalPos, const berg::Point& position_m,
                              const std::vector<std::string>& ids);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void scenarioChanged();
    void scenarioReplaced();
    void selectionChanged();
    void refreshPicture();
    void keepUavInSight();
    void setView(const MapViewTransform& view);
    void placeInset();
    /** A press on what folds or moves a panel. */
    bool pressPanel(const QPointF& at);
    void movePanel(const QPointF& at);
    void letPanelGo();
    [[nodiscard]] const MapUav* followedUav() const;
    void endNudges();
    void toolActed();
    void setHovered(const std::string& id);
    void updateHover();
    void requestContextMenu(const QPoint& globalPos, const QPointF& at);
    void pressArrow(const QKeyEvent& event);
    void leave();
    bool nativeGesture(const QNativeGestureEvent& event);
    bool gesture(QGestureEvent& event);
    bool showToolTip(const QHelpEvent& event);
    void updateTexts();
    void paintMarks(QPainter& painter);
    [[nodiscard]] MapPointer pointerOf(const QMouseEvent& event) const;

    ScenarioDocument& m_document;
    Selection& m_selection;
    MapScene m_scene;
    MapEdits m_edits;
    MapPicture m_picture; ///< as the owner gave it
    std::optional<Scenario> m_preview;
    std::function<void(MapPicture&)> m_draft; ///< null: none
    MapToolKind m_toolKind = MapToolKind::Select;
    std::unique_ptr<MapTool> m_tool;

    bool m_isLocked = false;
    bool m_mayIntervene = false;   ///< while locked
    bool m_isFitted = true;        ///< not moved since `fit`: a new size is fitted again
    bool m_fitsNextPicture = true; ///< the first one of a scenario
    bool m_followsUav = false;
    bool m_hasKeyboardFocus = false;
    std::optional<QPointF> m_cursor;  ///< none: not over the map
    std::optional<QPointF> m_panFrom; ///< of the middle button
    std::optional<MapPanel> m_movedPanel;
    QPointF m_panelFrom;         ///< cursor less what that panel is moved by
    bool m_pressedPanel = false; ///< by the last press
    std::string m_hovered;
    std::string m_highlighted;
    QString m_status;
    QTimer m_settleTimer;
    QWidget* m_inset = nullptr; ///< none: not shown
};

} // namespace berg
