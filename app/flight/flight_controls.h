#pragma once

#include "app/layout/window_part.h"

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
    void showDiscardedFlight();

private:
    QTimer m_discardedTimer; ///< hides the strip's line about a discarded flight
};

} // namespace berg
