#include "app/window/context_menus.h"

#include "app/layout/command.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/map/paint/map_layout.h"
#include "widgets/map/view/asset_size.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/theme/quantity_text.h"
#include "widgets/words/object_names.h"
#include "widgets/workspace/workspace.h"

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>
#include <array>
#include <memory>

using namespace Qt::StringLiterals;

namespace berg {

ContextMenus::ContextMenus(WindowContext& context, const Docks& docks)
    : WindowPart(context), m_docks(docks)
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

void ContextMenus::addCommands(QMenu& menu, std::initializer_list<const char*> ids) const
{
    for (const char* id : ids)
        menu.addAction(commandAction(window(), id));
}

void ContextMenus::showOnMap(const QPoint& globalPos, const Point& position_m,
                             const std::vector<std::string>& ids)
{
    QMenu* menu = makeMenu(u"mapMenu"_s);
    MapView& map = *panels().map;
    const std::optional<MapPanel> panel = map.panels().at(map.mapFromGlobal(globalPos));
    if (panel && ids.empty())
        addPanelActions(*menu, *panel);
    else if (ids.empty())
        addWaterActions(*menu, position_m);
    else
        addObjectActions(*menu, ids.front());
    menu->addSeparator();
    if (ids.size() > 1)
        addOthers(*menu, std::span(ids).subspan(1));
    if (!panel || !ids.empty())
        addPlaceActions(*menu, position_m);
    addCommands(*menu, {"selectAllAction", "fitAction", "followAction"});
    menu->popup(globalPos);
}

void ContextMenus::showOnPlan(const QPoint& globalPos, const std::string& id)
{
    QMenu* menu = makeMenu(u"planMenu"_s);
    addObjectActions(*menu, id);
    menu->popup(globalPos);
}

/** Adds a menu that assigns the selected icebergs to one of several UAVs. */
void ContextMenus::addHandOverActions(QMenu& menu, const std::string& id)
{
    const std::vector<Uav>& uavs = workspace().document().scenario().uavs;
    if (!areDistinguished(uavs))
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

/** In flight: those that the UAV is not under already. */
void ContextMenus::addOrders(QMenu& menu, const std::string& id)
{
    const FlightRecord& record = workspace().record();
    const auto row = std::ranges::find(record.scenario.uavs, id, &Uav::id);
    const auto uav = static_cast<std::size_t>(row - record.scenario.uavs.begin());
    const std::vector<UavState>& uavs = record.now.world.uavs;
    for (const auto& [order, command] : {std::pair(FlightOrder::None, "resumeAction"),
                                         {FlightOrder::ReturnNow, "returnAction"},
                                         {FlightOrder::HoldHere, "holdAction"}})
        if (uav < uavs.size() && uavs[uav].order != order)
            addCommands(menu, {command});
}

void ContextMenus::addObjectActions(QMenu& menu, const std::string& id)
{
    const bool locked = workspace().inFlight();
    const bool isUav = findById(workspace().document().scenario().uavs, id) != nullptr;
    const bool isIceberg = !isUav && id != kAssetKey && !isOutlineKey(id);
    menu.addAction(locked ? tr("Show in the inspector") : tr("Edit in the inspector"), this,
                   [this] { m_docks.openInspector(); });
    if (isIceberg) {
        addCommands(menu,
                    {"cutAction", "copyAction", "duplicateAction", "deleteAction", "seenAction"});
        return addHandOverActions(menu, id);
    }
    if (isUav) {
        if (locked)
            addOrders(menu, id);
        addCommands(menu, {"duplicateAction"});
        if (workspace().document().scenario().uavs.size() > 1) // the last one stays
            addCommands(menu, {"deleteAction"});
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

QString ContextMenus::nameOf(const std::string& id) const
{
    const Scenario& scenario = workspace().document().scenario();
    if (const Uav* uav = findById(scenario.uavs, id))
        return shownName(*uav);
    const std::vector<Iceberg>& icebergs =
        workspace().inFlight() ? workspace().record().now.icebergs : scenario.icebergs;
    const auto iceberg = std::ranges::find(icebergs, id, &Iceberg::id);
    return iceberg != icebergs.end() ? shownName(*iceberg)
           : id == kAssetKey         ? tr("Asset")
           : id == kAreaKey          ? tr("Area")
                                     : tr("No-fly area");
}

/** Adds a menu for each object below the pointer; an open menu selects its object. */
void ContextMenus::addOthers(QMenu& menu, std::span<const std::string> ids)
{
    constexpr std::size_t kMost = 8;
    const auto chosen = std::make_shared<bool>(false);
    connect(&menu, &QMenu::triggered, &menu, [chosen] { *chosen = true; });
    for (const std::string& id : ids.first(std::min(kMost, ids.size()))) {
        QMenu* other = menu.addMenu(nameOf(id).replace(u'&', u"&&"_s));
        addObjectActions(*other, id);
        connect(other, &QMenu::aboutToShow, this,
                [this, id] { workspace().selection().set({id}); });
        const auto goBack = [this, &menu, chosen, above = workspace().selection().ids()] {
            const QAction* active = menu.activeAction();
            const bool isInOther =
                active != nullptr && active->menu() != nullptr && active->menu()->isVisible();
            if (!*chosen && !isInOther)
                workspace().selection().set(above);
        };
        // Later: an entry that is chosen hides the menus before it is carried out.
        connect(other, &QMenu::aboutToHide, &menu, goBack, Qt::QueuedConnection);
    }
    menu.addSeparator();
}

/** Adds the actions for the place itself, which also work in flight. */
void ContextMenus::addPlaceActions(QMenu& menu, const Point& position_m)
{
    const LatLon place =
        LocalFrame(workspace().document().scenario().origin).toGeographic(position_m);
    constexpr int kDecimals = 3; // of the minutes: to two metres
    const QString text = placeText(place, kDecimals, locale());
    menu.addAction(tr("Copy coordinates: %1").arg(text), this, [this, text] {
        QApplication::clipboard()->setText(text);
        showMessage(tr("Copied %1").arg(text), kMessage_ms);
    });
    menu.addAction(tr("Centre the map here"), this,
                   [this, place] { panels().map->camera().centreOn(place); });
    menu.addAction(tr("Measure from here"), this,
                   [this, position_m] { panels().map->tools().measureFrom(position_m); });
    menu.addSeparator();
}

/** There, moved or new. */
void ContextMenus::placeAsset(const Point& position_m)
{
    if (workspace().inFlight()) {
        workspace().moveAsset(position_m);
        return;
    }
    const MapView& map = *panels().map;
    workspace().document().edit(tr("Place asset"), [&](Scenario& scenario) {
        Asset asset = scenario.asset.value_or(assetFor(map.view(), map.size()));
        asset.position_m = position_m;
        scenario.asset = asset;
    });
}

void ContextMenus::addPanelActions(QMenu& menu, MapPanel panel)
{
    constexpr std::array<const char*, kMapPanels> kCommands = {
        "legendPanelAction", "scalePanelAction", "northPanelAction", "windPanelAction",
        "titlePanelAction"};
    QAction* command = commandAction(window(), kCommands[static_cast<std::size_t>(panel)]);
    if (std::ranges::find(kFoldingPanels, panel) != kFoldingPanels.end())
        menu.addAction(panels().map->panels().isFolded(panel) ? tr("Unfold") : tr("Fold"), this,
                       [this, panel] { panels().map->panels().fold(panel); });
    menu.addAction(tr("Hide"), command, &QAction::trigger);
    if (panel == MapPanel::Legend)
        menu.addMenu(window().findChild<QMenu*>(u"sigmaEndMenu"_s));
}

void ContextMenus::addWaterActions(QMenu& menu, const Point& position_m)
{
    const bool locked = workspace().inFlight();
    menu.addAction(tr("New iceberg here"), this,
                   [this, position_m] { panels().map->edits().addIcebergAt(position_m); });
    menu.addAction(tr("New UAV here"), this,
                   [this, position_m] { panels().map->edits().addUavAt(position_m); })
        ->setEnabled(!locked);
    const bool hasAsset = workspace().record().now.asset.has_value();
    menu.addAction(tr("Asset here"), this, [this, position_m] { placeAsset(position_m); })
        ->setEnabled(!locked || (hasAsset && workspace().mayIntervene()));
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
    addCommands(menu, {"windAction", "generateAction"});
    menu.addAction(tr("Paste here"), this,
                   [this, position_m] { panels().map->edits().pasteAt(position_m); })
        ->setEnabled(!locked);
}

} // namespace berg
