#pragma once

#include "app/window/window_part.h"
#include "core/base/geodesy.h"

namespace berg {

class ScenarioFiles;

/** Dialogs that change the scenario: wind, origin, random icebergs; and going to a place. */
class ScenarioDialogs : public WindowPart
{
    Q_OBJECT

public:
    ScenarioDialogs(WindowContext& context, ScenarioFiles& files);

    void generateIcebergs();
    void askWind();
    void openGoto();
    void moveScenario(const LatLon& suggested);

private:
    void showPlace(const LatLon& place, const QString& name);

    ScenarioFiles& m_files;
};

} // namespace berg
