#pragma once

#include "widgets/theme/theme.h"

#include <QIcon>

namespace berg {

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
    Estimate, ///< two waves: about
    Warning,
    Fault, ///< a cross in an octagon: nothing goes on before it is fixed
    Hint,  ///< an i in a circle
    Locked,
    Pin,
    More ///< what there is no room for
};
inline constexpr int kIconCount = static_cast<int>(IconName::More) + 1;

/**
 * Line icon on a grid of 24 px in the theme's text colour, fainter when disabled; drawn anew, so
 * sharp, at every size.
 */
[[nodiscard]] QIcon icon(IconName name, const Theme& theme);

} // namespace berg
