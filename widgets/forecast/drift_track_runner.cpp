#include "widgets/forecast/drift_track_runner.h"

#include <utility>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kTrackPause_ms = 200;

/** Returns the scenario without what the drift does not depend on, and without icebergs. */
Scenario driftOnly(const Scenario& scenario)
{
    Scenario reduced;
    reduced.origin = scenario.origin;
    reduced.startUtc = scenario.startUtc;
    reduced.wind_mps = scenario.wind_mps;
    reduced.current_mps = scenario.current_mps;
    reduced.forecast = scenario.forecast;
    return reduced;
}

std::vector<DriftTrack> tracksOf(const Scenario& scenario,
                                 const std::optional<DriftInstant>& instant, double every_s,
                                 const std::stop_token& stop)
{
    const DriftTrackSpec spec{.every_s = every_s};
    return instant ? driftTracks(scenario, *instant, spec, stop)
                   : driftTracks(scenario, spec, stop);
}

} // namespace

DriftTrackRunner::DriftTrackRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"drift"_s,
             {.work =
                  [](const Request& request, const std::stop_token& stop, const auto& deliver) {
                      deliver(std::make_shared<const std::vector<DriftTrack>>(
                          tracksOf(request.scenario, request.instant, request.every_s, stop)));
                  },
              .deliver = [this](Tracks tracks) { setTracks(std::move(tracks)); },
              .end =
                  [this](const auto&) {
                      m_isRunning = false;
                      if (m_isStale)
                          start();
                  }},
             WorkPriority::Low)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kTrackPause_ms);
    connect(&m_pause, &QTimer::timeout, this, &DriftTrackRunner::start);
}

void DriftTrackRunner::setScenario(const Scenario& scenario, double every_s)
{
    Request request{.scenario = driftOnly(scenario), .instant = {}, .every_s = every_s};
    request.scenario.icebergs = scenario.icebergs;
    if (m_request == request)
        return;
    drop();
    m_request = std::move(request);
    setTracks(nullptr);
    m_pause.start();
}

void DriftTrackRunner::setInstant(const Scenario& scenario, DriftInstant instant, double every_s)
{
    Request request{
        .scenario = driftOnly(scenario), .instant = std::move(instant), .every_s = every_s};
    request.scenario.observer = scenario.observer;
    if (m_request == request)
        return;
    m_request = std::move(request);
    m_pause.stop();
    if (m_isRunning)
        m_isStale = true;
    else
        start();
}

void DriftTrackRunner::clear()
{
    drop();
    setTracks(nullptr);
}

void DriftTrackRunner::start()
{
    if (!m_request)
        return;
    m_isRunning = true;
    m_isStale = false;
    m_task.start(*m_request);
}

void DriftTrackRunner::drop()
{
    m_request.reset();
    m_pause.stop();
    m_task.drop();
    m_isRunning = false;
    m_isStale = false;
}

void DriftTrackRunner::setTracks(Tracks tracks)
{
    if (tracks == m_tracks)
        return;
    m_tracks = std::move(tracks);
    emit updated();
}

} // namespace berg
