#include "app/flight/flight_controls.h"

#include "app/layout/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/workspace/workspace.h"

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kGivenUp_ms = 20'000; ///< then the menu still has it

} // namespace

FlightControls::FlightControls(WindowContext& context) : WindowPart(context)
{
    connect(panels().playback, &PlaybackBar::playRequested, this, &FlightControls::togglePlay);
    connect(panels().playback, &PlaybackBar::pauseRequested, &workspace(), &Workspace::pause);
    connect(panels().playback, &PlaybackBar::stepRequested, &workspace(), &Workspace::step);
    connect(panels().playback, &PlaybackBar::resetRequested, &workspace(), &Workspace::reset);
    connect(panels().playback, &PlaybackBar::rateEdited, &workspace(), &Workspace::setRate);
    connect(panels().playback, &PlaybackBar::timeEdited, &workspace(), &Workspace::seek);
    connect(panels().events, &EventPanel::timeChosen, &workspace(), &Workspace::seek);

    connect(panels().alarms, &AlarmStrip::continueRequested, this, [this] {
        showMessage({}, 0); // that one is looking back
        workspace().continueFromHere();
    });
    connect(panels().alarms, &AlarmStrip::restoreRequested, &workspace(),
            &Workspace::restoreFlight);
    connect(&workspace(), &Workspace::discardedFlightChanged, this,
            &FlightControls::showDiscardedFlight);
    m_discardedTimer.setSingleShot(true);
    m_discardedTimer.setInterval(kGivenUp_ms);
    connect(&m_discardedTimer, &QTimer::timeout, this,
            [this] { panels().alarms->showDiscardedFlight({}); });
    connect(panels().alarms, &AlarmStrip::newestRequested, &workspace(), &Workspace::seekLatest);
    connect(&workspace(), &Workspace::aboutToTakeOff, this, [this] {
        panels().map->cancelGesture();
        panels().finishTyping();
    });
}

void FlightControls::togglePlay()
{
    if (workspace().isPlaying()) {
        workspace().pause();
        return;
    }
    const RunPhase phase = workspace().record().now.phase;
    const bool looksBack = workspace().lookedAt_s().has_value();
    if (!looksBack && phase == RunPhase::Planning) {
        showMessage(tr("The plan is still being made."), kMessage_ms);
        return;
    }
    if (!looksBack && phase == RunPhase::Finished)
        workspace().reset();
    workspace().fly(panels().playback->rate());
}

/** A discarded flight can be restored; the strip says so for a while. */
void FlightControls::showDiscardedFlight()
{
    const std::optional<double> flown_s = workspace().discardedFlight_s();
    panels().alarms->showDiscardedFlight(
        flown_s ? tr("Flight to %1 discarded")
                      .arg(clockOf(workspace().record().scenario).text(*flown_s))
                : QString());
    if (flown_s)
        m_discardedTimer.start();
}

} // namespace berg
