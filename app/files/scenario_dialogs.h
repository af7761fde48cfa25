#pragma once

#include "app/layout/window_part.h"
#include "core/earth/geodesy.h"
#include "widgets/places/find_matches.h"

namespace berg {

class Docks;
class ScenarioFiles;
class StartPageController;

/** Dialogs that change the scenario: wind, origin, random icebergs; and what is found by its name.
 */
class ScenarioDialogs : public WindowPart
{
    Q_OBJECT

public:
    ScenarioDialogs(WindowContext& context, ScenarioFiles& files, const Docks& docks,
                    const StartPageController& start);

    /** After the question about unsaved changes; then asks where. */
    void newScenario();
    void generateIcebergs();
    void askWind();
    /** Shows the scenario's forecast, and sets another or none. */
    void askForecast();
    /** The box that finds everything; it may ask where a new scenario is. */
    void openFind(bool asksWhere = false);
    void moveScenario(const LatLon& suggested);

private:
    [[nodiscard]] std::vector<FindItem> commands() const;
    [[nodiscard]] std::vector<FindItem> fields() const;
    void showObject(const std::string& id);
    void setFavourite(const QString& key, bool isFavourite);
    void placeNewScenario(const LatLon& origin);
    void showPlace(const LatLon& place, const QString& name);

    ScenarioFiles& m_files;
};

} // namespace berg
