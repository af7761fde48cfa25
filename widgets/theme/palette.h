#pragma once

#include "widgets/theme/theme.h"

#include <QPalette>

namespace berg {

/** Palette of the widgets around map and charts, in the theme's colours. */
[[nodiscard]] QPalette paletteOf(const Theme& theme);

/** Number of distinct UAV colours. */
inline constexpr int kUavColours = 6;

/**
 * Colour of the UAV at `index` of its scenario, from the palette of Okabe and Ito, which
 * colour-blind people can distinguish, in shades that keep 3 : 1 on sea, land and panels. The first
 * is `Theme::uav`; colours repeat after the last. The night theme uses reds of different lightness.
 */
[[nodiscard]] QColor uavColour(const Theme& theme, int index);

/** Returns whether the desktop's palette is dark, regardless of the program's palette. */
[[nodiscard]] bool systemPaletteIsDark();

} // namespace berg
