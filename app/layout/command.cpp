#include "app/layout/command.h"

#include "core/base/error.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
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

void CommandActions::add(QMenu& menu, const std::vector<Command>& commands)
{
    for (const Command& command : commands)
        if (command.fill)
            command.fill(*menu.addMenu(command.text));
        else if (command.id != nullptr)
            add(menu, command);
        else
            menu.addSeparator();
}

void CommandActions::add(QMenu& menu, const Command& command)
{
    QAction* action = menu.addAction(command.text);
    action->setObjectName(QLatin1String(command.id));
    action->setShortcuts(command.keys);
    action->setStatusTip(command.tip.isEmpty() ? QString(command.text).remove(u'&') : command.tip);
    action->setCheckable(command.toggle.isOn != nullptr);
    if (command.toggle.group != nullptr) {
        QActionGroup*& group = m_groups[QLatin1String(command.toggle.group)];
        if (group == nullptr)
            group = new QActionGroup(&m_window);
        group->addAction(action);
    }
    if (action->isCheckable())
        QObject::connect(action, &QAction::triggered, &m_window, command.toggle.set);
    else
        QObject::connect(action, &QAction::triggered, &m_window, command.run);
    m_commands.emplace_back(action, command);
}

QList<QAction*> CommandActions::group(const char* name) const
{
    return m_groups.at(QLatin1String(name))->actions();
}

void CommandActions::update(When state) const
{
    for (const auto& [action, command] : m_commands) {
        action->setEnabled((command.when | state) == state);
        if (command.toggle.isOn)
            action->setChecked(command.toggle.isOn());
    }
}

void CommandActions::refreshIcons(const Theme& theme) const
{
    for (const auto& [action, command] : m_commands)
        if (command.icon)
            action->setIcon(berg::icon(*command.icon, theme));
}

QAction* commandAction(const QMainWindow& window, const char* id)
{
    auto* action = window.findChild<QAction*>(QLatin1String(id));
    require(action != nullptr, "no such command");
    return action;
}

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

} // namespace berg
