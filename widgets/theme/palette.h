#pragma once

#include "widgets/theme/theme.h"

#include <QPalette>

namespace berg {

/** Palette of the widgets around map and charts, in the theme's colours. */
[[nodiscard]] QPalette paletteOf(const Theme& theme);

/** Whether the desktop's own palette is dark, whatever palette the program has set. */
[[nodiscard]] bool systemPaletteIsDark();

} // namespace berg
