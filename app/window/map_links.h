#pragma once

#include "app/window/window_part.h"
#include "widgets/map/paint/map_overlays.h"

namespace berg {

class Docks;

/** What the map and the tables round it tell each other and the workspace; the overview. */
class MapLinks : public WindowPart
{
    Q_OBJECT

public:
    MapLinks(WindowContext& context, const Docks& docks);

    [[nodiscard]] bool overviewIsShown() const;
    void setOverviewShown(bool shown);
    [[nodiscard]] bool panelIsShown(MapPanel panel) const;
    void setPanelShown(MapPanel panel, bool shown);

private:
    void connectMap(const Docks& docks);
    void connectTables();
    void showOverview();
    void savePanels();
    [[nodiscard]] MapLayers savedLayers() const;
    [[nodiscard]] MapPanelStates savedPanels() const;
};

} // namespace berg
