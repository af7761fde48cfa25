#include "app/window/map_links.h"

#include "app/window/docks.h"
#include "app/window/panels.h"
#include "widgets/map/paint/overview_inset.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/plan/plan_panel.h"

#include <QSettings>

namespace berg {

namespace {

constexpr const char* kOverviewKey = "view/overview";
constexpr const char* kHiddenColumnsKey = "icebergs/hiddenColumns";

} // namespace

MapLinks::MapLinks(WindowContext& context, const Docks& docks) : WindowPart(context)
{
    panels().map->setInset(overviewIsShown() ? panels().overview : nullptr);
    panels().icebergs->setHiddenColumns(settings().value(kHiddenColumnsKey).toStringList());
    connectMap(docks);
    connectTables();
}

void MapLinks::connectMap(const Docks& docks)
{
    const MapView* map = panels().map;
    connect(map, &MapView::outlineChanged, this, &MapLinks::showOverview);
    connect(panels().overview, &OverviewInset::placePicked, map, &MapView::centreOn);
    connect(map, &MapView::windEdited, &workspace(), &Workspace::setWind);
    connect(map, &MapView::assetMoved, &workspace(), &Workspace::moveAsset);
    connect(map, &MapView::icebergPlaced, &workspace(), &Workspace::addIceberg);
    connect(panels().alarms, &AlarmStrip::noticeChosen, this,
            [this](const std::vector<std::string>& about) {
                workspace().selection().set(about);
                panels().map->showObjects(about);
            });
    connect(map, &MapView::editRequested, &docks, &Docks::openInspector);
}

void MapLinks::connectTables()
{
    MapView* map = panels().map;
    const auto select = [this](const std::string& id) { workspace().selection().set({id}); };
    PlanPanel* plan = panels().plan;
    connect(&workspace().selection(), &Selection::changed, plan,
            [this, plan] { plan->showSelection(workspace().selection().ids()); });
    connect(plan, &PlanPanel::hovered, map, &MapView::setHighlight);
    connect(map, &MapView::hovered, plan, &PlanPanel::setHighlight);
    connect(plan, &PlanPanel::activated, this, select);
    connect(plan, &PlanPanel::handedOver, this,
            [this](const std::string& iceberg, const std::string& uav) {
                workspace().assign({iceberg}, uav);
            });
    const IcebergTable* icebergs = panels().icebergs;
    connect(icebergs, &IcebergTable::hovered, map, &MapView::setHighlight);
    connect(map, &MapView::hovered, icebergs, &IcebergTable::setHighlight);
    connect(icebergs, &IcebergTable::chosen, this, [map, select](const std::string& id) {
        select(id);
        map->showIceberg(id);
    });
    connect(icebergs, &IcebergTable::mapPasteRequested, map, &MapView::paste);
    connect(icebergs, &IcebergTable::hiddenColumnsChanged, this,
            [this](const QStringList& keys) { settings().setValue(kHiddenColumnsKey, keys); });
}

bool MapLinks::overviewIsShown() const
{
    return settings().value(kOverviewKey, false).toBool();
}

void MapLinks::setOverviewShown(bool shown)
{
    settings().setValue(kOverviewKey, shown);
    panels().map->setInset(shown ? panels().overview : nullptr);
    showOverview();
}

void MapLinks::showOverview()
{
    if (!panels().map->hasInset())
        return;
    panels().overview->setPlace(workspace().document().scenario().origin);
    panels().overview->setExtent(panels().map->outline());
}

} // namespace berg
