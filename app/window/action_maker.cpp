#include "app/window/action_maker.h"

namespace berg {

void ActionMaker::refreshIcons(const Theme& theme) const
{
    for (const auto& [action, name] : m_icons)
        action->setIcon(icon(name, theme));
}

} // namespace berg
