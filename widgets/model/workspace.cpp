#include "widgets/model/workspace.h"

using namespace Qt::StringLiterals;

namespace berg {

Workspace::Workspace(QObject* parent) : QObject(parent)
{
    connect(&m_document, &ScenarioDocument::scenarioChanged, this, &Workspace::planAgain);
    connect(&m_document, &ScenarioDocument::replaced, &m_selection, &Selection::clear);
    connect(&m_runner, &MissionRunner::updated, this, &Workspace::takeSnapshot);
    connect(&m_runner, &MissionRunner::commandRefused, this, &Workspace::refused);
}

const PlannerSettings& Workspace::planner() const
{
    return inFlight() ? m_record.now.planner : m_document.scenario().planner;
}

void Workspace::planAgain()
{
    m_selection.keepExisting(m_document.scenario());
    const bool wasInFlight = inFlight();
    m_record.scenario = m_document.scenario();
    m_runner.setScenario(m_document.scenario());
    if (wasInFlight) { // another scenario was opened over the flight
        m_record.begin(m_document.scenario());
        emit inFlightChanged(false);
        emit flightChanged();
    }
}

void Workspace::takeSnapshot()
{
    std::optional<MissionSnapshot> snapshot = m_runner.takeSnapshot();
    if (!snapshot)
        return;
    const bool wasInFlight = inFlight();
    m_record.take(std::move(*snapshot));
    if (inFlight() != wasInFlight)
        emit inFlightChanged(inFlight());
    emit flightChanged();
}

void Workspace::setPlanner(const QString& text, const std::function<void(PlannerSettings&)>& change,
                           const QString& gesture)
{
    m_document.edit(
        text, [&change](Scenario& scenario) { change(scenario.planner); }, gesture);
}

void Workspace::setTau(double tau)
{
    if (inFlight())
        m_runner.intervene({.tau = tau});
    else
        setPlanner(
            tr("Change trade-off"), [tau](PlannerSettings& planner) { planner.tau = tau; },
            u"tau"_s);
}

void Workspace::setPolicy(PolicyKind policy)
{
    if (inFlight())
        m_runner.intervene({.policy = policy});
    else
        setPlanner(tr("Change policy"),
                   [policy](PlannerSettings& planner) { planner.policy = policy; });
}

void Workspace::setBackend(Backend backend)
{
    setPlanner(tr("Change solver"),
               [backend](PlannerSettings& planner) { planner.backend = backend; });
}

void Workspace::setRoute(Route route)
{
    setPlanner(tr("Change route"), [route](PlannerSettings& planner) { planner.route = route; });
}

void Workspace::fly(double rate)
{
    m_runner.fly(rate);
}

void Workspace::setRate(double rate)
{
    if (m_record.now.phase == RunPhase::Flying)
        m_runner.fly(rate);
}

void Workspace::pause()
{
    m_runner.pause();
}

void Workspace::step()
{
    m_runner.stepBy(1);
}

void Workspace::reset()
{
    const bool wasInFlight = inFlight();
    m_record.begin(m_document.scenario());
    m_runner.restart();
    if (wasInFlight)
        emit inFlightChanged(false);
    emit flightChanged();
}

} // namespace berg
