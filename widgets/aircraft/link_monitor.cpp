#include "widgets/aircraft/link_monitor.h"

#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kPulse_ms = 500;
constexpr std::size_t kMostPlaces = 5000;
constexpr double kTrackStep_m = 5; ///< hardly a pixel on a map of a flight

} // namespace

LinkMonitor::LinkMonitor(QObject* parent) : QObject(parent), m_worker(new LinkWorker(m_statuses))
{
    m_thread.setObjectName(u"link"_s);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_worker, &LinkWorker::published, this, &LinkMonitor::accept);
    m_pulse.setInterval(kPulse_ms);
    connect(&m_pulse, &QTimer::timeout, this,
            [this] { post([](LinkWorker& worker) { worker.pulse(); }); });
}

LinkMonitor::~LinkMonitor()
{
    if (!m_thread.isRunning()) { // it was never needed
        delete m_worker;
        return;
    }
    m_thread.quit();
    m_thread.wait();
}

template <class Command>
void LinkMonitor::post(Command command)
{
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, command] { command(*worker); }, Qt::QueuedConnection);
}

void LinkMonitor::begin()
{
    if (!m_thread.isRunning())
        m_thread.start();
    stop();
    m_isListening = true;
    m_status.isListening = true;
    m_pulse.start();
}

void LinkMonitor::listen(const LinkOpener& opener)
{
    begin();
    post([opener](LinkWorker& worker) { worker.open(opener); });
    emit updated();
}

void LinkMonitor::replay(const ReplayOrder& order)
{
    begin();
    m_status.replay = ReplayReport{.path = order.path, .speed = order.speed};
    post([order](LinkWorker& worker) { worker.replay(order); });
    emit updated();
}

void LinkMonitor::setReplaySpeed(double speed)
{
    post([speed](LinkWorker& worker) { worker.setReplaySpeed(speed); });
}

void LinkMonitor::setLogFolder(const QString& folder)
{
    post([folder](LinkWorker& worker) { worker.setLogFolder(folder); });
}

void LinkMonitor::stop()
{
    if (!m_isListening)
        return;
    m_isListening = false;
    m_pulse.stop();
    static_cast<void>(m_statuses.take());
    m_status = {};
    m_tracks.clear();
    post([](LinkWorker& worker) { worker.close(); });
    emit updated();
}

void LinkMonitor::setSending(bool isOn)
{
    post([isOn](LinkWorker& worker) { worker.setSending(isOn); });
}

void LinkMonitor::startSync(LinkAddress vehicle, const std::vector<MissionPart>& parts,
                            MissionSync::Task task)
{
    post([=](LinkWorker& worker) { worker.startSync(vehicle, parts, task); });
}

void LinkMonitor::sendCommand(LinkAddress vehicle, const LinkCommand& command)
{
    post([=](LinkWorker& worker) { worker.sendCommand(vehicle, command); });
}

void LinkMonitor::setData(const std::map<LinkAddress, AircraftData>& data)
{
    post([data](LinkWorker& worker) { worker.setData(data); });
}

const std::vector<LatLon>& LinkMonitor::trackOf(LinkAddress vehicle) const
{
    static const std::vector<LatLon> kNone;
    const auto track = m_tracks.find(vehicle);
    return track == m_tracks.end() ? kNone : track->second;
}

void LinkMonitor::accept()
{
    std::optional<LinkStatus> status = m_statuses.take();
    if (!status || !m_isListening)
        return; // it was sent before the link was closed
    m_status = std::move(*status);
    m_isListening = m_status.isListening; // false after an internal failure
    if (!m_isListening) {
        m_pulse.stop();
        m_tracks.clear();
    }
    extendTracks();
    emit updated();
}

void LinkMonitor::extendTracks()
{
    for (const auto& [vehicle, places] : m_status.places)
        for (const LatLon& place : places) {
            std::vector<LatLon>& track = m_tracks[vehicle];
            if (!track.empty() && greatCircle_m(track.back(), place) < kTrackStep_m)
                continue;
            track.push_back(place);
            if (track.size() <= kMostPlaces)
                continue;
            for (std::size_t i = 0; 2 * i < track.size(); ++i) // every other place
                track[i] = track[2 * i];
            track.resize((track.size() + 1) / 2);
        }
}

} // namespace berg
