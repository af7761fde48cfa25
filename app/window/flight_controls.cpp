#include "app/window/flight_controls.h"

#include "app/window/panels.h"
#include "widgets/map/view/map_view.h"
#include "widgets/model/workspace.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/theme/mission_clock.h"

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

    connect(panels().alarms, &AlarmStrip::flyOnRequested, this, [this] {
        showMessage({}, 0); // that one is looking back
        workspace().flyOnFromHere();
    });
    connect(panels().alarms, &AlarmStrip::bringBackRequested, &workspace(),
            &Workspace::bringBackFlight);
    connect(&workspace(), &Workspace::givenUpChanged, this, &FlightControls::showGivenUp);
    m_givenUpTimer.setSingleShot(true);
    m_givenUpTimer.setInterval(kGivenUp_ms);
    connect(&m_givenUpTimer, &QTimer::timeout, this, [this] { panels().alarms->showGivenUp({}); });
    connect(panels().alarms, &AlarmStrip::newestRequested, &workspace(), &Workspace::seekLatest);
    connect(&workspace(), &Workspace::takeOffAhead, this, [this] {
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

/** A flight that was given up can be had again; the strip says so for a while. */
void FlightControls::showGivenUp()
{
    const std::optional<double> flown_s = workspace().givenUp_s();
    panels().alarms->showGivenUp(
        flown_s
            ? tr("Flight to %1 given up").arg(clockOf(workspace().record().scenario).text(*flown_s))
            : QString());
    if (flown_s)
        m_givenUpTimer.start();
}

} // namespace berg
