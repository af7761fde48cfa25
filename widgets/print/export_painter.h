#pragma once

#include "widgets/model/export_preview.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/** The page of a painted format, on white. Thread: any. */
[[nodiscard]] PicturePage exportPage(const ExportFormat& format, const ExportContent& content,
                                     const QLocale& locale);

/** How the window makes painted formats: in its language, number format and units. */
[[nodiscard]] ExportPaint exportPaint(const QLocale& locale = QLocale());

} // namespace berg
