#pragma once

#include "widgets/map/paint/label_placement.h"
#include "widgets/map/paint/map_density.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/paint/place_names.h"

#include <QHash>
#include <QPolygonF>

#include <optional>

namespace berg {

/** Where everything of one picture goes, device-independent pixels. */
struct MapLayout
{
    QRectF rect;
    MapViewTransform view;
    SymbolScale symbols;
    QRectF title; ///< overlays; a null rectangle is not shown
    QRectF legend;
    QSizeF leastLegend_px; ///< as large as it was
    bool isLegendCompact = false;
    QRectF scaleBar;
    QRectF north;
    QRectF wind;
    QRectF inset; ///< kept free, not painted
    /** Of folded panels, which then are null themselves. */
    std::array<QRectF, kMapPanels> icons;
    /** By how much panels stand off from where they are by themselves. */
    std::array<QPointF, kMapPanels> moved_px;
    std::vector<LabelDisk> icebergs; ///< symbol with its ring, by index
    std::vector<MapStop> stops;      ///< by iceberg
    MapDensity density;              ///< which of them are drawn as symbols
    std::vector<QRectF> uavLabels;   ///< names of the UAVs; null: it has none
    std::vector<PlacedLabel> labels; ///< id with order number, by iceberg; null: out of sight
    std::vector<MapPlaceName> places;

    [[nodiscard]] std::vector<QRectF> overlays() const;
    [[nodiscard]] const QRectF& panel(MapPanel which) const;
};

/** Panels that fold and move; hidden can be all. */
inline constexpr std::array<MapPanel, 3> kFoldingPanels{MapPanel::Title, MapPanel::Legend,
                                                        MapPanel::Wind};
[[nodiscard]] QRectF foldButtonOf(const QRectF& panel);
[[nodiscard]] QRectF panelGripOf(const QRectF& panel);

/** Sizes inside an iceberg's label: number in its disk, then the id. */
inline constexpr double kOrderDisk_px = 9; ///< radius
inline constexpr double kOrderGap_px = 4;
inline constexpr double kLaterDisk_px = 7; ///< radius, of later visits, behind the name
inline constexpr double kLaterGap_px = 2;
inline constexpr std::size_t kMostLater = 3;
[[nodiscard]] QFont labelFont(const Theme& theme);
/** Id of the iceberg; of one still to come with the time when it will, and whether it is lost. */
[[nodiscard]] QString labelText(const MapIceberg& iceberg, const MissionClock& clock);

/** Icebergs by index whose labels may look for a place. */
struct LabelTurn
{
    std::size_t first = 0;
    std::size_t count = 0;
};

/** What one frame hands on to the next, so that a moving map stays calm. */
struct MapContinuity
{
    /** Label places by iceberg id, relative to the centre of its symbol; null: not shown. */
    QHash<QString, PlacedLabel> labels;
    /** The other labels stay as they were, however bad, new ones away; none: all may look. */
    std::optional<LabelTurn> turn;
    /** Drift arrows of this time instead of the one that suits the fastest iceberg. */
    std::optional<double> driftTime_s;
    MapCrowding crowding{};
    QSizeF legend_px; ///< that of a flight does not shrink: what comes and goes moves nothing
    bool isLegendCompact = false;
};

/** The part of a layout that the next frame starts from. */
[[nodiscard]] MapContinuity continuityOf(const MapPicture& picture, const MapLayout& layout);

/**
 * Layout of `picture` in `rect`. Without `view` everything is fitted so that no symbol lies under
 * an overlay, as large as that allows. Overlays that would take too much of a small map are left
 * out. Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] MapLayout arrangeMap(const MapPicture& picture, const MapStyle& style,
                                   const QRectF& rect,
                                   const std::optional<MapViewTransform>& view = {},
                                   const MapContinuity& continuity = {});

} // namespace berg
