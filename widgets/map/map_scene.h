#pragma once

#include "widgets/map/map_painter.h"
#include "widgets/map/map_sprites.h"

#include <QPixmap>

#include <functional>
#include <string>

namespace berg {

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

    /** Keeps the drift arrows at one scale while one of them is being drawn; none: as it suits. */
    void setDriftTime(std::optional<double> driftTime_s);

    [[nodiscard]] const MapLayout& layout();
    /** True when labels have no place or a bad one, because there are too many for one frame. */
    [[nodiscard]] bool isUnsettled() const { return m_labelsOwed > 0; }
    /** Lets the next layout look for better places, for as many labels as one frame has time for.
     */
    void settle();

    /** Key of the iceberg or UAV that is drawn or named here; empty: none, or an overlay. */
    [[nodiscard]] std::string objectAt(const QPointF& at);
    /** Keys of the icebergs and UAVs with their centre in the rectangle, by index, UAV last. */
    [[nodiscard]] std::vector<std::string> objectsIn(const QRectF& rect);
    /** Symbol of an object; none when it is not in the picture. */
    [[nodiscard]] std::optional<LabelDisk> symbolOf(const std::string& key);
    /** True where a panel covers the map. */
    [[nodiscard]] bool isOverlay(const QPointF& at);

    /** Paints the picture; `marks` is called above the symbols and below names and panels. */
    void paint(QPainter& painter, const std::function<void()>& marks);

private:
    [[nodiscard]] std::optional<LabelTurn> nextTurn(std::size_t inSight);
    void paintGround(QPainter& painter, const MapFrame& frame);

    MapPicture m_picture;
    Theme m_theme;
    QLocale m_locale;
    QRectF m_rect;
    MapViewTransform m_view;
    std::optional<double> m_driftTime_s;

    std::optional<MapLayout> m_layout; ///< none: to be arranged
    MapContinuity m_continuity;        ///< of the layout before
    std::size_t m_turnFrom = 0;        ///< iceberg whose label looks for a place next
    std::size_t m_labelsOwed = 0;      ///< so many still have to
    bool m_mayTakeTime = true;

    std::optional<Graticule> m_graticule; ///< of the present view
    QPixmap m_ground;                     ///< null: to be painted
    MapSprites m_sprites;
};

} // namespace berg
