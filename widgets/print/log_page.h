#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns the log of a flight on paper: the text of `flightLogHtml` in the user's units, with a map
 * of the flight. The size is that of the flight brief. Throws like `flightLog`. Runs on any thread
 * with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage logPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
