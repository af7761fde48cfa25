#pragma once

#include "widgets/map/paint/map_overlays.h"

#include <functional>
#include <vector>

namespace berg {

/** Legend entry: a symbol of the map and its meaning. */
struct LegendRow
{
    QString text;
    QString word;                                       ///< short form for compact legends
    std::function<void(QPainter&, const QRectF&)> draw; ///< draws the symbol into a swatch
    double height_px = 0;
};

inline constexpr double kLegendSwatch_px = 34;
inline constexpr double kLegendBar_px = 190;
inline constexpr double kLegendUnits_px = 34; ///< room for "m²" after the last number of the bar

/**
 * Returns the legend entries for `picture`. Picture and theme are borrowed and must outlive them.
 */
[[nodiscard]] std::vector<LegendRow> legendRows(const MapPicture& picture, const MapStyle& style,
                                                const SymbolScale& scale);

/** Symbols and names of the UAVs of a fleet in the legend, side by side in rows. */
class LegendUavs
{
public:
    /** Lays out the UAVs in this width; empty (height zero) for a single UAV. */
    LegendUavs(const MapPicture& picture, const Theme& theme, double width_px);

    [[nodiscard]] double height_px() const { return m_height_px; }
    /** Paints with the top left corner at `at`; `theme` must be that of the constructor. */
    void paint(QPainter& painter, const QPointF& at, const Theme& theme) const;

private:
    struct Chip
    {
        QPointF at; ///< middle of the left edge
        QString name;
        QColor colour;
    };
    std::vector<Chip> m_chips;
    double m_height_px = 0;
};

} // namespace berg
