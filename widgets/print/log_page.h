#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns the log of a flight (`flightLog`) on two or three pages: planned and flown values, map of
 * the flight, zeta and its prediction; sightings; deviations, program, seed, plan's hash. The size
 * is that of the flight brief. Throws like `flightLog`. Runs on any thread with a QGuiApplication
 * (fonts).
 */
[[nodiscard]] PicturePage logPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
