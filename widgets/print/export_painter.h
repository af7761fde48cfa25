#pragma once

#include "widgets/flight/export_preview.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns the page of a painted format, on white. Throws `std::logic_error` for other formats, and
 * like `chartPage` and `logPage` for theirs. Runs on any thread with a QGuiApplication.
 */
[[nodiscard]] PicturePage exportPage(const ExportFormat& format, const ExportContent& content,
                                     const QLocale& locale);

/**
 * Returns the functions with which the window renders painted formats, in its language and units.
 */
[[nodiscard]] ExportPaint exportPaint(const QLocale& locale = QLocale());

} // namespace berg
