#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/print/brief_layout.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns a page to print and carry along: map, order with coordinates, legs and times, wind and
 * warnings. With an operation volume it has a second page about it. The size is `briefPage_px`. The
 * page owns its data; the content may be destroyed. Runs on any thread with a QGuiApplication
 * (fonts).
 */
[[nodiscard]] PicturePage flightBrief(const ExportContent& content, const QLocale& locale);

/**
 * Returns the page size at 96 per inch: A4, or Letter for locales that are imperial as in the USA.
 */
[[nodiscard]] QSize briefPage_px(const QLocale& locale);

/** Paints the lines and texts of a page, but not its map and signs. */
void paintLayout(QPainter& painter, const BriefLayout& layout);

} // namespace berg
