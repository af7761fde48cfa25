#pragma once

#include "core/io/export/export_content.h"
#include "widgets/print/brief_layout.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * A page to be printed and taken along: map, order with coordinates, legs and times, wind, what to
 * look out for; where a permit is applied for, a second one about the operation. A4, or Letter
 * where the locale is imperial as in the USA. The page holds all that it paints; the content may
 * go. Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage flightBrief(const ExportContent& content, const QLocale& locale);

/** A4 or Letter, at 96 to the inch. */
[[nodiscard]] QSize briefPage_px(const QLocale& locale);

/** Rules and texts of a page. */
void paintLayout(QPainter& painter, const BriefLayout& layout);

} // namespace berg
