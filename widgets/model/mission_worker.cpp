#include "widgets/model/mission_worker.h"

#include "core/io/formats.h"

#include <algorithm>

namespace berg {

namespace {

constexpr int kSlice_ms = 16;
constexpr int kWork_ms = 8; ///< of flying in one slice, so that commands are answered at once

/** A snapshot waits unread: the newer one takes its place but keeps its unseen samples. */
void amend(MissionSnapshot& waiting, MissionSnapshot next)
{
    if (waiting.generation == next.generation &&
        waiting.firstSample + waiting.newSamples.size() == next.firstSample) {
        waiting.newSamples.insert(waiting.newSamples.end(), next.newSamples.begin(),
                                  next.newSamples.end());
        std::move(next.newRows.begin(), next.newRows.end(), std::back_inserter(waiting.newRows));
        next.firstSample = waiting.firstSample;
        next.newSamples = std::move(waiting.newSamples);
        next.newRows = std::move(waiting.newRows);
    }
    waiting = std::move(next);
}

} // namespace

MissionWorker::MissionWorker(Mailbox<MissionRequest>& requests,
                             Mailbox<std::vector<Intervention>>& interventions,
                             Mailbox<MissionSnapshot>& snapshots)
    : m_requests(requests)
    , m_interventions(interventions)
    , m_snapshots(snapshots)
    , m_timer(this) // moves to the thread with its parent
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &MissionWorker::slice);
}

void MissionWorker::start()
{
    std::optional<MissionRequest> request = m_requests.take();
    if (!request)
        return; // an earlier call has taken a newer one
    m_timer.stop();
    m_request = std::move(*request);
    m_mission.reset();
    m_error.reset();
    m_published = 0;
    m_phase = RunPhase::Planning;
    try {
        m_mission = std::make_unique<Mission>(m_request.scenario, m_request.options);
        m_mission->setIncumbentListener([this](const PlanEvent& plan) { publishIncumbent(plan); });
        if (m_mission->advance(0, m_request.stop) == AdvanceStatus::Cancelled)
            return; // a newer request waits
        m_phase = RunPhase::Ready;
        publish();
    } catch (const Error& error) {
        fail(error);
    }
}

void MissionWorker::fly(double rate)
{
    m_rate = rate;
    if (!m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed)
        return;
    m_phase = RunPhase::Flying;
    m_target_s = m_mission->simulation().time_s();
    m_clock.start();
    m_timer.start(rate > 0 ? kSlice_ms : 0);
    publish();
}

void MissionWorker::pause()
{
    if (m_phase != RunPhase::Flying)
        return;
    m_timer.stop();
    m_phase = RunPhase::Paused;
    publish();
}

void MissionWorker::stepBy(double seconds)
{
    m_timer.stop();
    if (!m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed)
        return;
    m_phase = RunPhase::Paused;
    const Simulation& simulation = m_mission->simulation();
    advanceTo(simulation.time_s() + std::max(seconds, simulation.dt_s()));
    publish();
}

void MissionWorker::slice()
{
    if (m_rate <= 0) {
        sliceAsFastAsPossible();
    } else {
        m_target_s += m_rate * static_cast<double>(m_clock.restart()) / 1000;
        const double before_s = m_mission->simulation().time_s();
        // At most the work of one slice: when the machine is too slow the flight is, not the
        // window.
        QElapsedTimer work;
        work.start();
        bool more = true;
        while (more && m_mission->simulation().time_s() < m_target_s && work.elapsed() < kWork_ms)
            more = advanceTo(std::min(m_target_s, m_mission->simulation().time_s() + 1));
        m_target_s = std::min(m_target_s, m_mission->simulation().time_s() + 1);
        if (m_mission->simulation().time_s() == before_s)
            return;
    }
    publish();
}

void MissionWorker::sliceAsFastAsPossible()
{
    QElapsedTimer work;
    work.start();
    while (work.elapsed() < kWork_ms && advanceTo(m_mission->simulation().time_s() + 1)) {
    }
}

bool MissionWorker::advanceTo(double until_s)
{
    try {
        if (m_mission->advance(until_s, m_request.stop) == AdvanceStatus::Reached)
            return true;
        m_timer.stop();
        if (m_mission->simulation().finished())
            m_phase = RunPhase::Finished;
    } catch (const Error& error) {
        fail(error);
    }
    return false;
}

void MissionWorker::intervene()
{
    const std::optional<std::vector<Intervention>> waiting = m_interventions.take();
    if (!waiting || !m_mission || m_phase == RunPhase::Finished || m_phase == RunPhase::Failed)
        return;
    for (const Intervention& intervention : *waiting) {
        try {
            m_mission->intervene(intervention);
        } catch (const Error& error) {
            emit refused(QString::fromUtf8(error.what()));
        }
    }
    advanceTo(m_mission->simulation().time_s()); // plan on the spot
    publish();
}

void MissionWorker::sendRun()
{
    if (m_mission)
        emit runReady(std::make_shared<const RunFile>(runOf(*m_mission)));
}

void MissionWorker::sendExport(const std::string& formatId)
{
    if (!m_mission)
        return;
    try {
        const bool flown = m_phase != RunPhase::Ready;
        const Scenario& scenario = m_mission->scenario();
        const PlanAnswer plan = planFromStart(scenario, {.stop = m_request.stop});
        const ExportFormat* format = findExportFormat(formatId);
        require(format != nullptr, "sendExport: no such format");
        emit exportReady(format->write(
            {.scenario = scenario, .plan = plan, .mission = flown ? m_mission.get() : nullptr}));
    } catch (const Error& error) {
        emit refused(QString::fromUtf8(error.what()));
    }
}

void MissionWorker::fail(const Error& error)
{
    m_timer.stop();
    m_phase = RunPhase::Failed;
    m_error = error;
    publish();
}

void MissionWorker::addHistory(MissionSnapshot& snapshot)
{
    const Recorder& recorder = m_mission->recorder();
    const auto& samples = recorder.samples();
    snapshot.firstSample = m_published;
    for (; m_published < samples.size(); ++m_published) {
        snapshot.newSamples.push_back(samples[m_published]);
        const auto row = recorder.icebergs(m_published);
        snapshot.newRows.emplace_back(row.begin(), row.end());
    }
}

void MissionWorker::publishIncumbent(const PlanEvent& plan)
{
    if (m_phase != RunPhase::Planning)
        return; // in flight the picture is that of the last plan until the next one is made
    MissionSnapshot snapshot = present();
    snapshot.plan = plan;
    if (m_snapshots.put(std::move(snapshot), amend))
        emit published();
}

void MissionWorker::publish()
{
    if (m_snapshots.put(present(), amend))
        emit published();
}

MissionSnapshot MissionWorker::present()
{
    MissionSnapshot snapshot;
    if (m_mission) {
        snapshot = snapshotOf(*m_mission);
        addHistory(snapshot);
    }
    snapshot.generation = m_request.generation;
    snapshot.phase = m_phase;
    snapshot.error = m_error;
    return snapshot;
}

MissionSnapshot snapshotOf(const Mission& mission)
{
    const Simulation& simulation = mission.simulation();
    MissionSnapshot snapshot{.time_s = simulation.time_s(),
                             .world = simulation.state(),
                             .icebergs = mission.icebergs(),
                             .plans = mission.plans(),
                             .events = mission.events(),
                             .planner = mission.plannerSettings(),
                             .metrics = mission.metrics()};
    for (int i = 0; i < simulation.icebergCount(); ++i) {
        snapshot.truth_m.push_back(simulation.truth_m(i));
        snapshot.active.push_back(simulation.active(i));
    }
    if (!snapshot.plans.empty())
        snapshot.plan = snapshot.plans.back();
    return snapshot;
}

} // namespace berg
