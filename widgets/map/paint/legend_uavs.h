#pragma once

#include "widgets/map/picture/map_picture.h"
#include "widgets/theme/theme.h"

#include <QPainter>

namespace berg {

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
