// The context menu of the map: what can be done with what is under the cursor.

#include "app/main_window.h"
#include "widgets/map/map_view.h"
#include "widgets/model/scenario_edits.h"
#include "widgets/panels/inspector_panel.h"

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
        return;
    }
    if (isUav)
        return; // it stays
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
    menu.addAction(findChild<QAction*>(u"windAction"_s));
    menu.addAction(findChild<QAction*>(u"generateAction"_s));
    menu.addAction(tr("Paste here"), this, [this, position_m] { m_map->pasteAt(position_m); })
        ->setEnabled(!locked);
}

} // namespace berg
