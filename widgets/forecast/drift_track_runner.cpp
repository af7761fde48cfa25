#include "widgets/forecast/drift_track_runner.h"

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kTrackPause_ms = 200;

/** Returns the scenario without what the drift of icebergs does not depend on. */
Scenario driftOnly(const Scenario& scenario)
{
    Scenario reduced;
    reduced.origin = scenario.origin;
    reduced.startUtc = scenario.startUtc;
    reduced.wind_mps = scenario.wind_mps;
    reduced.current_mps = scenario.current_mps;
    reduced.forecast = scenario.forecast;
    reduced.icebergs = scenario.icebergs;
    return reduced;
}

} // namespace

DriftTrackRunner::DriftTrackRunner(QObject* parent)
    : QObject(parent)
    , m_task(u"drift"_s,
             {.work =
                  [](const Request& request, const std::stop_token& stop, const auto& deliver) {
                      deliver(std::make_shared<const std::vector<DriftTrack>>(
                          driftTracks(request.scenario, {.every_s = request.every_s}, stop)));
                  },
              .deliver = [this](Tracks tracks) { setTracks(std::move(tracks)); }},
             WorkPriority::Low)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kTrackPause_ms);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_request)
            m_task.start(*m_request);
    });
}

void DriftTrackRunner::setScenario(const Scenario& scenario, double every_s)
{
    Request request{.scenario = driftOnly(scenario), .every_s = every_s};
    if (m_request == request)
        return;
    m_request = std::move(request);
    m_task.drop();
    setTracks(nullptr);
    m_pause.start();
}

void DriftTrackRunner::clear()
{
    m_request.reset();
    m_pause.stop();
    m_task.drop();
    setTracks(nullptr);
}

void DriftTrackRunner::setTracks(Tracks tracks)
{
    if (tracks == m_tracks)
        return;
    m_tracks = std::move(tracks);
    emit updated();
}

} // namespace berg
