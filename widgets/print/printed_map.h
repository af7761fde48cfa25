#pragma once

#include "core/io/export/content/export_content.h"

#include <QColor>
#include <QLocale>
#include <QSizeF>

#include <functional>

class QPainter;

namespace berg {

/** Returns the painter of an export's map with wind, in a frame of that size at the origin. The
 * painter owns its data. */
[[nodiscard]] std::function<void(QPainter&)>
printedMap(const ExportContent& content, const QSizeF& size_px, const QLocale& locale);

/** Returns the colour in which that map shows the plan of UAV `uav` of the content. */
[[nodiscard]] QColor printedColour(const ExportContent& content, std::size_t uav);

} // namespace berg
