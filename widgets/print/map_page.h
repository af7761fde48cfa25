#pragma once

#include "core/io/export/content/export_content.h"
#include "widgets/theme/picture_page.h"

#include <QLocale>

namespace berg {

/**
 * Returns the map of an export as a page of its own in the light theme: paths, icebergs, visits of
 * a track, title with readouts, legend, scale bar, wind. Runs on any thread with a QGuiApplication
 * (fonts).
 */
[[nodiscard]] PicturePage mapPage(const ExportContent& content, const QLocale& locale);

} // namespace berg
