#pragma once

#include "app/layout/action_maker.h"
#include "app/layout/window_part.h"
#include "core/world/world_state.h"
#include "widgets/map/paint/map_overlays.h"
#include "widgets/map/view/map_tools.h"

#include <array>
#include <map>
#include <vector>

class QActionGroup;
class QMenu;

namespace berg {

struct WindowParts;

/** Actions that are in a context menu or the tool bar as well. */
struct SharedActions
{
    QAction* undo = nullptr;
    QAction* redo = nullptr;
    QAction* cut = nullptr;
    QAction* copy = nullptr;
    QAction* duplicate = nullptr;
    QAction* remove = nullptr;
    QAction* selectAll = nullptr;
    QAction* generate = nullptr;
    QAction* fit = nullptr;
    QAction* follow = nullptr;
    QAction* exportPlan = nullptr;
    QAction* log = nullptr;
    QAction* seen = nullptr;
    QAction* wind = nullptr;
    QAction* fullScreen = nullptr;
    std::map<FlightOrder, QAction*> orders;    ///< to the selected UAVs
    std::array<QAction*, kMapPanels> panels{}; ///< show and hide those on the map
    QMenu* sigmaEnd = nullptr;
};

/** Menu bar and tool bar, and which of their actions are possible now. */
class Menus : public WindowPart
{
    Q_OBJECT

public:
    /** Acts on the parts that are made before it. */
    Menus(WindowContext& context, WindowParts& parts);

    [[nodiscard]] const SharedActions& shared() const { return m_shared; }
    void refreshIcons() const;

private:
    void updateActions();
    template <class Slot>
    QAction* add(QMenu& menu, const ActionSpec& spec, const Slot& slot);
    template <class Slot>
    QAction* addSwitch(QMenu& menu, const ActionSpec& spec, bool isOn, const Slot& slot);
    QMenu& addMenu(const QString& title);
    void buildFileMenu();
    void buildEditMenu();
    void buildViewMenu();
    void buildMapActions(QMenu& menu);
    void addLayouts(QMenu& menu);
    void addPanelMenu(QMenu& menu);
    void buildFlightMenu();
    void buildLookBackActions(QMenu& menu);
    void buildToolBar();
    void buildHelpMenu();
    void addTool(QActionGroup& tools, MapToolKind kind, const ActionSpec& spec);
    [[nodiscard]] std::vector<std::string> orderedUavs() const;
    void showShortcuts();
    void showAbout();

    WindowParts& m_parts;
    ActionMaker m_maker;
    SharedActions m_shared;
    std::vector<QAction*> m_editActions; ///< locked in flight
};

} // namespace berg
