#pragma once

#include "app/layout/window_part.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/panels/flight/flight_notices.h"

namespace berg {

class FlightPanels;
class StatusLine;

/** The flight, or the plan before it, on the map and in what stands round it. */
class FlightView : public WindowPart
{
    Q_OBJECT

public:
    FlightView(WindowContext& context, FlightPanels& flightPanels, StatusLine& status);

    void showFlight();
    void setInFlight(bool inFlight);
    [[nodiscard]] bool truthIsShown() const { return m_truthShown; }
    /** True positions. */
    void setTruthShown(bool shown);
    /** Shows notices about real aircraft among those of the flight. */
    void setAircraftNotices(const std::vector<FlightNotice>& notices);

private:
    void showNotices();
    void showPhase(RunPhase phase, const QString& fault);

    FlightPanels& m_flightPanels;
    StatusLine& m_status;
    std::vector<FlightNotice> m_aircraftNotices;
    SweptPaths m_swept;
    QString m_phase; ///< as announced last
    bool m_truthShown;
};

} // namespace berg
