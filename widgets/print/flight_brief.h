#pragma once

#include "core/io/export/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * One page to be printed and taken along: map, order with coordinates, legs and times, wind, what
 * to look out for. A4, or Letter where the locale is imperial as in the USA. The page holds all
 * that it paints; the content may go. Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage flightBrief(const ExportContent& content, const QLocale& locale);

} // namespace berg
