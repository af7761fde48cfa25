#pragma once

#include "widgets/map/paint/map_overlays.h"

#include <functional>
#include <vector>

namespace berg {

/** One sign of the map: a small drawing and what it means. */
struct LegendRow
{
    QString text;
    QString word;                                       ///< the same where there is little room
    std::function<void(QPainter&, const QRectF&)> draw; ///< into a swatch
    double height_px = 0;
};

inline constexpr double kLegendSwatch_px = 34;
inline constexpr double kLegendBar_px = 190;
inline constexpr double kLegendUnits_px = 34; ///< room for "m²" after the last number of the bar

/** The signs that are in the picture. Theme and picture are borrowed: they must outlive the rows.
 */
[[nodiscard]] std::vector<LegendRow> legendRows(const MapPicture& picture, const MapStyle& style,
                                                const SymbolScale& scale);

/** The UAVs of a fleet in the legend: their signs and names one beside the other, in rows. */
class LegendUavs
{
public:
    /** Of a single UAV there is nothing to say: the height is 0. */
    LegendUavs(const MapPicture& picture, const Theme& theme, double width_px);

    [[nodiscard]] double height_px() const { return m_height_px; }
    /** From the top left; the theme is that of the constructor. */
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
