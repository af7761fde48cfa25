#include "app/window/context_menus.h"

#include "app/window/docks.h"
#include "app/window/menus.h"
#include "app/window/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/words/object_names.h"

#include <QMainWindow>
#include <QMenu>

using namespace Qt::StringLiterals;

namespace berg {

ContextMenus::ContextMenus(WindowContext& context, const Docks& docks, const SharedActions& actions)
    : WindowPart(context), m_docks(docks), m_actions(actions)
{
    connect(panels().map, &MapView::contextMenuRequested, this, &ContextMenus::showOnMap);
    connect(panels().plan, &PlanPanel::menuRequested, this, &ContextMenus::showOnPlan);
}

QMenu* ContextMenus::makeMenu(const QString& name) const
{
    auto* menu = new QMenu(&window());
    menu->setObjectName(name);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    return menu;
}

void ContextMenus::showOnMap(const QPoint& globalPos, const Point& position_m,
                             const std::string& id)
{
    QMenu* menu = makeMenu(u"mapMenu"_s);
    if (id.empty())
        addWaterActions(*menu, position_m);
    else
        addObjectActions(*menu, id);
    menu->addSeparator();
    menu->addAction(m_actions.selectAll);
    menu->addAction(m_actions.fit);
    menu->addAction(m_actions.follow);
    menu->popup(globalPos);
}

void ContextMenus::showOnPlan(const QPoint& globalPos, const std::string& id)
{
    QMenu* menu = makeMenu(u"planMenu"_s);
    addObjectActions(*menu, id);
    menu->popup(globalPos);
}

/** Of several UAVs: which of them is to visit what is selected. */
void ContextMenus::addHandOverActions(QMenu& menu, const std::string& id)
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    if (uavs.size() < 2)
        return;
    const std::string keeper = workspace().assignedUavOf(id);
    const auto add = [&](const QString& text, const std::string& uav) {
        QAction* action = menu.addAction(
            text, this, [this, uav] { workspace().assign(workspace().selection().ids(), uav); });
        action->setCheckable(true);
        action->setChecked(uav == keeper);
    };
    menu.addSeparator();
    for (const Uav& uav : uavs)
        add(tr("Assign to %1").arg(shownName(uav).replace(u'&', u"&&"_s)), uav.id);
    add(tr("Any UAV may visit it"), {});
}

void ContextMenus::addObjectActions(QMenu& menu, const std::string& id)
{
    const bool locked = workspace().inFlight();
    const bool isUav = findUav(workspace().document().scenario(), id) != nullptr;
    const bool isIceberg = !isUav && id != kAssetKey && !isOutlineKey(id);
    menu.addAction(locked ? tr("Show in the inspector") : tr("Edit in the inspector"), this,
                   [this] { m_docks.openInspector(); });
    if (isIceberg) {
        menu.addActions(
            {m_actions.cut, m_actions.copy, m_actions.duplicate, m_actions.remove, m_actions.seen});
        addHandOverActions(menu, id);
        return;
    }
    if (isUav) {
        if (locked)
            for (QAction* action : m_actions.orders)
                menu.addAction(action);
        menu.addAction(m_actions.duplicate);
        if (workspace().document().scenario().uavs.size() > 1) // the last one stays
            menu.addAction(m_actions.remove);
        return;
    }
    const QString text = id == kAssetKey  ? tr("Remove asset")
                         : id == kAreaKey ? tr("Remove area")
                                          : tr("Remove no-fly area");
    menu.addAction(text, this,
                   [this, id, text] {
                       workspace().document().edit(text, [&](Scenario& scenario) {
                           removeObjects(scenario, std::vector<std::string>{id});
                       });
                   })
        ->setEnabled(!locked);
}

void ContextMenus::addWaterActions(QMenu& menu, const Point& position_m)
{
    const bool locked = workspace().inFlight();
    menu.addAction(tr("New iceberg here"), this,
                   [this, position_m] { panels().map->addIcebergAt(position_m); });
    menu.addAction(tr("New UAV here"), this,
                   [this, position_m] { panels().map->addUavAt(position_m); })
        ->setEnabled(!locked);
    menu.addAction(
            tr("Ground station here"), this,
            [this, position_m] {
                workspace().document().edit(tr("Place ground station"), [&](Scenario& scenario) {
                    GroundStation station = scenario.groundStation.value_or(GroundStation());
                    station.position_m = position_m;
                    scenario.groundStation = station;
                });
            })
        ->setEnabled(!locked);
    menu.addAction(m_actions.wind);
    menu.addAction(m_actions.generate);
    menu.addAction(tr("Paste here"), this,
                   [this, position_m] { panels().map->pasteAt(position_m); })
        ->setEnabled(!locked);
}

} // namespace berg
