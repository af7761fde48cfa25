#pragma once

#include "widgets/map/paint/label_placement.h"
#include "widgets/map/paint/map_density.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/map_weather_layer.h"
#include "widgets/map/paint/place_names.h"

#include <QHash>
#include <QPolygonF>

#include <optional>

namespace berg {

/** Positions of all parts of one picture, device-independent pixels. */
struct MapLayout
{
    QRectF rect;
    MapViewTransform view;
    SymbolScale symbols;
    QRectF title; ///< overlays; a null rectangle is not shown
    bool isTitleCompact = false;
    QRectF legend;
    QSizeF leastLegend_px; ///< smallest size of the legend: it does not shrink in flight
    bool isLegendCompact = false;
    QRectF scaleBar;
    QRectF north;
    QRectF wind;
    QRectF inset; ///< reserved for the overview inset, which is another widget
    /** Icons of folded panels, whose own rectangles are null. */
    std::array<QRectF, kMapPanels> icons;
    /** Offset of each panel from its default place. */
    std::array<QPointF, kMapPanels> moved_px;
    std::vector<LabelDisk> icebergs; ///< symbol with its ring, by iceberg
    std::vector<MapStop> stops;      ///< by iceberg
    MapDensity density;              ///< form of each iceberg
    std::vector<QRectF> uavLabels;   ///< by UAV; null without a label
    std::vector<PlacedLabel> labels; ///< id with order number, by iceberg; null if out of sight
    std::vector<MapPlaceName> places;
    MapWeatherMarksPointer weather; ///< null without a forecast

    /** Returns the rectangles of all panels and icons shown, which labels avoid. */
    [[nodiscard]] std::vector<QRectF> overlays() const;
    /** Returns the rectangle of a panel; null if it is not shown. */
    [[nodiscard]] const QRectF& panel(MapPanel which) const;
};

/** Panels that the user can fold and move; all panels can be hidden. */
inline constexpr std::array<MapPanel, 3> kFoldingPanels{MapPanel::Title, MapPanel::Legend,
                                                        MapPanel::Wind};
/** Returns the button of a panel that folds it to an icon. */
[[nodiscard]] QRectF foldButtonOf(const QRectF& panel);
/** Returns the handle by which a panel is moved. */
[[nodiscard]] QRectF panelGripOf(const QRectF& panel);

/** Radius of the order number's disk in an iceberg's label, left of the id. */
inline constexpr double kOrderDisk_px = 9;
inline constexpr double kOrderGap_px = 4;
inline constexpr double kLaterDisk_px = 7; ///< radius for later visits, right of the name
inline constexpr double kLaterGap_px = 2;
inline constexpr std::size_t kMostLater = 3;
/** Returns the font of labels on the map. */
[[nodiscard]] QFont labelFont(const Theme& theme);
/** Returns the label of an iceberg: its id, with the time for a future one, "lost" for a lost one,
 * or "given up" if the search for it was. */
[[nodiscard]] QString labelText(const MapIceberg& iceberg, const MissionClock& clock);

/** Range of icebergs whose labels may move in this frame. */
struct LabelTurn
{
    std::size_t first = 0;
    std::size_t count = 0;
};

/** State passed from frame to frame to keep a moving map steady. */
struct MapContinuity
{
    /** Label places by iceberg id, relative to the centre of its symbol; null if not shown. */
    QHash<QString, PlacedLabel> labels;
    /** Only these labels are placed anew, the others keep their place; nullopt means all. */
    std::optional<LabelTurn> turn;
    /** Horizon of drift arrows to keep, instead of one that suits the fastest iceberg. */
    std::optional<double> driftTime_s;
    MapCrowding crowding{};
    MapWeatherMarksPointer weather; ///< kept while forecast and view are the same
    QSizeF legend_px;               ///< smallest legend in flight, so that changes move nothing
    bool isLegendCompact = false;
};

/** Returns the state of a layout from which the next frame starts. */
[[nodiscard]] MapContinuity continuityOf(const MapPicture& picture, const MapLayout& layout);

/**
 * Lays out `picture` in `rect`. Without `view` it shows everything as large as possible; a smaller
 * scale is chosen if it keeps symbols clear of overlays. Overlays that would take too much of a
 * small map are left out. `continuity` is the state of the previous frame. Runs on any thread with
 * a QGuiApplication (fonts).
 */
[[nodiscard]] MapLayout arrangeMap(const MapPicture& picture, const MapStyle& style,
                                   const QRectF& rect,
                                   const std::optional<MapViewTransform>& view = {},
                                   const MapContinuity& continuity = {});

} // namespace berg
