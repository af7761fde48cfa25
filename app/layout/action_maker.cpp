#include "app/layout/action_maker.h"

#include <QMenuBar>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

void addCommands(const QList<QAction*>& actions, const QString& path,
                 std::vector<MenuCommand>& commands)
{
    for (QAction* action : actions) {
        const QString text = QString(action->text()).remove(u'&');
        if (const QMenu* menu = action->menu())
            addCommands(menu->actions(), path.isEmpty() ? text : path + u", "_s + text, commands);
        else if (!text.isEmpty())
            commands.push_back({action, text, path});
    }
}

} // namespace

std::vector<MenuCommand> menuCommands(const QMenuBar& bar)
{
    std::vector<MenuCommand> commands;
    addCommands(bar.actions(), {}, commands);
    return commands;
}

QString nameInGroup(const MenuCommand& command)
{
    const QString group = command.path.section(u", "_s, 1);
    return group.isEmpty() ? command.text : group + u": "_s + command.text;
}

void ActionMaker::refreshIcons(const Theme& theme) const
{
    for (const auto& [action, name] : m_icons)
        action->setIcon(icon(name, theme));
}

} // namespace berg
