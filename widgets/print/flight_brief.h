#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/print/printed_document.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns a page to print and carry along: map, order with coordinates, legs and times, wind and
 * warnings. A long table is set in a smaller font and in two columns; if it still does not fit, it
 * is cut, and a line gives the number of rows left out. With an operation volume there is a second
 * page about it. The size is `briefPage_px`. The page owns its data; the content may be destroyed.
 * Runs on any thread with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage flightBrief(const ExportContent& content, const QLocale& locale);

/** Returns the first page of the brief. */
[[nodiscard]] PrintedDocument briefDocument(const ExportContent& content, const QLocale& locale);

/**
 * Returns the page size at 96 per inch: A4, or Letter for locales that are imperial as in the USA.
 */
[[nodiscard]] QSize briefPage_px(const QLocale& locale);

} // namespace berg
