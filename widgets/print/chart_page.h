#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns a page with the charts of zeta and of sigma per iceberg over the whole flight, in the
 * light theme. Throws `Error{InvalidInput}` if nothing was flown. Runs on any thread with a
 * QGuiApplication.
 */
[[nodiscard]] PicturePage chartPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
