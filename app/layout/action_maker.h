#pragma once

#include "app/layout/window_part.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QKeySequence>
#include <QMenu>

#include <optional>
#include <utility>
#include <vector>

class QMenuBar;

namespace berg {

struct ActionSpec
{
    const char* name; ///< object name, for tests and settings
    QString text;
    QKeySequence shortcut = {};
    std::optional<IconName> icon = {};
};

/** An entry of the menu bar that does something. */
struct MenuCommand
{
    QAction* action = nullptr;
    QString text; ///< without the mark of its letter
    QString path; ///< of the menu it is in: "View, Layouts"
};

/** In the order of the menus. What other parts of a window keep as actions is none. */
[[nodiscard]] std::vector<MenuCommand> menuCommands(const QMenuBar& bar);
/** With the submenu that it is in: "Layouts: Fly" is not "Fly". */
[[nodiscard]] QString nameInGroup(const MenuCommand& command);

/** Makes the actions of menus and tool bar, and keeps their icons in the colours of the theme. */
class ActionMaker
{
public:
    /** In the menu; `slot` runs while `context` lives. */
    template <class Slot>
    QAction* add(QMenu& menu, const ActionSpec& spec, const QObject* context, const Slot& slot)
    {
        QAction* action = menu.addAction(spec.text);
        action->setObjectName(QLatin1String(spec.name));
        action->setShortcut(spec.shortcut);
        action->setStatusTip(QString(spec.text).remove(u'&'));
        if (spec.icon)
            addIcon(action, *spec.icon);
        QObject::connect(action, &QAction::triggered, context, slot);
        return action;
    }
    void addIcon(QAction* action, IconName name) { m_icons.emplace_back(action, name); }
    void refreshIcons(const Theme& theme) const;

private:
    std::vector<std::pair<QAction*, IconName>> m_icons;
};

} // namespace berg
