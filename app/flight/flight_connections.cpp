#include "app/flight/flight_connections.h"

#include "app/flight/flight_view.h"
#include "app/layout/panels.h"
#include "widgets/charts/pareto_chart.h"
#include "widgets/map/view/map_view.h"
#include "widgets/panels/flight/alarm_strip.h"
#include "widgets/panels/flight/event_panel.h"
#include "widgets/panels/flight/playback_bar.h"
#include "widgets/panels/plan/tradeoff_panel.h"
#include "widgets/theme/mission_clock.h"
#include "widgets/workspace/workspace.h"

#include <QSettings>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr const char* kDetailsKey = "view/planDetails";
constexpr int kGivenUp_ms = 20'000; ///< then the menu still has it

} // namespace

void connectPlanner(WindowContext& context)
{
    Workspace& w = context.workspace;
    TradeoffPanel* tradeoff = context.panels.tradeoff;
    ParetoChart* pareto = context.panels.pareto;
    QSettings& settings = context.settings;
    tradeoff->setDetailsShown(settings.value(kDetailsKey, false).toBool());
    context.on(tradeoff, &TradeoffPanel::detailsToggled,
               [&settings](bool isShown) { settings.setValue(kDetailsKey, isShown); });
    QObject::connect(tradeoff, &TradeoffPanel::tauEdited, &w, &Workspace::setTau);
    QObject::connect(tradeoff, &TradeoffPanel::tauEditFinished, &w.document(),
                     &ScenarioDocument::endGesture);
    QObject::connect(tradeoff, &TradeoffPanel::policyEdited, &w, &Workspace::setPolicy);
    QObject::connect(tradeoff, &TradeoffPanel::backendEdited, &w, &Workspace::setBackend);
    QObject::connect(tradeoff, &TradeoffPanel::routeEdited, &w, &Workspace::setRoute);
    QObject::connect(pareto, &ParetoChart::tauChosen, tradeoff, &TradeoffPanel::chooseTau);

    const auto showPlanner = [&w, tradeoff, pareto] {
        tradeoff->showSettings(w.planner());
        pareto->setTau(w.planner().tau);
    };
    const auto showCurve = [&w, tradeoff, pareto] {
        tradeoff->showCurve(w.curve().curve());
        pareto->setCurve(w.curve().curve());
    };
    const auto showForecasts = [&w, tradeoff] {
        tradeoff->showForecasts(w.forecasts().forecasts());
    };
    context.on(&w.forecasts(), &PolicyForecasts::updated, showForecasts);
    context.on(&w.curve(), &CurveRunner::updated, showCurve);
    context.on(&w.document(), &ScenarioDocument::scenarioChanged, showPlanner);
    context.on(&w, &Workspace::inFlightChanged, showPlanner);
    context.on(&w, &Workspace::refused,
               [tradeoff, showPlanner] { // what was refused is not in force
                   tradeoff->finishTau();
                   showPlanner();
               });
    context.on(&w, &Workspace::flightChanged, [&w, showPlanner] {
        if (w.inFlight())
            showPlanner();
    });
    showPlanner();
    showCurve();
    showForecasts();
}

void connectPlayback(WindowContext& context)
{
    Workspace& w = context.workspace;
    const Panels& panels = context.panels;
    const PlaybackBar* playback = panels.playback;
    AlarmStrip* alarms = panels.alarms;
    context.on(playback, &PlaybackBar::playRequested, [&context] { togglePlay(context); });
    QObject::connect(playback, &PlaybackBar::pauseRequested, &w, &Workspace::pause);
    QObject::connect(playback, &PlaybackBar::stepRequested, &w, &Workspace::step);
    QObject::connect(playback, &PlaybackBar::resetRequested, &w, &Workspace::reset);
    QObject::connect(playback, &PlaybackBar::rateEdited, &w, &Workspace::setRate);
    QObject::connect(playback, &PlaybackBar::timeEdited, &w, &Workspace::seek);
    QObject::connect(panels.events, &EventPanel::timeChosen, &w, &Workspace::seek);
    context.on(alarms, &AlarmStrip::continueRequested, [&context] {
        showMessage(context, {}, 0); // that one is looking back
        context.workspace.continueFromHere();
    });
    QObject::connect(alarms, &AlarmStrip::restoreRequested, &w, &Workspace::restoreFlight);
    QObject::connect(alarms, &AlarmStrip::newestRequested, &w, &Workspace::seekLatest);
    context.on(&w, &Workspace::aboutToTakeOff, [&panels] {
        panels.map->tools().cancel();
        panels.finishTyping();
    });

    // A discarded flight can be restored; the strip says so for a while.
    auto* hide = new QTimer(&context.life);
    hide->setSingleShot(true);
    hide->setInterval(kGivenUp_ms);
    context.on(hide, &QTimer::timeout, [alarms] { alarms->showDiscardedFlight({}); });
    const auto showDiscarded = [&w, alarms, hide] {
        const std::optional<double> flown_s = w.discardedFlight_s();
        alarms->showDiscardedFlight(flown_s ? FlightView::tr("Flight to %1 discarded")
                                                  .arg(clockOf(w.record().scenario).text(*flown_s))
                                            : QString());
        if (flown_s)
            hide->start();
    };
    context.on(&w, &Workspace::discardedFlightChanged, showDiscarded);
}

void togglePlay(const WindowContext& context)
{
    Workspace& w = context.workspace;
    if (w.isPlaying())
        return w.pause();
    const RunPhase phase = w.record().now.phase;
    const bool looksBack = w.lookedAt_s().has_value();
    if (!looksBack && phase == RunPhase::Planning)
        return showMessage(context, FlightView::tr("The plan is still being made."), kMessage_ms);
    if (!looksBack && phase == RunPhase::Finished)
        w.reset();
    w.fly(context.panels.playback->rate());
}

} // namespace berg
