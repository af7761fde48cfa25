#pragma once

#include "widgets/theme/theme.h"

#include <QIcon>

namespace berg {

/** Icons of the program. */
enum class IconName
{
    Play,
    Pause,
    Step,
    Reset,
    Select,
    Iceberg,
    Uav,
    Asset,   ///< a platform on its legs
    Area,    ///< an outline with corners
    NoFly,   ///< a hatched outline
    Measure, ///< a ruler
    Pan,
    Undo,
    Redo,
    Fit,
    Follow,
    ExportPlan,
    Open,
    Save,
    NewFile,
    Proven,   ///< a tick in a circle
    Estimate, ///< two waves: approximate
    Warning,
    Fault, ///< a cross in an octagon: must be fixed first
    Hint,  ///< an i in a circle
    Locked,
    Pin,
    More ///< further items without room
};
inline constexpr int kIconCount = static_cast<int>(IconName::More) + 1;

/**
 * Line icon on a 24 px grid in the theme's text colour, fainter when disabled. It is drawn as
 * vectors and therefore sharp at every size.
 */
[[nodiscard]] QIcon icon(IconName name, const Theme& theme);

} // namespace berg
