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

/** A clickable part of a panel. */
struct MapPanelPart
{
    MapPanel panel = MapPanel::Title;
    bool isGrip = false; ///< the handle that moves the panel; otherwise its fold button or icon
};

/**
 * Content of the interactive map: one picture in one view, the positions of its parts on the
 * screen, and what is under the cursor. Caches what does not change between frames; nothing is
 * computed before it is needed. GUI thread.
 */
class MapScene
{
public:
    MapScene();

    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    /** The picture keeps what `setLive` has set. */
    void setPicture(MapPicture picture);
    void setLive(MapLive live) { m_picture.live = std::move(live); }
    [[nodiscard]] const Theme& theme() const { return m_theme; }
    void setTheme(const Theme& theme);
    /** Call it also if only the language has changed, because cached drawings contain text. */
    void setLocale(const QLocale& locale);
    [[nodiscard]] const QLocale& locale() const { return m_locale; }

    [[nodiscard]] const QRectF& rect() const { return m_rect; }
    void setRect(const QRectF& rect);
    [[nodiscard]] const MapViewTransform& view() const { return m_view; }
    void setView(const MapViewTransform& view);
    /** Shows all objects as large as possible clear of overlays; labels are placed anew. */
    void fit();

    /** Reserves room for a widget of this size, placed in the layout; empty reserves none. */
    void setInset(const QSizeF& inset_px);
    /** Sets the height at the top covered by another widget, px. */
    void setCover(double cover_px);

    /** Fixes the horizon of drift arrows while one is drawn; nullopt chooses it automatically. */
    void setDriftTime(std::optional<double> driftTime_s);

    /** Starts a preview. Labels return to their places at its end. */
    void beginPreview();
    void endPreview();

    /** Returns the layout of the present picture and view, which is computed on demand. */
    [[nodiscard]] const MapLayout& layout();
    /**
     * Returns true if one frame was not enough: labels still need a better place, or water seen is
     * still to be painted.
     */
    [[nodiscard]] bool isUnsettled() const { return m_pendingLabels > 0 || !m_swept.isDone(); }
    /** Lets the next layout improve as many labels as one frame has time for. */
    void settle();

    /**
     * Returns the key of the object or name at a point; empty if there is none. It also finds
     * objects below panels, but not below their buttons or the inset. Outlines of areas have the
     * lowest priority.
     */
    [[nodiscard]] std::string objectAt(const QPointF& at);
    /** Returns the keys of all objects at a point; the first is that of `objectAt`. */
    [[nodiscard]] std::vector<std::string> objectsAt(const QPointF& at);
    /** Returns the keys of objects centred in the rectangle: icebergs by index, UAVs, asset. */
    [[nodiscard]] std::vector<std::string> objectsIn(const QRectF& rect);
    /** Returns the symbol of an object; nullopt for an area or if it is not in the picture. */
    [[nodiscard]] std::optional<LabelDisk> symbolOf(const std::string& key);
    /** Marks the symbols of these objects as selected. */
    void paintSelection(QPainter& painter, const std::vector<std::string>& keys);
    /** Returns the part of a panel at a point that folds, unfolds or moves it; nullopt if there is
     * none. */
    [[nodiscard]] std::optional<MapPanelPart> panelPartAt(const QPointF& at);
    /** Returns the panel at a point where it or its icon is; nullopt if there is none. */
    [[nodiscard]] std::optional<MapPanel> panelAt(const QPointF& at);
    /** Returns true if only the panel's icon is shown. */
    [[nodiscard]] bool isFolded(MapPanel panel)
    {
        return !layout().icons[static_cast<std::size_t>(panel)].isNull();
    }
    [[nodiscard]] const MapPanelStates& panels() const { return m_panels; }
    void setPanels(const MapPanelStates& panels);
    [[nodiscard]] const MapLayers& layers() const { return m_layers; }
    void setLayers(const MapLayers& layers);
    /** Returns the offset of a panel from its default place. */
    [[nodiscard]] QPointF panelOffset_px(MapPanel panel);
    /** Moves a panel to this offset from its default place; it stays within the map. */
    void movePanel(MapPanel panel, const QPointF& offset_px);
    /**
     * Sets the cursor position; nullopt if it is elsewhere. Returns true if a repaint is needed.
     */
    bool setPointer(const std::optional<QPointF>& at);
    /** Returns true if a panel covers this point and no object is there. */
    [[nodiscard]] bool isOverlay(const QPointF& at);
    /** Returns the outline of the area with this key, pixels; empty if there is none. */
    [[nodiscard]] QPolygonF outlineOf(const std::string& key) const;

    /** Returns the land layer, which reports when the ground can be painted better. */
    [[nodiscard]] LandLayer& land() { return *m_land; }

    /** Paints the picture; `marks` is called between symbols and names. */
    void paint(QPainter& painter, const std::function<void()>& marks);

private:
    /** Returns the key of the area whose outline is at a point; nullopt if there is none. */
    [[nodiscard]] std::optional<std::string> outlineAt(const QPointF& at) const;
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

    std::optional<MapLayout> m_layout; ///< nullopt if it must be computed
    MapContinuity m_continuity;        ///< from the previous layout
    std::optional<MapContinuity> m_beforePreview;
    std::size_t m_turnFrom = 0;      ///< next iceberg whose label is placed anew
    std::size_t m_pendingLabels = 0; ///< number of labels still to be placed anew
    bool m_hasTime = true;

    std::optional<Graticule> m_graticule; ///< for the present view
    std::unique_ptr<LandLayer> m_land;
    QPixmap m_ground;
    bool m_isGroundOld = true; ///< must be painted again
    MapSprites m_sprites;
    SweptLayer m_swept;
};

} // namespace berg
