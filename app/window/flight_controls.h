#pragma once

#include "app/window/window_part.h"

#include <QTimer>

namespace berg {

/** Fly, pause, look back, stop, bring back: from playback bar, alarm strip and events to the
 * mission. */
class FlightControls : public WindowPart
{
    Q_OBJECT

public:
    explicit FlightControls(WindowContext& context);

    void togglePlay();
    void showGivenUp();

private:
    QTimer m_givenUpTimer; ///< until the strip says no more of a flight that was given up
};

} // namespace berg
