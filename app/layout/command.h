#pragma once

#include "widgets/theme/icons.h"

#include <QKeySequence>
#include <QList>
#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <vector>

class QAction;
class QActionGroup;
class QMainWindow;
class QMenu;
class QMenuBar;

namespace berg {

/** Conditions under which a command is possible. */
enum class When : unsigned
{
    Always = 0,
    Unlocked = 1, ///< before take-off
    InFlight = 2,
    IcebergsSelected = 4, ///< of the scenario
    CopiesSelected = 8,   ///< icebergs or UAVs of the scenario
    FlownSelected = 16,   ///< icebergs of the flight
    Removable = 32,       ///< what is selected
    UavOrdered = 64,      ///< a UAV is selected, or the only one
    Undoable = 128,
    Redoable = 256,
    Restorable = 512 ///< a flight was discarded
};
[[nodiscard]] constexpr When operator|(When a, When b)
{
    return static_cast<When>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/** The keys of a command: of the platform, or as text ("Ctrl+F; Ctrl+G"). */
struct Keys
{
    Keys() = default;
    // NOLINTBEGIN(google-explicit-constructor): a row of the list has one or the other
    Keys(QKeySequence::StandardKey key) : list{QKeySequence(key)} {}
    Keys(const char* text) : list(QKeySequence::listFromString(QLatin1String(text))) {}
    // NOLINTEND(google-explicit-constructor)

    QList<QKeySequence> list;
};

/** State that a switch shows and sets. */
struct Switch
{
    std::function<bool()> isOn;
    std::function<void(bool)> set;
    const char* group = nullptr; ///< of which only one is on
};

/** A switch of a part of the window, which must outlive it. */
template <class Part, class IsOn, class Set>
Switch switchOf(Part& part, IsOn isOn, Set set)
{
    return {[&part, isOn] { return (part.*isOn)(); }, [&part, set](bool on) { (part.*set)(on); }};
}

using Icon = std::optional<IconName>;

/**
 * One entry of a menu: a command, which tool bar, context menus, find box and list of shortcuts
 * take from there; a submenu, filled once; or, as it is by itself, a line.
 */
struct Command
{
    Command() = default;
    Command(const QString& title, const std::function<void(QMenu&)>& filling)
        : text(title), fill(filling)
    {
    }
    Command(const char* name, const QString& title, const std::function<void()>& what, When needed,
            const Keys& shortcuts = {}, Icon picture = {})
        : id(name), text(title), run(what), when(needed), keys(shortcuts.list), icon(picture)
    {
    }
    Command(const char* name, const QString& title, const std::function<void()>& what,
            const Keys& shortcuts = {}, Icon picture = {})
        : Command(name, title, what, When::Always, shortcuts, picture)
    {
    }
    Command(const char* name, const QString& title, const Switch& what, const Keys& shortcuts = {},
            Icon picture = {})
        : id(name), text(title), toggle(what), keys(shortcuts.list), icon(picture)
    {
    }
    Command(const char* name, const QString& title, const QString& words, const Switch& what)
        : id(name), text(title), toggle(what), tip(words)
    {
    }

    const char* id = nullptr; ///< name of the action, for context menus, tests and settings
    QString text;
    std::function<void()> run;
    Switch toggle; ///< in place of `run`, or empty
    When when = When::Always;
    QList<QKeySequence> keys;
    Icon icon;
    QString tip; ///< shown in the status bar; `text` is shown if it is empty
    std::function<void(QMenu&)> fill;
};

/** Makes actions of the commands of a window and keeps them up to date. */
class CommandActions
{
public:
    explicit CommandActions(QMainWindow& window) : m_window(window) {}

    void add(QMenu& menu, const std::vector<Command>& commands);
    [[nodiscard]] QList<QAction*> group(const char* name) const;
    /** Shows which commands are possible and which are set. */
    void update(When state) const;
    void refreshIcons(const Theme& theme) const;

private:
    void add(QMenu& menu, const Command& command);

    QMainWindow& m_window;
    std::map<QString, QActionGroup*> m_groups;
    std::vector<std::pair<QAction*, Command>> m_commands;
};

/** Returns the action of a command, which must exist. */
[[nodiscard]] QAction* commandAction(const QMainWindow& window, const char* id);

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

} // namespace berg
