#include "app/study/study_flights.h"

#include "app/files/scenario_files.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/panels/study/study_panel.h"
#include "widgets/panels/study/study_results.h"
#include "widgets/words/policy_words.h"
#include "widgets/workspace/workspace.h"

#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

/** The run of the world flown with these settings from start to end. */
std::optional<std::size_t> findRun(const RunList& list, const Scenario& world,
                                   const PlannerSettings& planner)
{
    const std::vector<RunPointer>& runs = list.runs();
    const auto found = std::find_if(runs.rbegin(), runs.rend(), [&](const RunPointer& run) {
        return !run->wasChanged && run->flown_s >= world.duration_s && run->worldChanges.empty() &&
               isSamePlanner(run->scenario.planner, planner) && isSameWorld(run->scenario, world);
    });
    if (found == runs.rend())
        return std::nullopt;
    return static_cast<std::size_t>(runs.rend() - found) - 1;
}

} // namespace

StudyFlights::StudyFlights(WindowContext& context, ScenarioFiles& files, const Docks& docks)
    : WindowPart(context), m_files(files), m_docks(docks)
{
    const StudyPanel* panel = panels().study;
    connect(&panel->results(), &StudyResults::openRunRequested, this,
            [this](const Scenario& scenario) {
                if (flyOnMap(scenario, tr("Fly as in the study")))
                    showMessage(tr("Flown as in the study, which is under View, Study."),
                                kLongMessage_ms);
            });
    connect(&panel->results(), &StudyResults::settingRequested, this, &StudyFlights::use);
    connect(panel, &StudyPanel::comparisonRequested, this, &StudyFlights::compareFlights);
    connect(&workspace().runs(), &RunList::changed, this, &StudyFlights::finishComparison);
}

/** False: the user does not want to give up what is unsaved, or the flight under way. */
bool StudyFlights::flyOnMap(const Scenario& scenario, const QString& text)
{
    panels().finishTyping();
    if (!(workspace().isVariant(scenario) ? m_files.mayEndFlight()
                                          : m_files.confirmDiscardScenario()))
        return false;
    workspace().flyScenario(scenario, text);
    if (auto* dock = m_docks.dock(Dock::Study); dock->isFloating())
        dock->hide(); // it is over the map
    window().activateWindow();
    return true;
}

/** Sends the setting to the flight, if there is one. */
void StudyFlights::use(const StudySetting& setting)
{
    const QString text = tr("Use %1").arg(settingText(setting, locale()));
    if (workspace().inFlight()) {
        workspace().setPolicy(setting.policy);
        if (setting.tau)
            workspace().setTau(*setting.tau);
        if (!workspace().mayIntervene())
            return; // the message is already shown
    } else {
        workspace().document().edit(text, [&](Scenario& scenario) {
            scenario.planner.policy = setting.policy;
            scenario.planner.tau = setting.tau.value_or(scenario.planner.tau);
        });
    }
    showMessage(tr("Planned with %1").arg(settingText(setting, locale())), kMessage_ms);
}

/** Figure 5 of the paper: the one is flown on the map, the other beside it. */
void StudyFlights::compareFlights(const Scenario& scenario, const PlannerSettings& best,
                                  const PlannerSettings& tsp)
{
    Scenario first = scenario;
    first.planner = best;
    if (!flyOnMap(first, tr("Fly Figure 5 of the paper")))
        return;
    m_compared = ComparedPair{.world = first, .reference = best, .other = tsp};
    workspace().runs().addFlown(first, tsp);
    m_docks.raise(Dock::Comparison);
    m_docks.raise(Dock::ComparisonChart);
}

/** Sets the two flights beside each other once both have ended. */
void StudyFlights::finishComparison()
{
    if (!m_compared)
        return;
    RunList& runs = workspace().runs();
    const std::optional<std::size_t> reference =
        findRun(runs, m_compared->world, m_compared->reference);
    const std::optional<std::size_t> other = findRun(runs, m_compared->world, m_compared->other);
    if (!reference || !other)
        return;
    m_compared.reset();
    runs.setReference(*reference);
    runs.setOther(*other);
}

} // namespace berg
