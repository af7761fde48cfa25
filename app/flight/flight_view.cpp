#include "app/flight/flight_view.h"

#include "app/flight/flight_panels.h"
#include "app/layout/panels.h"
#include "app/layout/status_line.h"
#include "widgets/map/picture/mission_picture.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/icebergs/iceberg_table.h"
#include "widgets/panels/inspector/inspector_panel.h"
#include "widgets/panels/plan/plan_panel.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/theme/announcer.h"
#include "widgets/workspace/workspace.h"

#include <QSettings>
#include <QUndoView>

#include <algorithm>
#include <iterator>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr const char* kTruthKey = "view/truth";

/** The words of the status bar for what the mission thread is doing. */
QString phaseText(RunPhase phase, const QString& fault)
{
    switch (phase) {
    case RunPhase::Planning:
        return FlightView::tr("Planning");
    case RunPhase::Ready:
        return FlightView::tr("Ready. Press Space to fly");
    case RunPhase::Flying:
        return FlightView::tr("Flying");
    case RunPhase::Paused:
        return FlightView::tr("Paused");
    case RunPhase::Finished:
        return FlightView::tr("Run complete");
    case RunPhase::Failed:
        return FlightView::tr("Cannot be planned: %1").arg(fault);
    }
    return {};
}

} // namespace

FlightView::FlightView(WindowContext& context, FlightPanels& flightPanels, StatusLine& status)
    : WindowPart(context)
    , m_flightPanels(flightPanels)
    , m_status(status)
    , m_truthShown(settings().value(kTruthKey, true).toBool())
{
    connect(&workspace(), &Workspace::flightChanged, this, &FlightView::showFlight);
    connect(&workspace(), &Workspace::inFlightChanged, this, &FlightView::setInFlight);
    connect(&workspace().document(), &ScenarioDocument::scenarioChanged, this,
            &FlightView::showFlight);
    connect(panels().alarms, &AlarmStrip::raised, this, &FlightView::announce);
    connect(&workspace().runs(), &RunList::comparisonChanged, this, &FlightView::showFlight);
}

void FlightView::showFlight()
{
    const FlightRecord& record = workspace().record();
    MapPicture picture = mapPicture(record, locale(), m_swept);
    if (!m_truthShown)
        hideTruth(picture);
    if (const RunPointer other = workspace().runs().otherIn(record.scenario))
        addComparison(picture, *other,
                      record.inFlight() ? record.shown().time_s : record.scenario.duration_s,
                      locale());
    picture.emptyHint = tr("Press I and click on the map to place an iceberg, drag to set its "
                           "drift, or import sightings.");
    panels().plan->setSigmaFull(picture.sigmaFull_m2);
    panels().icebergs->setSigmaFull(picture.sigmaFull_m2);
    panels().map->setPicture(std::move(picture));
    panels().map->setMayIntervene(workspace().mayIntervene());
    const MissionClock clock = clockOf(record.scenario);
    panels().playback->setClock(clock);
    panels().alarms->setClock(clock);
    const QString fault = planFault(workspace());
    const bool playing = workspace().isPlaying();
    if (!playing) // else at the pace of the tables
        m_flightPanels.showPlan();
    panels().playback->showState(playing          ? RunPhase::Flying
                                 : record.instant ? RunPhase::Paused
                                                  : record.now.phase,
                                 record.shown().time_s, record.scenario.duration_s,
                                 record.now.time_s);
    // The picture shown may belong to an instant next to the requested one.
    const std::optional<double> lookBack_s =
        record.instant ? std::optional(record.shown().time_s) : workspace().lookedAt_s();
    panels().alarms->showState(record.inFlight(), lookBack_s, fault);
    panels().tradeoff->setLookingBack(record.inFlight() && workspace().lookedAt_s().has_value());
    showNotices();
    showPhase(record.now.phase, fault);
    m_flightPanels.showSoon();
}

/** Worst first, those of aircraft before others of their rank. */
void FlightView::showNotices()
{
    std::vector<FlightNotice> notices = m_aircraftNotices;
    std::ranges::move(flightNotices(workspace().record(), locale()), std::back_inserter(notices));
    std::ranges::stable_sort(notices, {},
                             [](const FlightNotice& notice) { return rankOf(notice.kind); });
    panels().alarms->showNotices(notices);
}

void FlightView::setAircraftNotices(const std::vector<FlightNotice>& notices)
{
    if (notices == m_aircraftNotices)
        return;
    m_aircraftNotices = notices;
    showNotices();
}

/** Take-off, a pause and the end are heard, too; planning comes and goes with every edit. */
void FlightView::showPhase(RunPhase phase, const QString& fault)
{
    const QString text = phaseText(phase, fault);
    m_status.showState(text);
    if (text == m_phase)
        return;
    m_phase = text;
    if (phase != RunPhase::Planning && phase != RunPhase::Ready)
        panels().announcer->say(text);
}

void FlightView::setInFlight(bool inFlight)
{
    panels().map->setLocked(inFlight);
    panels().alarms->showState(inFlight, workspace().lookedAt_s(), planFault(workspace()));
    panels().inspector->setLocked(inFlight);
    panels().icebergs->showRecord(workspace().record());
    panels().history->setEnabled(!inFlight);
    panels().tradeoff->setInFlight(inFlight);
    if (inFlight)
        panels().map->tools().setKind(MapToolKind::Select);
}

void FlightView::setTruthShown(bool shown)
{
    settings().setValue(kTruthKey, shown);
    m_truthShown = shown;
    showFlight();
}

} // namespace berg
