#pragma once

#include "app/layout/window_part.h"
#include "core/scenario/scenario.h"

#include <optional>

namespace berg {

class Docks;
class ScenarioFiles;
struct StudySetting;

/** Flights of a study on the map, alone or two set beside each other. */
class StudyFlights : public WindowPart
{
    Q_OBJECT

public:
    StudyFlights(WindowContext& context, ScenarioFiles& files, const Docks& docks);

    /** Takes over the waiting work of another window. */
    void takeOver(StudyFlights& other) { m_compared = std::move(other.m_compared); }

private:
    void use(const StudySetting& setting);
    /** Two flights to be set beside each other when both have ended. */
    struct ComparedPair
    {
        Scenario world;
        PlannerSettings reference;
        PlannerSettings other;
    };

    [[nodiscard]] bool flyOnMap(const Scenario& scenario, const QString& text);
    void compareFlights(const Scenario& scenario, const PlannerSettings& best,
                        const PlannerSettings& tsp);
    void finishComparison();

    ScenarioFiles& m_files;
    const Docks& m_docks;
    std::optional<ComparedPair> m_compared; ///< waits until both flights have ended
};

} // namespace berg
