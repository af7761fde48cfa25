#pragma once

#include "app/layout/window_part.h"
#include "core/geometry/geometry.h"
#include "widgets/map/paint/map_overlays.h"

#include <span>
#include <string>
#include <vector>

class QMenu;

namespace berg {

class Docks;

/** The context menus of map and plan: what can be done with what is under the cursor. */
class ContextMenus : public WindowPart
{
    Q_OBJECT

public:
    ContextMenus(WindowContext& context, const Docks& docks);

private:
    [[nodiscard]] QMenu* makeMenu(const QString& name) const;
    void addCommands(QMenu& menu, std::initializer_list<const char*> ids) const;
    void showOnMap(const QPoint& globalPos, const Point& position_m,
                   const std::vector<std::string>& ids);
    void showOnPlan(const QPoint& globalPos, const std::string& id);
    void addHandOverActions(QMenu& menu, const std::string& id);
    void addOrders(QMenu& menu, const std::string& id);
    void addObjectActions(QMenu& menu, const std::string& id);
    [[nodiscard]] QString nameOf(const std::string& id) const;
    void addOthers(QMenu& menu, std::span<const std::string> ids);
    void addPlaceActions(QMenu& menu, const Point& position_m);
    void placeAsset(const Point& position_m);
    void addPanelActions(QMenu& menu, MapPanel panel);
    void addWaterActions(QMenu& menu, const Point& position_m);

    const Docks& m_docks;
};

} // namespace berg
