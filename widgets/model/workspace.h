#pragma once

#include "widgets/model/flight_record.h"
#include "widgets/model/mission_runner.h"
#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"

#include <QObject>

namespace berg {

/**
 * What one window works on: the scenario, what is selected, and the mission planned or flown from
 * it. Decides whether a change is an edit (before take-off) or an intervention (in flight). It
 * outlives the window, which is made anew when the language changes. GUI thread.
 */
class Workspace : public QObject
{
    Q_OBJECT

public:
    explicit Workspace(QObject* parent = nullptr);

    [[nodiscard]] ScenarioDocument& document() { return m_document; }
    [[nodiscard]] Selection& selection() { return m_selection; }
    [[nodiscard]] MissionRunner& runner() { return m_runner; }
    [[nodiscard]] const FlightRecord& record() const { return m_record; }
    [[nodiscard]] bool inFlight() const { return m_record.inFlight(); }
    /** In force: the document's, or in flight those of the mission. */
    [[nodiscard]] const PlannerSettings& planner() const;

    void setTau(double tau);
    void setPolicy(PolicyKind policy);
    void setBackend(Backend backend);
    void setRoute(Route route);

    /** Takes off, or carries on. `rate` simulated seconds a second, 0: as fast as possible. */
    void fly(double rate);
    void pause();
    void step();
    /** Ends the flight: back to the start, where everything can be edited again. */
    void reset();
    /** A new rate for a flight under way. */
    void setRate(double rate);

signals:
    /** `record()` is new. */
    void flightChanged();
    /** Take-off or reset: what may be edited has changed. */
    void inFlightChanged(bool inFlight);
    void refused(const QString& message);

private:
    void planAgain();
    void takeSnapshot();
    void setPlanner(const QString& text, const std::function<void(PlannerSettings&)>& change,
                    const QString& gesture = {});

    ScenarioDocument m_document;
    Selection m_selection;
    FlightRecord m_record;
    MissionRunner m_runner; ///< last: its thread ends before the rest
};

} // namespace berg
