#pragma once

#include "app/window/window_part.h"

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

private:
    void connectMap(const Docks& docks);
    void connectTables();
    void showOverview();
};

} // namespace berg
