#pragma once

#include "widgets/map/paint/map_layers.h"
#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>

#include <array>

namespace berg {

/** Panels on the map, in painting order. */
enum class MapPanel
{
    Legend,
    ScaleBar,
    North,
    Wind,
    Title
};
inline constexpr std::size_t kMapPanels = 5;

/** State of a panel set by the user. */
struct MapPanelState
{
    bool isHidden = false;
    bool isFolded = false; ///< shown as an icon in its corner
    bool isOpened = false; ///< opened from its icon: shown even if it displaces others
    QPointF moved_px;      ///< offset from its default place
    bool operator==(const MapPanelState&) const = default;
};
using MapPanelStates = std::array<MapPanelState, kMapPanels>;

/** Parameters of a map's style. The theme is borrowed and must outlive the style. */
struct MapStyle
{
    const Theme& theme;
    QLocale locale;
    double cover_px = 0; ///< height at the top of the map covered by another widget
    QSizeF inset_px =
        {}; ///< size reserved below the north arrow for the overview inset; may be empty
    MapPanelStates panels = {};
    MapLayers layers = {};
    /** Interactive map: shows the wind panel in calm, too, and keeps legend rows in flight. */
    bool isLive = false;
};

/** Scale of symbols in one view, which the legend explains. */
struct SymbolScale
{
    double ring_pxpm = 2;   ///< pixels of ring per metre of the square root of sigma
    double driftTime_s = 0; ///< horizon of drift arrows; zero hides them
    bool showsDots = false; ///< icebergs without room for symbols are dots
    bool showsRings = true; ///< there is room for sigma rings
    /** Returns the radius of the sigma ring of a symbol of `symbol_px`; zero if sigma is zero. */
    [[nodiscard]] double ringRadius_px(double symbol_px, double sigma_m2) const;
};

/**
 * Returns two to four evenly spaced ticks of a sigma scale, without zero; the last is `full_m2`.
 */
[[nodiscard]] std::vector<double> sigmaTicks(double full_m2);

// Panels of the map: each has a size for the layout and a painter.

/** Layout parameters of the title panel. */
struct TitleForm
{
    double widest_px = 0;
    double widestText_px = 1e9; ///< width limit for title and subtitle alone
    bool isCompact = false;     ///< shows only the readouts
};

/** Returns the size of the title panel; empty if there is nothing to show. */
[[nodiscard]] QSizeF titleSize(const MapPicture& picture, const MapStyle& style, TitleForm form);
/** Paints title, subtitle and readouts into `rect`; only the readouts if compact. */
void paintTitle(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                const MapStyle& style, bool isCompact);
/**
 * Returns the readouts that fit into `room_px`, in their order; the lowest ranks are kept first.
 */
[[nodiscard]] std::vector<MapReadout> readoutsThatFit(const MapPicture& picture, const Theme& theme,
                                                      double room_px);

/** Returns the size of the legend, empty without icebergs. A compact one, for low maps, has the
 * sigma samples on the bar and two columns. */
[[nodiscard]] QSizeF legendSize(const MapPicture& picture, const MapStyle& style,
                                const SymbolScale& scale, bool compact);
/** Paints the legend into `rect`, laid out as for `legendSize`. */
void paintLegend(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                 const MapStyle& style, const SymbolScale& scale, bool compact);

/** Returns the size of the scale bars: metric and nautical, each of the longest round length (1, 2
 * or 5 times a power of ten) up to 120 px. */
[[nodiscard]] QSizeF scaleBarSize(const MapViewTransform& view, const MapStyle& style);
/** Paints both scale bars into `rect`. */
void paintScaleBar(QPainter& painter, const QRectF& rect, const MapViewTransform& view,
                   const MapStyle& style);

/** Returns the size of the north arrow panel. */
[[nodiscard]] QSizeF northArrowSize();
/** Paints a north arrow; `angle_rad` is the direction of true north, clockwise from up. */
void paintNorthArrow(QPainter& painter, const QRectF& rect, double angle_rad,
                     const MapStyle& style);

/** Paints the message on a map without icebergs, if there is room for it. */
void paintEmptyState(QPainter& painter, const QRectF& area, const MapPicture& picture,
                     const MapStyle& style);

/** Paints the rounded, slightly translucent background of a panel. */
void paintPanel(QPainter& painter, const QRectF& rect, const Theme& theme);

/** Returns the largest value of 1, 2 or 5 times a power of ten that is at most `value` > 0. */
[[nodiscard]] double roundDown125(double value);

} // namespace berg
