#pragma once

#include "core/io/export/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Zeta with the sum of sigma, and below it sigma of each iceberg, over the whole flight, light.
 * Throws `Error{InvalidInput}` when nothing was flown. Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage chartPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
