#pragma once

#include "widgets/theme/theme.h"

#include <QPalette>

namespace berg {

/** Palette of the widgets around map and charts, in the theme's colours. */
[[nodiscard]] QPalette paletteOf(const Theme& theme);

/** So many UAVs have a colour of their own. */
inline constexpr int kUavColours = 6;

/**
 * Colour of the UAV at place `index` of its scenario, by the palette of Okabe and Ito, which the
 * colour-blind tell apart; shades of it that keep 3 : 1 on sea, land and panels. The first is
 * `Theme::uav`; after the last they begin anew. By night they are reds that differ in lightness.
 */
[[nodiscard]] QColor uavColour(const Theme& theme, int index);

/** Whether the desktop's own palette is dark, whatever palette the program has set. */
[[nodiscard]] bool systemPaletteIsDark();

} // namespace berg
