#include "widgets/aircraft/rehearsal_fleet.h"

#include "core/link/message/impaired_link.h"
#include "core/link/transport/link_clock.h"
#include "core/link/transport/transport_link.h"
#include "widgets/tasks/work_failure.h"

#include <QTimer>

#include <memory>
#include <utility>

using namespace Qt::StringLiterals;

namespace berg {

namespace {

constexpr int kPeriod_ms = 50;

/** One aircraft with its end of the link. */
struct Rehearsed
{
    Rehearsed(RehearsalOptions options, const LinkEndpoint& station)
        : link(openLink(station)), radio(*link, {}), vehicle(radio, std::move(options))
    {
    }

    std::unique_ptr<TransportLink> link;
    ImpairedLink radio;
    RehearsalVehicle vehicle;
};

} // namespace

class RehearsalFleet::Worker : public QObject
{
public:
    Worker(std::vector<RehearsalOptions> aircraft, int port)
        : m_options(std::move(aircraft)), m_port(port), m_timer(this)
    {
        m_timer.setInterval(kPeriod_ms);
        connect(&m_timer, &QTimer::timeout, this, [this] {
            if (failureOf([this] { advance(); }))
                m_timer.stop();
        });
    }

    void start()
    {
        for (RehearsalOptions& options : m_options)
            m_aircraft.push_back(std::make_unique<Rehearsed>(
                std::move(options),
                LinkEndpoint{.kind = LinkEndpoint::Kind::UdpSend, .port = m_port}));
        m_timer.start();
    }
    void setMode(std::size_t aircraft, std::uint32_t mode)
    {
        m_aircraft.at(aircraft)->vehicle.setMode(mode);
    }
    void setSilent(bool isSilent)
    {
        for (const auto& aircraft : m_aircraft)
            aircraft->radio.setImpairment({.loss = isSilent ? 1.0 : 0});
    }

private:
    void advance()
    {
        const LinkTime now = linkTimeNow();
        for (const auto& aircraft : m_aircraft) {
            aircraft->radio.setTime(now.monotonic_s);
            aircraft->vehicle.advance(now);
            aircraft->radio.setTime(now.monotonic_s); // sends at once
        }
    }

    std::vector<RehearsalOptions> m_options;
    int m_port;
    QTimer m_timer;
    std::vector<std::unique_ptr<Rehearsed>> m_aircraft;
};

RehearsalFleet::RehearsalFleet(std::vector<RehearsalOptions> aircraft, int port)
    : m_worker(new Worker(std::move(aircraft), port))
{
    m_thread.setObjectName(u"rehearsal"_s);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::started, m_worker, [worker = m_worker] { worker->start(); });
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start();
}

RehearsalFleet::~RehearsalFleet()
{
    m_thread.quit();
    m_thread.wait();
}

void RehearsalFleet::setMode(std::size_t aircraft, std::uint32_t mode)
{
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, aircraft, mode] { worker->setMode(aircraft, mode); },
        Qt::QueuedConnection);
}

void RehearsalFleet::setSilent(bool isSilent)
{
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker, isSilent] { worker->setSilent(isSilent); },
        Qt::QueuedConnection);
}

} // namespace berg
