#pragma once

#include "widgets/map/paint/map_layers.h"
#include "widgets/map/picture/map_picture.h"
#include "widgets/map/picture/map_view_transform.h"
#include "widgets/theme/theme.h"

#include <QLocale>
#include <QPainter>

#include <array>

namespace berg {

/** Panels on the map, in the order in which they are painted. */
enum class MapPanel
{
    Legend,
    ScaleBar,
    North,
    Wind,
    Title
};
inline constexpr std::size_t kMapPanels = 5;

/** What the user has made of a panel. */
struct MapPanelState
{
    bool isHidden = false;
    bool isFolded = false; ///< an icon in its corner
    bool isOpened = false; ///< from its icon: shown even where it takes the room of others
    QPointF moved_px;      ///< from where it is by itself
    bool operator==(const MapPanelState&) const = default;
};
using MapPanelStates = std::array<MapPanelState, kMapPanels>;

/** What decides the look of a map beside its content. Borrowed theme: it must outlive the style. */
struct MapStyle
{
    const Theme& theme;
    QLocale locale;
    double cover_px = 0;  ///< at the top of the map, below what lies over it
    QSizeF inset_px = {}; ///< kept free below the north arrow; empty: nothing
    MapPanelStates panels = {};
    MapLayers layers = {};
    /** Of the window: the panel of the wind is there in calm, too, to be used, and rows of the
     * legend for what comes and goes in flight. */
    bool isLive = false;
};

/** How symbols are scaled in one view; the legend explains it. */
struct SymbolScale
{
    double ring_pxpm = 2;   ///< pixels of ring for each metre of the root of sigma
    double driftTime_s = 0; ///< drift arrows show the way of this time; 0: no arrows
    bool showsDots = false; ///< of icebergs without room for their symbols
    bool showsRings = true; ///< there is room for them
    /** Radius of the ring round a symbol of `symbol_px`; 0 in view or for sigma 0. */
    [[nodiscard]] double ringRadius_px(double symbol_px, double sigma_m2) const;
};

/** Round ticks of a sigma scale that ends at `full_m2`: two to four, 0 not included. */
[[nodiscard]] std::vector<double> sigmaTicks(double full_m2);

// The panels on the map: a size to lay them out by, and a painter for the place they got.

/** Size of title, subtitle and readouts, not wider than `widest_px`; empty: nothing to say. */
[[nodiscard]] QSizeF titleSize(const MapPicture& picture, const MapStyle& style, double widest_px);
void paintTitle(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                const MapStyle& style);

/** `compact`: for low maps, with the samples of sigma on its bar and two signs in a row. */
[[nodiscard]] QSizeF legendSize(const MapPicture& picture, const MapStyle& style,
                                const SymbolScale& scale, bool compact);
void paintLegend(QPainter& painter, const QRectF& rect, const MapPicture& picture,
                 const MapStyle& style, const SymbolScale& scale, bool compact);

/** Two bars, metric and nautical miles, each of a round length near 120 px. */
[[nodiscard]] QSizeF scaleBarSize(const MapViewTransform& view, const MapStyle& style);
void paintScaleBar(QPainter& painter, const QRectF& rect, const MapViewTransform& view,
                   const MapStyle& style);

[[nodiscard]] QSizeF northArrowSize();
/** `angle_rad` of true north, clockwise from straight up. */
void paintNorthArrow(QPainter& painter, const QRectF& rect, double angle_rad,
                     const MapStyle& style);

/** The words in the middle of a map without icebergs. */
void paintEmptyState(QPainter& painter, const QRectF& area, const MapPicture& picture,
                     const MapStyle& style);

/** Rounded, slightly translucent ground of every panel. */
void paintPanel(QPainter& painter, const QRectF& rect, const Theme& theme);

/** Largest 1, 2 or 5 times a power of ten that is at most `value` > 0. */
[[nodiscard]] double roundDown125(double value);

} // namespace berg
