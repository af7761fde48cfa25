// The context menus of map and plan: what can be done with what is under the cursor.

#include "app/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/model/object_names.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/panels/inspector/inspector_panel.h"

#include <QDockWidget>
#include <QMenu>

using namespace Qt::StringLiterals;

namespace berg {

void MainWindow::openInspector()
{
    auto* dock = findChild<QDockWidget*>(u"inspectorDock"_s);
    dock->show();
    dock->raise();
    m_inspector->setFocus();
}

void MainWindow::showContextMenu(const QPoint& globalPos, const Point& position_m,
                                 const std::string& id)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(u"mapMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (id.empty())
        addWaterActions(*menu, position_m);
    else
        addObjectActions(*menu, id);
    menu->addSeparator();
    menu->addAction(findChild<QAction*>(u"selectAllAction"_s));
    menu->addAction(findChild<QAction*>(u"fitAction"_s));
    menu->addAction(m_followAction);
    menu->popup(globalPos);
}

void MainWindow::showPlanMenu(const QPoint& globalPos, const std::string& id)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(u"planMenu"_s);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addObjectActions(*menu, id);
    menu->popup(globalPos);
}

/** Of several UAVs: which of them is to visit what is selected. */
void MainWindow::addHandOverActions(QMenu& menu, const std::string& id)
{
    const std::vector<Uav>& uavs = m_workspace.document().scenario().uavs;
    if (uavs.size() < 2)
        return;
    const std::string keeper = m_workspace.keeperOf(id);
    const auto add = [&](const QString& text, const std::string& uav) {
        QAction* action = menu.addAction(
            text, this, [this, uav] { m_workspace.assign(m_workspace.selection().ids(), uav); });
        action->setCheckable(true);
        action->setChecked(uav == keeper);
    };
    menu.addSeparator();
    for (const Uav& uav : uavs)
        add(tr("Assign to %1").arg(shownName(uav).replace(u'&', u"&&"_s)), uav.id);
    add(tr("Any UAV may visit it"), {});
}

void MainWindow::addObjectActions(QMenu& menu, const std::string& id)
{
    const bool locked = m_workspace.inFlight();
    const bool isUav = findUav(m_workspace.document().scenario(), id) != nullptr;
    const bool isIceberg = !isUav && id != kAssetKey && id != kAreaKey;
    menu.addAction(locked ? tr("Show in the inspector") : tr("Edit in the inspector"), this,
                   &MainWindow::openInspector);
    if (isIceberg) {
        for (const QString& name :
             {u"cutAction"_s, u"copyAction"_s, u"duplicateAction"_s, u"deleteAction"_s})
            menu.addAction(findChild<QAction*>(name));
        menu.addAction(findChild<QAction*>(u"seenAction"_s));
        addHandOverActions(menu, id);
        return;
    }
    if (isUav) {
        menu.addAction(findChild<QAction*>(u"duplicateAction"_s));
        if (m_workspace.document().scenario().uavs.size() > 1) // the last one stays
            menu.addAction(findChild<QAction*>(u"deleteAction"_s));
        return;
    }
    const QString text = id == kAssetKey ? tr("Remove asset") : tr("Remove area");
    menu.addAction(text, this,
                   [this, id, text] {
                       m_workspace.document().edit(text, [&](Scenario& scenario) {
                           removeObjects(scenario, std::vector<std::string>{id});
                       });
                   })
        ->setEnabled(!locked);
}

void MainWindow::addWaterActions(QMenu& menu, const Point& position_m)
{
    const bool locked = m_workspace.inFlight();
    menu.addAction(tr("New iceberg here"), this,
                   [this, position_m] { m_map->addIcebergAt(position_m); });
    menu.addAction(tr("New UAV here"), this, [this, position_m] { m_map->addUavAt(position_m); })
        ->setEnabled(!locked);
    menu.addAction(findChild<QAction*>(u"windAction"_s));
    menu.addAction(findChild<QAction*>(u"generateAction"_s));
    menu.addAction(tr("Paste here"), this, [this, position_m] { m_map->pasteAt(position_m); })
        ->setEnabled(!locked);
}

} // namespace berg
