#pragma once

#include "widgets/print/brief_content.h"

#include <QColor>
#include <QSizeF>

#include <limits>

namespace berg {

/** How much of a brief is printed, and how large. */
struct BriefFit
{
    static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

    int size_px = 12;        ///< font size of the routes
    std::size_t columns = 1; ///< tables of routes side by side
    int warningLines = 10;
    int noteLines = 5;
    double map_px = 360;     ///< height
    std::size_t rows = kAll; ///< of each route
    std::size_t routes = kAll;
};

/** Returns captions and rows as a table, the first column left-aligned; a large fleet is cut, and a
 * line gives the number of UAVs left out. */
[[nodiscard]] std::string uavTableHtml(const std::vector<QStringList>& rows, double width_px);

/** Returns the brief as HTML with the picture "map"; `colours` are those of the content's UAVs. */
[[nodiscard]] std::string briefHtml(const BriefContent& content, const BriefFit& fit,
                                    const std::vector<QColor>& colours, double width_px);

} // namespace berg
