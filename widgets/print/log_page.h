#pragma once

#include "core/io/export/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * The log of a flight (`flightLog`) on two pages, three where there is much to tell: planned
 * against flown, the map of what was flown, zeta against prediction; sightings; deviations,
 * program, seed and hash of the plan. A4 or Letter as the flight brief. Throws as `flightLog`.
 * Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage logPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
