#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/map/view/map_camera.h"
#include "widgets/map/view/map_edits.h"
#include "widgets/map/view/map_tools.h"

#include <QTimer>
#include <QWidget>

class QGestureEvent;
class QHelpEvent;
class QNativeGestureEvent;

namespace berg {

/**
 * Interactive map: shows a picture in a view that mouse, wheel, pinch and keys move, and edits the
 * scenario with tools. Unless locked, it takes what can be edited from the document, so that edits
 * are visible in the next frame; everything else comes from the picture. GUI thread.
 */
class MapView : public QWidget
{
    Q_OBJECT

public:
    /** Document and selection must outlive the view. */
    explicit MapView(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);

    /** Shows a picture; the first one of each scenario is fitted. */
    void setPicture(MapPicture picture);
    /** Shows aircraft and traffic of the live link over the picture. */
    void setLive(MapLive live)
    {
        m_scene.setLive(std::move(live));
        update();
    }
    [[nodiscard]] const MapLive& live() const { return m_scene.picture().live; }
    void setTheme(const Theme& theme);
    /** Locks the map in flight: no edits; the picture is shown as is; clicks still select. */
    void setLocked(bool locked);
    [[nodiscard]] bool isLocked() const { return m_isLocked; }
    /** Sets whether wind and asset can be dragged in flight. */
    void setMayIntervene(bool may);
    [[nodiscard]] bool mayIntervene() const { return m_mayIntervene; }
    /** Sets a change of the picture that shows a drag in flight; null removes it. */
    void setDraft(std::function<void(MapPicture&)> draft);

    /** Cancels the present action and changes the tool. Tools that are locked in flight
     * (`isLockedInFlight`) are ignored while the map is locked. */
    void setTool(MapToolKind kind);
    [[nodiscard]] MapToolKind tool() const { return m_toolKind; }

    /** Returns what moves and zooms the map. */
    [[nodiscard]] MapCamera& camera() { return m_camera; }
    /** Sets the height at the top covered by another widget; panels are placed below it. */
    void setCover(int cover_px);
    /** Shows a widget with its size hint below the north arrow if there is room; null for none. */
    void setInset(QWidget* inset);
    [[nodiscard]] bool hasInset() const { return m_inset != nullptr; }
    [[nodiscard]] const MapPanelStates& panels() const { return m_scene.panels(); }
    /** Sets the panels; emits nothing. */
    void setPanels(const MapPanelStates& panels);
    /** Sets the opacity of the layers, the backdrop and the drift horizon. */
    void setLayers(const MapLayers& layers);
    [[nodiscard]] const MapLayers& layers() const { return m_scene.layers(); }
    /** Folds a panel to its icon or opens it, as by mouse. */
    void foldPanel(MapPanel panel);
    /** Returns true if only the icon is shown: folded by the user, or for lack of room. */
    [[nodiscard]] bool isFolded(MapPanel panel) { return m_scene.isFolded(panel); }
    /** Returns the panel at a place of the screen, also if it is folded to its icon; nullopt if
     * there is none. */
    [[nodiscard]] std::optional<MapPanel> panelAt(const QPoint& globalPos);
    /** Selects the measuring tool and starts a measurement at this place, metres. */
    void measureFrom(const Point& from_m);
    /** Waits for the land of the last painted view: for image export. */
    void finishLand();

    [[nodiscard]] MapViewTransform view() const { return m_scene.view(); }
    [[nodiscard]] Point toWorld(const QPointF& p_px) const { return m_scene.view().toWorld(p_px); }
    [[nodiscard]] QPointF toScreen(const Point& p_m) const { return m_scene.view().toPixel(p_m); }

    /** Marks an object that a list or chart refers to; empty for none. */
    void setHighlight(const std::string& id);

    /** Shows this scenario instead of the document's; null ends the preview. */
    void setPreview(const Scenario* scenario);

    [[nodiscard]] QSize sizeHint() const override { return {900, 600}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }

    /** Returns the edits for menus and keys. */
    [[nodiscard]] MapEdits& edits() { return m_edits; }
    /** Returns the position of the cursor; nullopt if it is not over the map. */
    [[nodiscard]] std::optional<Point> cursor_m() const;
    /** Removes the tool's current part; returns false if there is none. */
    bool removePart();

    /** Returns true if a tool is drawing; undo then removes its last point only. */
    [[nodiscard]] bool isDrawing() const;

public slots:
    /** Cancels the action between press and release. */
    void cancelGesture();
    /** Removes the last point of the drawing. */
    void undoLastPoint();

signals:
    /** A panel was folded, unfolded or moved by mouse. */
    void panelsChanged();
    /** A request was rejected; `text` gives the reason. */
    void refused(const QString& text);
    void cursorMoved(const berg::Point& position_m);
    void cursorLeft();
    void toolChanged(berg::MapToolKind kind);
    /** The status bar text of the tool has changed. */
    void statusText(const QString& text);
    /** Another object is under the cursor; empty for none. */
    void hovered(const std::string& id);
    void editRequested(const std::string& id);

    // Requests for a flight in progress, effective at once.
    void windEdited(const berg::Point& wind_mps);
    void assetMoved(const berg::Point& position_m);
    /** An iceberg without id was placed in flight. */
    void icebergPlaced(const berg::Iceberg& iceberg);
    /** Removal of the icebergs among `ids` was requested in flight. */
    void removalRequested(const std::vector<std::string>& ids);

    /** A menu was requested at objects, the first of which is selected; empty on water. */
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
    void placeInset();
    /** Handles a press on a part of a panel; returns false if there is none. */
    bool pressPanel(const QPointF& at);
    void movePanel(const QPointF& at);
    void releasePanel();
    void endNudges();
    void updateToolState();
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
    MapCamera m_camera;
    MapEdits m_edits;
    MapPicture m_picture; ///< as set by the owner
    std::optional<Scenario> m_preview;
    std::function<void(MapPicture&)> m_draft; ///< null without a draft
    MapToolKind m_toolKind = MapToolKind::Select;
    std::unique_ptr<MapTool> m_tool;

    bool m_isLocked = false;
    bool m_mayIntervene = false;   ///< while locked
    bool m_fitsNextPicture = true; ///< next picture is the first of a scenario
    bool m_hasKeyboardFocus = false;
    std::optional<QPointF> m_cursor;  ///< nullopt if not over the map
    std::optional<QPointF> m_panFrom; ///< last position of a drag with the middle button
    std::optional<MapPanel> m_movedPanel;
    QPointF m_panelFrom;         ///< cursor position minus the panel's offset
    bool m_pressedPanel = false; ///< the last press was on a panel
    std::string m_hovered;
    std::string m_highlighted;
    QString m_status;
    QTimer m_settleTimer;
    QWidget* m_inset = nullptr; ///< null if not shown
};

} // namespace berg
