#pragma once

#include "core/io/export/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * The map of what is exported as a page of its own, light: ways, icebergs, visits of a track, title
 * with figures, legend, scale bar, wind. Thread: any with a QGuiApplication (fonts).
 */
[[nodiscard]] PicturePage mapPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
