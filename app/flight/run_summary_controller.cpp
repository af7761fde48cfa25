#include "app/flight/run_summary_controller.h"

#include "app/files/result_files.h"
#include "app/layout/docks.h"
#include "app/layout/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/flight_card.h"
#include "widgets/workspace/workspace.h"

#include <utility>

namespace berg {

RunSummaryController::RunSummaryController(WindowContext& context, const Docks& docks,
                                           ResultFiles& results)
    : WindowPart(context), m_card(new FlightCard(panels().map))
{
    connect(&workspace(), &Workspace::flightChanged, this, &RunSummaryController::showEnd);
    const auto updateSummary = [this] {
        if (!m_card->isHidden())
            showSummary();
    };
    connect(&workspace().forecasts(), &PolicyForecasts::updated, this, updateSummary);
    connect(&workspace().bound(), &BoundRunner::updated, this, updateSummary);
    connect(m_card, &FlightCard::closed, this, [this] { m_isClosed = true; });
    connect(m_card, &FlightCard::compareRequested, this,
            [&docks] { docks.raise(Dock::Comparison); });
    connect(m_card, &FlightCard::saveRequested, this, [&results] { results.saveRun(); });
    connect(m_card, &FlightCard::reportRequested, this,
            [&results] { results.chooseExport("log"); });
    showEnd();
}

void RunSummaryController::setTheme(const Theme& theme)
{
    m_card->setTheme(theme);
}

void RunSummaryController::takeOver(const RunSummaryController& other)
{
    m_isClosed = other.m_isClosed;
    showEnd();
}

/** While the end of a run is shown, until it is closed. */
void RunSummaryController::showEnd()
{
    const bool isFinished = workspace().record().now.phase == RunPhase::Finished;
    const bool isOther = std::exchange(m_generation, workspace().record().now.generation) !=
                         workspace().record().now.generation;
    m_isClosed = m_isClosed && isFinished && !isOther;
    if (!isFinished || m_isClosed || workspace().lookedAt_s())
        m_card->hide();
    else if (m_card->isHidden() || isOther)
        showSummary();
}

/** Again when more is known of what the run is set against. */
void RunSummaryController::showSummary()
{
    m_card->showSummary(flightSummary(workspace().record(), workspace().predicted()));
}

} // namespace berg
