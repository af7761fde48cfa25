#pragma once

#include "app/layout/command.h"
#include "app/layout/window_part.h"

namespace berg {

struct WindowParts;

/** All commands of the window, in menu bar and tool bar. */
class Menus : public WindowPart
{
    Q_OBJECT

public:
    /** Acts on the parts that are made before it. */
    Menus(WindowContext& context, WindowParts& parts);

    /** Shows which commands are possible, which are set, and what they are called. */
    void update() const;
    void refreshIcons() const;

private:
    [[nodiscard]] std::vector<Command> fileCommands();
    [[nodiscard]] std::vector<Command> editCommands();
    [[nodiscard]] std::vector<Command> mapCommands();
    [[nodiscard]] std::vector<Command> mapPanels();
    [[nodiscard]] std::vector<Command> viewCommands();
    [[nodiscard]] std::vector<Command> layouts();
    [[nodiscard]] std::vector<Command> flightCommands();
    [[nodiscard]] std::vector<Command> tools();
    [[nodiscard]] std::vector<Command> helpCommands();
    void buildToolBar();
    void followState();
    [[nodiscard]] std::vector<std::string> orderedUavs() const;
    void undo();
    void showShortcuts();
    void showAbout();

    WindowParts& m_parts;
    CommandActions m_actions;
};

} // namespace berg
