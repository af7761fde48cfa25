#pragma once

#include "widgets/map/land/land_layer.h"
#include "widgets/map/paint/map_painter.h"
#include "widgets/map/paint/map_sprites.h"
#include "widgets/map/paint/swept_layer.h"

#include <QPixmap>

#include <functional>
#include <memory>
#include <string>

namespace berg {

/** A part of a panel that can be clicked. */
struct MapPanelPart
{
    MapPanel panel = MapPanel::Title;
    bool isGrip = false; ///< moves it; else it folds and unfolds
};

/**
 * What the interactive map shows: one picture in one view, where its parts are on the screen, what
 * is under the cursor. Keeps what is the same from frame to frame; nothing is computed before it
 * is asked for. GUI thread.
 */
class MapScene
{
public:
    MapScene();

    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    void setPicture(MapPicture picture);
    [[nodiscard]] const Theme& theme() const { return m_theme; }
    void setTheme(const Theme& theme);
    /** Also to be called when only the language has changed: words are part of kept drawings. */
    void setLocale(const QLocale& locale);
    [[nodiscard]] const QLocale& locale() const { return m_locale; }

    [[nodiscard]] const QRectF& rect() const { return m_rect; }
    void setRect(const QRectF& rect);
    [[nodiscard]] const MapViewTransform& view() const { return m_view; }
    void setView(const MapViewTransform& view);
    /** Everything as large as it goes without a symbol below an overlay; labels start afresh. */
    void fit();

    /** Keeps room for a widget of this size; empty: none. Its place is in the layout. */
    void setInset(const QSizeF& inset_px);
    void setCover(double cover_px);

    /** Keeps the drift arrows at one scale while one of them is being drawn; none: as it suits. */
    void setDriftTime(std::optional<double> driftTime_s);

    /** Labels that make room for what is only previewed are where they were before at its end. */
    void beginTrial();
    void endTrial();

    [[nodiscard]] const MapLayout& layout();
    /**
     * True when labels have no place or a bad one, or water seen is still to be painted, because
     * there is too much for one frame.
     */
    [[nodiscard]] bool isUnsettled() const { return m_labelsOwed > 0 || !m_swept.isDone(); }
    /** Lets the next layout look for better places, for as many labels as one frame has time for.
     */
    void settle();

    /**
     * Key of what is drawn or named here; the outline of the area comes after everything else.
     * What lies below an overlay counts as well. Empty: nothing.
     */
    [[nodiscard]] std::string objectAt(const QPointF& at);
    /** All of them, that one first. */
    [[nodiscard]] std::vector<std::string> objectsAt(const QPointF& at);
    /** Keys of what has its centre in the rectangle: icebergs by index, UAV, asset. */
    [[nodiscard]] std::vector<std::string> objectsIn(const QRectF& rect);
    /** Symbol of an object; none when it is not in the picture, or the area. */
    [[nodiscard]] std::optional<LabelDisk> symbolOf(const std::string& key);
    /** Marks the symbols of those of the objects that have one. */
    void paintSelection(QPainter& painter, const std::vector<std::string>& keys);
    /** What is there to fold, unfold or move a panel by. */
    [[nodiscard]] std::optional<MapPanelPart> panelPartAt(const QPointF& at);
    /** The panel or icon that is there. */
    [[nodiscard]] std::optional<MapPanel> panelAt(const QPointF& at);
    [[nodiscard]] bool isFolded(MapPanel panel)
    {
        return !layout().icons[static_cast<std::size_t>(panel)].isNull();
    }
    [[nodiscard]] const MapPanelStates& panels() const { return m_panels; }
    void setPanels(const MapPanelStates& panels);
    [[nodiscard]] const MapLayers& layers() const { return m_layers; }
    void setLayers(const MapLayers& layers);
    /** By how much it stands off from where it is by itself. */
    [[nodiscard]] QPointF panelOffset_px(MapPanel panel);
    /** As far as the map reaches. */
    void movePanel(MapPanel panel, const QPointF& offset_px);
    /** Where the cursor is; none: elsewhere. True: the picture looks different. */
    bool setPointer(const std::optional<QPointF>& at);
    /** True where a panel covers the map and nothing that could be picked. */
    [[nodiscard]] bool isOverlay(const QPointF& at);
    /** Of the area or no-fly area of this key, pixels; empty: there is none. */
    [[nodiscard]] QPolygonF outlineOf(const std::string& key) const;

    /** Has news when the ground can be painted better than it was. */
    [[nodiscard]] LandLayer& land() { return *m_land; }

    /** Paints the picture; `marks` is called above the symbols and below names and panels. */
    void paint(QPainter& painter, const std::function<void()>& marks);

private:
    /** Key of the area or no-fly area whose outline is there; empty: of none. */
    [[nodiscard]] std::string outlineAt(const QPointF& at) const;
    [[nodiscard]] std::optional<LabelDisk> singleSymbolOf(const std::string& key);
    [[nodiscard]] std::vector<LabelDisk> symbolsOf(const std::vector<std::string>& keys);
    [[nodiscard]] MapStyle style() const
    {
        return {.theme = m_theme,
                .locale = m_locale,
                .cover_px = m_cover_px,
                .inset_px = m_inset_px,
                .panels = m_panels,
                .layers = m_layers,
                .isLive = true};
    }
    [[nodiscard]] std::optional<LabelTurn> nextTurn(std::size_t inSight);
    void paintGround(QPainter& painter, const MapFrame& frame);

    MapPicture m_picture;
    Theme m_theme;
    QLocale m_locale;
    QSizeF m_inset_px;
    double m_cover_px = 0;
    MapPanelStates m_panels;
    MapLayers m_layers;
    std::optional<QPointF> m_pointer;
    QRectF m_rect;
    MapViewTransform m_view;
    std::optional<double> m_driftTime_s;

    std::optional<MapLayout> m_layout; ///< none: to be arranged
    MapContinuity m_continuity;        ///< of the layout before
    std::optional<MapContinuity> m_beforeTrial;
    std::size_t m_turnFrom = 0;   ///< iceberg whose label looks for a place next
    std::size_t m_labelsOwed = 0; ///< so many still have to
    bool m_mayTakeTime = true;

    std::optional<Graticule> m_graticule; ///< of the present view
    std::unique_ptr<LandLayer> m_land;
    QPixmap m_ground;
    bool m_isGroundOld = true; ///< to be painted again
    MapSprites m_sprites;
    SweptLayer m_swept;
};

} // namespace berg
