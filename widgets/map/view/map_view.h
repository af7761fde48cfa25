#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/map/view/map_camera.h"
#include "widgets/map/view/map_edits.h"
#include "widgets/map/view/map_panels.h"
#include "widgets/map/view/map_toolbox.h"

#include <QTimer>
#include <QWidget>

class QGestureEvent;
class QNativeGestureEvent;

namespace berg {

/**
 * Interactive map: shows a picture in a view that mouse, wheel, pinch and keys move, and edits the
 * scenario with tools. It makes no picture of the edited scenario: its owner sets one after each
 * edit. GUI thread.
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

    /** Returns what moves and zooms the map. */
    [[nodiscard]] MapCamera& camera() { return m_camera; }
    /** Returns the present tool. */
    [[nodiscard]] MapToolbox& tools() { return m_tools; }
    /** Returns the panels over the map. */
    [[nodiscard]] MapPanels& panels() { return m_panels; }
    /** Sets the opacity of the layers, the backdrop and the drift horizon. */
    void setLayers(const MapLayers& layers);
    [[nodiscard]] const MapLayers& layers() const { return m_scene.layers(); }
    /** Waits for the land of the last painted view: for image export. */
    void finishLand();

    [[nodiscard]] MapViewTransform view() const { return m_scene.view(); }
    [[nodiscard]] Point toWorld(const QPointF& p_px) const { return m_scene.view().toWorld(p_px); }
    [[nodiscard]] QPointF toScreen(const Point& p_m) const { return m_scene.view().toPixel(p_m); }

    /** Marks an object that a list or chart refers to; empty for none. */
    void setHighlight(const std::string& id);

    /** Shows this scenario over the picture unless locked; null ends the preview. */
    void setPreview(const Scenario* scenario);

    [[nodiscard]] QSize sizeHint() const override { return {900, 600}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }

    /** Returns the edits for menus and keys. */
    [[nodiscard]] MapEdits& edits() { return m_edits; }
    /** Returns the position of the cursor; nullopt if it is not over the map. */
    [[nodiscard]] std::optional<Point> cursor_m() const;

signals:
    /** A request was rejected; `text` gives the reason. */
    void refused(const QString& text);
    void cursorMoved(const berg::Point& position_m);
    void cursorLeft();
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
    void updateHover();
    void requestContextMenu(const QPoint& globalPos, const QPointF& at);
    void pressArrow(const QKeyEvent& event);
    bool nativeGesture(const QNativeGestureEvent& event);
    bool gesture(QGestureEvent& event);
    void updateTexts();
    void paintMarks(QPainter& painter);
    [[nodiscard]] MapPointer pointerOf(const QMouseEvent& event) const;

    ScenarioDocument& m_document;
    Selection& m_selection;
    MapScene m_scene;
    MapCamera m_camera;
    MapPanels m_panels;
    MapEdits m_edits;
    MapToolbox m_tools;
    MapPicture m_picture; ///< as set by the owner
    std::optional<Scenario> m_preview;
    std::function<void(MapPicture&)> m_draft; ///< null without a draft

    bool m_isLocked = false;
    bool m_mayIntervene = false;   ///< while locked
    bool m_fitsNextPicture = true; ///< next picture is the first of a scenario
    bool m_hasKeyboardFocus = false;
    std::optional<QPointF> m_cursor;  ///< nullopt if not over the map
    std::optional<QPointF> m_panFrom; ///< last position of a drag with the middle button
    bool m_pressedPanel = false;      ///< the last press was on a panel
    std::string m_highlighted;
    QTimer m_settleTimer;
};

} // namespace berg
